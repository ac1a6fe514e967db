// SPDX-License-Identifier: MIT
#pragma once

// The part of a moment's block that holds its inputs: a head, records, nodes, then the records' words, each 64-byte
// aligned. See moment.c.

#include "core/input/inputs.h"

// Bytes of the inputs that a world has, whatever the time; 0 without any.
size_t swFindStoredInputsSize(const swInputs* inputs);

// Bytes of a set.
size_t swGetStoredInputsSize(const swInputSet* set);

// Write a set to a place. Its arrays take the words that are there from now on.
void swStoreInputs(swInputArrays* arrays, void* place);

// Whether a place holds inputs that can be. `recordCount` is how many.
bool swCheckStoredInputs(const void* place, size_t size, int* recordCount);

// Read what was checked into arrays with room for it.
void swMapStoredInputs(const void* place, swInputArrays* arrays);
