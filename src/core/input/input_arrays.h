// SPDX-License-Identifier: MIT
#pragma once

// Memory of a set of inputs: of a world's, and of a moment's.

#include "core/base/host.h"
#include "core/input/input_index.h"

typedef struct swInputArrays
{
    int capacity;      // of what follows, in inputs
    uint32_t* sources; // slots of the records' inputs
    swInputRecord* records;
    const float** words;
    swInputFunctionFcn* functions;
    void** contexts;
    float *least, *most; // see swFindInputRange()
    swCellBox* boxes;
    swIndexItem* items; // while the index is made; likewise
    swIndexItem* scratch;
    swInputNode* nodes;
    swInputSet set; // points to the others
} swInputArrays;

// Room for so many inputs; what is there stays. False if there is no memory: then nothing has changed.
bool swReserveInputArrays(const swHost* host, swInputArrays* arrays, int count);
void swFreeInputArrays(const swHost* host, swInputArrays* arrays);

// What the set says of its records altogether: reaches of fields, systems with ribbons.
void swFindSetReaches(swInputArrays* arrays);
