// SPDX-License-Identifier: MIT
#pragma once

// From what a host gave to what is evaluated: records, their data and their boxes of cells.

#include "core/frame/input_set.h"
#include "core/input/input_index.h"

// What an input holds beside its def. A new one is made when an input is set; the old one lives until the step after.
typedef struct swInputData
{
    struct swInputData* next; // of those that wait to be freed
    size_t size;              // bytes of this block
    const swRaster* raster;   // held
    const swMesh* mesh;       // held
    const swSpline* spline;   // held
    const swHull* hull;       // held
    int pointCount, pointCapacity;
    swInputPoint* points; // as they were given
    // Words of shapes that have data of their own. There are two so that points may change while the last step's words
    // are read: `next` ones are made in words[1 - shown].
    float* words[2];
    int wordCount[2], wordCapacity;
    int shown;
    bool isNew; // words[1 - shown] count, and are shown with the next step
} swInputData;

// Words that a def's data take at most.
int swCountInputWords(const swInputDef* def);

// The words of points. Returns how many there are.
int swWriteInputWords(const swInputDef* def, int pointCount, const swInputPoint* points, float* words);

// Where a record says anything, in the sea.
void swFindInputArea(const swInputRecord* record, swPosXZ* low, swPosXZ* high);

// The record of an input whose def has its place in the sea, and the cells that it covers.
void swMakeInputRecord(const swInputDef* def, const swInputData* data, double seaLevel, double time,
                       swInputRecord* record, swCellBox* box);

// The data that counts from now on, as swInputSet::words has it; NULL, and a count of 0, if there is none.
const float* swGetInputWords(const swInputData* data, int* count);

// Whether a record that comes from elsewhere names no word that it does not have, and nothing that is unknown.
// Functions are of one process.
bool swIsInputRecordGood(const swInputRecord* record, const float* words);

// Between which numbers the values lie that the shape brings of its own; 0 and 0 of a shape that brings none.
void swFindInputRange(const swInputDef* def, const swInputData* data, float* least, float* most);

// What changes with time alone: false if nothing of the def does.
bool swHasTide(const swInputDef* def);
bool swDoesInputChange(const swInputDef* def);
void swSetInputTime(const swInputDef* def, double time, swInputRecord* record);

// Where a place lies in cells; false where its cells do not fit 32 bits.
bool swFindCell(double place, int32_t* cell, float* rest);
