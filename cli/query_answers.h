// SPDX-License-Identifier: MIT
#pragma once

// What `seaway query` can ask, which numbers each question wants, and its answers as CSV on standard output.

#include "csv_numbers.h"
#include "gpu_answers.h"
#include "query_fields.h"

#define FARTHEST_POINT 1e12 // m from the origin along an axis: as far as the library answers

typedef enum Question
{
    QUESTION_SURFACE,
    QUESTION_MOTION, // and how the particle there moves
    QUESTION_BELOW,  // the water at the points' own heights
    QUESTION_RAYS,
    QUESTION_FIELDS, // what inputs say at the points
    QUESTION_MAP     // heights on a grid; has no points
} Question;

typedef struct Asked
{
    Question question;
    swQueryDef def;
    float maxDistance;  // of rays, m
    swHeightMapDef map; // of QUESTION_MAP
    bool ofParticles;   // the points are where particles rest
    bool withDrift;     // of QUESTION_BELOW: Stokes drift as well
    FieldList fields;   // of QUESTION_FIELDS
    CsvNumbers numbers; // in the question's format
} Asked;

// Who answers; gpu is NULL if the core does. Both are of the world's last step.
typedef struct Source
{
    const swWorld* world;
    GpuAnswers* gpu;
} Source;

// Of the lines that a question wants.
const CsvFormat* GetQuestionFormat(Question question);

// The GPU counts cells from the first point in 32 bits. Complains about points too far out for it.
bool AreWithinGpuReach(const Asked* asked);

// Of a GPU that can answer.
swGpuQueryDef MakeGpuDef(const Asked* asked);

void PrintHeading(const Asked* asked);

// A row for each line of the input, in its order, at the world's time. Complains.
bool PrintAnswers(const Source* source, const Asked* asked);
