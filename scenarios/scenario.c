// SPDX-License-Identifier: MIT
#include "scenarios/scenario.h"

const char* ScenarioName(ScenarioKind kind)
{
    static const char* const names[SCENARIO_COUNT] = {"calm", "breeze", "gale"};
    return names[kind];
}

ScenarioDef DefaultScenarioDef(ScenarioKind kind)
{
    return (ScenarioDef){
        .kind = kind,
        .host = swDefaultHost(),
        .threadCount = 1,
        .isa = SW_ISA_BEST,
        .resolution = 128,
        .chop = 1.0f,
        .seed = 1,
    };
}

static swResult AddSystem(Scenario* scenario, const swWaveSystemDef* def)
{
    swResult result = swCreateWaveSystem(scenario->world, def, &scenario->systems[scenario->systemCount]);
    scenario->systemCount += result == SW_SUCCESS ? 1 : 0;
    return result;
}

static swWaveSystemDef MakeSystemDef(const ScenarioDef* def)
{
    swWaveSystemDef system = swDefaultWaveSystemDef();
    system.resolution = def->resolution;
    system.tileWaves = def->resolution / 4;
    system.chop = def->chop;
    system.seed = def->seed;
    return system;
}

static swResult AddBreeze(Scenario* scenario, const ScenarioDef* def)
{
    swWaveSystemDef system = MakeSystemDef(def);
    return AddSystem(scenario, &system);
}

static swResult AddGale(Scenario* scenario, const ScenarioDef* def)
{
    swWaveSystemDef sea = MakeSystemDef(def);
    sea.spectrum.windSpeed = 20.0f;
    sea.spectrum.fetch = 200e3f;
    swResult result = AddSystem(scenario, &sea);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swWaveSystemDef swell = MakeSystemDef(def);
    swell.spectrum.significantHeight = 2.0f;
    swell.spectrum.peakPeriod = 15.0f;
    swell.spectrum.direction = 1.2f;
    swell.spectrum.spreadExponent = 75.0f;
    swell.minWavelength = 64.0f;
    swell.seed = def->seed + 1000;
    return AddSystem(scenario, &swell);
}

static swResult FillWorld(Scenario* scenario, const ScenarioDef* def)
{
    switch (def->kind)
    {
    case SCENARIO_BREEZE:
        return AddBreeze(scenario, def);
    case SCENARIO_GALE:
        return AddGale(scenario, def);
    default:
        return SW_SUCCESS;
    }
}

swResult CreateScenario(const ScenarioDef* def, Scenario* scenario)
{
    *scenario = (Scenario){0};
    swHost host = def->host;
    swResult result = SW_SUCCESS;
    if (def->threadCount > 1)
    {
        result = swCreateTaskPool(&host, def->threadCount - 1, &scenario->pool);
    }
    if (scenario->pool != NULL)
    {
        swTaskPool_Attach(scenario->pool, &host);
    }
    swWorldDef world = swDefaultWorldDef();
    world.enableVelocity = def->enableMotion;
    world.enableAcceleration = def->enableMotion;
    world.isa = def->isa;
    result = result == SW_SUCCESS ? swCreateWorld(&host, &world, &scenario->world) : result;
    result = result == SW_SUCCESS ? FillWorld(scenario, def) : result;
    result = result == SW_SUCCESS ? swWorld_Step(scenario->world, 0.0) : result;
    if (result != SW_SUCCESS)
    {
        DestroyScenario(scenario);
    }
    return result;
}

void DestroyScenario(Scenario* scenario)
{
    swDestroyWorld(scenario->world);
    swDestroyTaskPool(scenario->pool);
    *scenario = (Scenario){0};
}

void StepScenario(Scenario* scenario, int count)
{
    for (int i = 0; i < count; ++i)
    {
        swWorld_Step(scenario->world, 1.0 / 60.0);
    }
}
