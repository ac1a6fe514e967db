// SPDX-License-Identifier: MIT
#pragma once

// What is looked at: a scene file made into a world, its view, and their twins on the GPU, with every setting that the
// panel may turn.

#include "seaway/query.h"
#include "seaway/scene.h"

typedef struct SeaWaves
{
    swWaveSystemId id;
    swWaveSystemDef def;           // as the panel has it; the world follows with ApplyChanges()
    swWaveComponent* components;   // waves by hand, a copy that the panel may change; NULL if there are none
    const swMeasuredSea* measured; // NULL for formulas; belongs to the scene
    int record;
    const char* file;    // of the measured spectrum, or empty
    swSeaReplay* replay; // NULL: one record stays
    swSeaReplayDef replayDef;
    int records[2]; // that the replay is between, and what they hold
    swSeaState recorded[2];
    swSeaState asked; // what the spectrum holds, at weight 1; of waves by hand only the height
    bool hasChanged;  // since the world had it
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
    float transition;  // s of the sea that a change of its waves takes
    double nextChange; // when the next one may begin, s of the sea

    swWorld* world;
    swView* view;
    swGpuWorld* gpuWorld;
    swRenderer* renderer;
} Sea;

// Read and build; `path` NULL is an open sea. Reasons for failing go to the host's log, and `sea` is then empty.
bool OpenSea(Sea* sea, const swHost* host, swGpu* gpu, const char* path);

// The device must be idle.
void CloseSea(Sea* sea);

// Let the world's waves run to the settings that changed. Changes that come faster than a part of the transition wait
// their turn: a world cross-fades three of them at most. `isPaused`: at once, since time does not run. If the world refuses,
// the host's log says why and the settings are those of the world again.
void ApplyChanges(Sea* sea, bool isPaused);

// Set replays to a time, before the step to it.
bool AdvanceSea(Sea* sea, double time);

// Let a replay run at another speed from now on, or from another moment of its records.
void ChangeReplay(Sea* sea, int index, double seconds, double speed);

// UTC in seconds since 1970 that a replay has reached.
double GetReplaySeconds(const Sea* sea, int index);

// Significant height asked for by all systems together, and what their bands carry, m.
float GetAskedHeight(const Sea* sea);
float GetCarriedHeight(const Sea* sea);
