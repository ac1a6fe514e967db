// SPDX-License-Identifier: MIT
#pragma once

// Measures the directional spectrum of a world as a camera over the sea would: the surface over squares, a few times in
// a row, octave of wavelength by octave. What buoys tell of directions is four moments; this tells the distribution.

#include <stdbool.h>

#include "seaway/seaway.h"

#define PATCH_SIDE 128 // samples along a square
#define PATCH_TIMES 8

// Sums over patches: energy by wave number, in the direction where waves go.
typedef struct SeaPatches
{
    int first, count; // octaves: o holds wavelengths [2^(o - 4), 2^(o - 3)) m, as bands do
    double weight;    // squares summed
    double* power;    // [count][PATCH_SIDE][PATCH_SIDE] by kz, kx, in the order of the transform; m^4
} SeaPatches;

// All zero, for the octaves that hold waves between these lengths, m. Returns false without memory.
bool CreatePatches(double shortest, double longest, SeaPatches* patches);
void DestroyPatches(SeaPatches* patches);

// Add squares of every octave, around a place of their own for each `index`. Steps the world from `begin` on; `depth`
// tells how long the waves' periods are. Returns false if a step or memory failed.
bool LookAtPatches(swWorld* world, double begin, double depth, int index, SeaPatches* patches);

void AddPatches(const SeaPatches* from, SeaPatches* to);

// S(f, theta), m^2/Hz/rad, of waves that go to theta; 0 outside the octaves.
double FindPatchDensity(const SeaPatches* patches, double frequency, double theta, double depth, double gravity);
