// SPDX-License-Identifier: MIT
#pragma once

// Owns the modules and orders them. Memory is allocated when something is created or changed, never in a step: a new
// wave system brings its tiles, a new view its layers. What a step leaves (the frame) stays valid until the next one.

#include "core/base/id_pool.h"
#include "core/base/memory.h"
#include "core/base/stream.h"
#include "core/frame/frame.h"
#include "core/input/inputs_save.h"
#include "core/input/water_bodies.h"
#include "core/input/wind.h"
#include "core/lod/layer_stack.h"
#include "core/sim/whitecaps.h"
#include "core/waves/waves.h"
#include "core/world/moment.h"

// Farthest that a viewpoint may be from the host's origin, m.
#define SW_FARTHEST_VIEWPOINT 1e12

struct swView
{
    swWorld* world;
    swViewDef def;
    uint32_t version;
    swPos viewpoint; // in the sea: the host's place plus the world's origin
    swLayerStack layers;
};

typedef struct swZone swZone; // zone.h

struct swWorld
{
    swHost host; // the caller's
    swMemory memory;
    swWorldDef def;
    const swWaveKernels* kernels;

    double time;    // from which the next step goes on
    swPosXZ origin; // of the host's coordinates, in the sea

    swIdPool systemIds; // of the slots of the waves' systems
    swWaves waves;
    swWhitecaps whitecaps;
    swInputs inputs;
    swWaterBodies waterBodies;
    swWind wind;

    swView* views[SW_MAX_VIEWS];
    int viewCount;
    uint32_t viewVersion; // grows with every view
    swViewFrame viewFrames[SW_MAX_VIEWS];

    swZone* zones[SW_MAX_ZONES];
    int zoneCount;
    uint32_t zoneVersion; // grows with every zone
    swZoneFrame zoneFrames[SW_MAX_ZONES];

    swFrame frame;
    swMoment moment; // of the frame
};

// world.c
swResult swMakeWorld(const swHost* host, const swWorldDef* def, const swWaveKernels* kernels, swWorld** world);
void swFreeWorld(swWorld* world);
swResult swCreateSystem(swWorld* world, const swWaveSystemDef* def, swId* id);
void swDestroySystem(swWorld* world, swId id);

// world_wind.c: the world's wind, and the systems that take it, known by their slots.
swResult swChangeWorldWind(swWorld* world, const swWindDef* def, double seconds);
void swDeriveWorldWind(swWorld* world);
swResult swAddWorldSystem(swWorld* world, int slot, const swWaveSystemDef* def);
swResult swChangeWorldSystem(swWorld* world, int slot, const swWaveSystemDef* def, double seconds);
swWaveSystemDef swGetWorldSystemDef(const swWorld* world, int slot); // what was asked for last

// world_def.c and view_def.c: what defs must hold; SW_ERROR_INVALID and a sentence in the log otherwise.
extern const char* const swIsaWords[SW_ISA_COUNT + 1]; // ends with NULL
extern const swFields swWorldFields;
extern const swFields swViewFields;
swResult swCheckViewDef(const swHost* host, const swViewDef* def, bool hasQueries);

// view.c
// Memory for the authored layers of all views, which they have once there are inputs.
swResult swMakeViewFields(swWorld* world);
swResult swAddView(swWorld* world, const swViewDef* def, swView** view);
void swRemoveView(swView* view);
swLayerStack swDescribeViewLayers(const swViewDef* def); // without texels yet
void swStepViews(swWorld* world, int64_t elapsedTicks);  // viewpoints to the frame's views, then their layers
// The frame's views as a step left them that saw them at these places. Views made since come last and have no past:
// their first step is still to come.
void swDeriveViews(swWorld* world, const swPos places[SW_MAX_VIEWS]);
swViewFrame* swFindViewFrame(const swView* view); // NULL before its first step

// layer_makers.c
void swPlanLayers(const swWorld* world, const swLayerStack* layers, swStackFrame* stack);
void swMakeFrameLayers(const swWorld* world, swLayerStack* layers, swStackFrame* stack);

// step.c: a step advances what has a past, and derives the water of its time, which has none.
uint32_t swFindLocalSystems(const swWorld* world); // as swInputSet has them
void swSetFrameTime(swWorld* world, double time, double dt);
void swDeriveWater(swWorld* world);
void swStepWorld(swWorld* world, double dt);
void swStepWorldTo(swWorld* world, double time);

// save.c
swResult swStreamState(swWorld* world, swStream* stream, const swRestoreDef* find); // everything but the def
swResult swRewindState(swWorld* world, swStream* stream); // the same, read into a world that has all of the waves

// digest.c
uint64_t swHashWorld(const swWorld* world);
