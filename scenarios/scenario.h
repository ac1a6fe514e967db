// SPDX-License-Identifier: MIT
#pragma once

// Small worlds that tests, benchmarks and the viewer share, so that what is timed is what is tested.

#include <seaway/seaway.h>

typedef enum ScenarioKind
{
    SCENARIO_CALM,   // no waves at all
    SCENARIO_BREEZE, // the default sea: JONSWAP, 10 m/s over 300 km, Hs 3.9 m, 14 bands
    SCENARIO_GALE,   // JONSWAP, 20 m/s over 200 km, on a swell of 2 m from another direction
    SCENARIO_COUNT
} ScenarioKind;

// Must be initialized with DefaultScenarioDef().
typedef struct ScenarioDef
{
    ScenarioKind kind;
    swHost host;
    int threadCount; // 1: everything on the caller; above: a pool is made
    swIsa isa;
    int resolution; // of the tiles
    float chop;
    uint32_t seed;
    bool enableMotion; // velocities and accelerations beside displacements. Default false
} ScenarioDef;

typedef struct Scenario
{
    swTaskPool* pool; // NULL with one thread
    swWorld* world;
    int systemCount;
    swWaveSystemId systems[2];
} Scenario;

const char* ScenarioName(ScenarioKind kind);
ScenarioDef DefaultScenarioDef(ScenarioKind kind);

// Makes the world and takes a step of 0 s. On failure everything is destroyed again.
swResult CreateScenario(const ScenarioDef* def, Scenario* scenario);
void DestroyScenario(Scenario* scenario);

// Steps of 1/60 s.
void StepScenario(Scenario* scenario, int count);
