// SPDX-License-Identifier: MIT
#pragma once

// What parity tests share: a world on the CPU with its layers, its twin on the GPU, and the difference between two
// arrays.

#include "support/cmocka_setup.h"

#include "gpu/pass/passes.h"
#include "gpu/record/record.h"
#include "scenarios/scenario.h"

// One device for all tests of a program, with the validation layers where they are installed.
// The name of the device is printed.
int OpenParityGpu(void** state);
int OpenParityGpuWith(void** state, swLayerSource layers);
// Fails if the validation layers said anything.
int CloseParityGpu(void** state);

typedef struct Parity
{
    swGpu* gpu;
    swTaskPool* pool;
    swWorld* world;
    swView* view; // NULL unless AddParityView() was called
    int sliceCount, resolution;
    swGpuWorld* gpuWorld;
    uint64_t frameIndex;
} Parity;

// An empty world and its twin.
Parity MakeParity(void** state);
Parity MakeParityOf(void** state, const swWorldDef* def);
void AddParitySea(Parity* parity, const swWaveSystemDef* def);
void AddParityView(Parity* parity, int sliceCount, int resolution, swPos viewpoint);
void FreeParity(Parity* parity);

// Step the world, record the frame, submit it and wait.
void StepParity(Parity* parity, double dt);

typedef struct Difference
{
    double worst; // largest absolute difference
    double rms;
    double scale; // root mean square of the reference
} Difference;

// Over `count` elements of `channels` values each; channels from `compared` on are left out.
Difference Compare(const float* a, const float* b, size_t count, int channels, int compared);
// The larger of both, element by element.
Difference MaxDifference(Difference a, Difference b);

// All slices of a layer against the CPU's.
Difference CompareLayer(Parity* parity, swLayer layer);

void PrintDifference(const char* what, Difference difference, const char* unit);
