// SPDX-License-Identifier: MIT
#pragma once

// What is looked at: a scene file made into a world, its view, and their twins on the GPU, with every setting that the
// panel may turn.

#include "seaway/query.h"
#include "seaway/scene.h"

typedef struct SeaWaves
{
    swWaveSystemId id;
    swWaveSystemDef def;
    const swMeasuredSea* measured; // NULL for formulas; belongs to the scene
    int record;
    const char* file; // of the measured spectrum, or empty
    swSeaState asked; // what the spectrum holds, at weight 1
} SeaWaves;

typedef struct Sea
{
    const swHost* host;
    swGpu* gpu;

    swScene* scene; // NULL: the open sea that needs no file
    char name[128];
    swWorldDef worldDef;
    swSkyDef sky;
    swWaterDef water;
    float exposureEv;
    int wavesCount;
    SeaWaves waves[SW_MAX_WAVE_SYSTEMS];

    swWorld* world;
    swView* view;
    swGpuWorld* gpuWorld;
    swRenderer* renderer;
} Sea;

// Read and build; `path` NULL is an open sea. Reasons for failing go to the host's log, and `sea` is then empty.
bool OpenSea(Sea* sea, const swHost* host, swGpu* gpu, const char* path);

// The device must be idle.
void CloseSea(Sea* sea);

// Give a wave system other settings. If the world refuses, the host's log says why and the waves stay as they were.
bool ChangeWaves(Sea* sea, int index, const swWaveSystemDef* def, int record);

// Significant height asked for by all systems together, and what their bands carry, m.
float GetAskedHeight(const Sea* sea);
float GetCarriedHeight(const Sea* sea);
