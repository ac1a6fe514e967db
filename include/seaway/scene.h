// SPDX-License-Identifier: MIT
#pragma once

#include "draw.h"
#include "seaway.h"

/// @file
/// Scene files (YAML, see docs/scenes.md). A companion library: links libyaml and zlib.

#define SW_MAX_SCENE_VIEWS 32

/// A named viewpoint.
typedef struct swSceneView
{
    char name[64];
    swPos position;     ///< y is above sea level
    float heading;      ///< radians clockwise from north
    float pitch;        ///< radians, up positive
    float roll;         ///< radians
    float verticalFov;  ///< radians
    bool hasSun;        ///< this view has a sun of its own, instead of the scene's
    float sunAzimuth;   ///< radians clockwise from north
    float sunElevation; ///< radians
} swSceneView;

/// One wave system of a scene; it owns what was measured or given by hand.
typedef struct swSceneWaves
{
    swWaveSystemDef def;
    swWaveComponent* components; ///< waves given by hand, def.components points here; NULL if there are none
    int componentCount;
    swMeasuredSea* measured; ///< NULL for formulas
    int record;              ///< which record of it; of a replay the nearest at the scene's time
    swSpectrumTable table;   ///< that record's; def.spectrum.table points here
    char file[512];          ///< the spectrum file, the first of several, or empty
    bool isReplay;           ///< the records play one after another
    swSeaReplayDef replay;   ///< how, if they do; but its waves are `def`
} swSceneWaves;

/// A scene file, read. Its wave systems point into it: do not copy it.
typedef struct swScene
{
    char name[128];
    double time; ///< s
    swWorldDef world;
    swViewDef view;
    swSkyDef sky;
    swWaterDef water;
    float exposureEv;
    int wavesCount;
    swSceneWaves waves[SW_MAX_WAVE_SYSTEMS];
    int viewCount;
    swSceneView views[SW_MAX_SCENE_VIEWS];
    swHost host; ///< who gave the memory
} swScene;

/// Read a scene file. Relative paths in it are relative to the file.
/// @return SW_ERROR_FILE, SW_ERROR_FORMAT (file, line and remedy in the host's log), SW_ERROR_NO_MEMORY
SW_API swResult swReadScene(const swHost* host, const char* path, swScene** scene);

/// The same from memory; `name` stands in messages, relative paths are relative to `folder`.
SW_API swResult swReadSceneText(const swHost* host, const char* text, size_t size, const char* name, const char* folder,
                                swScene** scene);

/// NULL is allowed.
SW_API void swDestroyScene(swScene* scene);

/// View by name; NULL name: the first. NULL if there is none.
SW_API const swSceneView* swScene_FindView(const swScene* scene, const char* name);

/// The scene's sky as a view sees it: with the view's own sun if it has one. NULL view: the scene's.
SW_API swSkyDef swScene_GetSky(const swScene* scene, const swSceneView* view);

/// The wave systems of a scene in a world, in the scene's order, and what drives those that are replayed.
typedef struct swSceneSea
{
    int systemCount;
    swWaveSystemId systems[SW_MAX_WAVE_SYSTEMS];
    swSeaReplay* replays[SW_MAX_WAVE_SYSTEMS]; ///< NULL where nothing is replayed
} swSceneSea;

/// Add the scene's wave systems to a world; replays begin at the world's present time. The scene has to outlive the
/// sea.
/// @return what swCreateWaveSystem() and swCreateSeaReplay() return; the world is then as it was
SW_API swResult swCreateSceneSea(swWorld* world, const swScene* scene, swSceneSea* sea);

/// Set replayed systems to a time; call it before each step to that time. Does nothing for a scene without replays.
/// @return as swSeaReplay_Advance()
SW_API swResult swSceneSea_Advance(swSceneSea* sea, double time);

/// Stop the replays, while the world is still there. The wave systems stay as they are. NULL is allowed.
SW_API void swDestroySceneSea(swSceneSea* sea);

/// Create a world with the scene's wave systems and step it to the scene's time.
/// @return what swCreateWorld(), swCreateSceneSea() and swWorld_Step() return
SW_API swResult swOpenScene(const swHost* host, const swScene* scene, swWorld** world, swSceneSea* sea);

/// The same without what drives replays: they stand still at the scene's time.
SW_API swResult swCreateSceneWorld(const swHost* host, const swScene* scene, swWorld** world);
