// SPDX-License-Identifier: MIT
#pragma once

#include "draw.h"
#include "field.h"
#include "files.h"
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
    int item;           ///< which of the file's views it is, from 1 on; 0: the file has it not yet
    int line;           ///< of the file, where it begins; 0: none
} swSceneView;

/// Twenty metres above the water, northward.
SW_API swSceneView swDefaultSceneView(void);

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
    int item;                ///< which of the file's wave systems it is, from 1 on; 0: the file has it not yet
    int line;                ///< of the file, where it begins; 0: none
} swSceneWaves;

/// Rasters, and splines, that a scene can name, and inputs that it can have.
#define SW_MAX_SCENE_RESOURCES 256
#define SW_MAX_SCENE_INPUTS 4096

/// Numbers that a cell of a scene's raster can have.
#define SW_MAX_SCENE_CHANNELS 4

/// A raster that inputs of the scene name: a file, or a made-up island. The scene owns it.
typedef struct swSceneRaster
{
    char name[64];
    char file[512];     ///< relative to the scene's folder
    char madeFrom[512]; ///< the scene whose floor it was baked from, relative to the folder; empty: none is known
    char variable[64];  ///< of def.variable; empty: NULL
    int channelCount;   ///< of a raster of several channels, one after another: their files, or their variables; or 0
    char files[SW_MAX_SCENE_CHANNELS][512];
    char variables[SW_MAX_SCENE_CHANNELS][64];
    int frames;          ///< lattices of the same size that stand below each other in the file
    bool isOptional;     ///< a file that is not there leaves out the inputs that name it, with a warning
    swRasterFileDef def; ///< how the file was read
    bool isIsland;       ///< made of `island` instead of a file
    swIslandDef island;
    swRaster* raster; ///< NULL until it is read, and of an optional file that is not there
    int item;         ///< which of the file's rasters it is, from 1 on
    int line;         ///< of the file, where it begins; 0: none
} swSceneRaster;

/// A mesh that inputs of the scene name. The scene owns it.
typedef struct swSceneMesh
{
    char name[64];
    char file[512];    ///< relative to the scene's folder
    swMeshFileDef def; ///< how the file was read
    swMesh* mesh;      ///< NULL until it is read
    int item;          ///< which of the file's meshes it is, from 1 on
    int line;          ///< of the file, where it begins; 0: none
} swSceneMesh;

/// A hull that inputs of the scene name: the inside of a closed mesh. The scene owns it.
typedef struct swSceneHull
{
    char name[64];
    char file[512];    ///< relative to the scene's folder
    swMeshFileDef def; ///< how the file was read
    int resolution;    ///< see swHullDef
    swHull* hull;      ///< NULL until it is made
    int item;          ///< which of the file's hulls it is, from 1 on
    int line;          ///< of the file, where it begins; 0: none
} swSceneHull;

/// A spline that inputs of the scene name. The scene owns it.
typedef struct swSceneSpline
{
    char name[64];
    swSplineDef def; ///< its name is the scene's, its points are `points`
    swSplinePoint* points;
    int pointCount;
    swSpline* spline; ///< NULL until it is made
    int item;         ///< which of the file's splines it is, from 1 on
    int line;         ///< of the file, where it begins; 0: none
} swSceneSpline;

/// Points of a path, and lines of a tide table.
#define SW_MAX_SCENE_PATH 4096
#define SW_MAX_SCENE_TIDE 65536

/// Where something that follows a path is at a time.
typedef struct swScenePathPoint
{
    double time;     ///< s, counted from swSceneMotion::startTime
    swVec3 moved;    ///< from its place, m
    swAngles turned; ///< beside its own turn, radians
} swScenePathPoint;

/// How an input of a scene moves: a function of time, the same on every machine. What its parts give adds up, from the
/// place and turn of the input's def on.
typedef struct swSceneMotion
{
    double startTime;       ///< s of the sea; it stands before
    swVec3 velocity;        ///< along the world's axes, m/s
    swAngles turnRate;      ///< of yaw, pitch and roll, radians/s
    float orbitRadius;      ///< of a circle around its place, m; 0: none
    float orbitPeriod;      ///< s for a turn of it, from +x towards +z; below 0 the other way round
    float orbitPhase;       ///< where on the circle it sets out, radians from +x towards +z
    bool isSmooth;          ///< it comes to rest at each point of the path instead of running evenly between them
    bool loops;             ///< the path begins anew behind its last point; else it rests there
    int pathCount;          ///< 0: no path
    swScenePathPoint* path; ///< in ascending times; the scene's
} swSceneMotion;

/// A tide by a table, see swGetTideOfTable(): of a level, or of a flow along x and along z.
typedef struct swSceneTide
{
    int count;           ///< 0: none
    swTideLevel* along;  ///< of a level, m, or of a flow along x, m/s; the scene's
    swTideLevel* across; ///< of a flow along z; NULL of a level
} swSceneTide;

/// An input of a scene. Its system is that of the scene's waves, see `waves`; what it names is the scene's.
typedef struct swSceneInput
{
    swInputDef def;
    int waves;            ///< index of the scene's waves that it weighs; -1: all
    int resource;         ///< index of the raster, mesh, hull or spline that its shape names; -1: none
    bool isLeftOut;       ///< its raster is an optional file that is not there, or its waves were removed
    bool hasLostWaves;    ///< its waves were removed: it is no longer written either
    swInputPoint* points; ///< def.points points here; NULL if there are none
    int pointCount;
    const swRaster** nest; ///< rasters of a nest, see swCreateNest(); NULL if it is none
    int nestCount;         ///< those that are there
    swSceneMotion motion;  ///< see swSceneInput_GetPlace()
    swSceneTide tide;      ///< by a table; see swSceneInput_GetValue()
    int item;              ///< which of the file's inputs it is, from 1 on
    int line;              ///< of the file, where it begins; 0: none
} swSceneInput;

/// A body of water of a scene.
typedef struct swSceneWaterBody
{
    swWaterBodyDef def;
    int waves;      ///< index of the scene's waves that it has; -1: none of its own
    swVec2* points; ///< def.points points here
    int pointCount;
    swSceneTide tide; ///< by a table; see swSceneWaterBody_GetLevel()
    int item;         ///< which of the file's bodies of water it is, from 1 on
    int line;         ///< of the file, where it begins; 0: none
} swSceneWaterBody;

/// A sea by a map of the wind, see swCreateWindSea(). The scene owns it.
typedef struct swSceneWindSea
{
    swWindSeaDef def;    ///< its raster is the scene's, its waves are those of `waves`
    swSceneWaves* waves; ///< what its systems have in common
    bool isLeftOut;      ///< its raster is an optional file that is not there
    int item;            ///< which of the file's it is, from 1 on
    int line;            ///< of the file, where it begins; 0: none
} swSceneWindSea;

/// Other waters that a scene can have, see swWaterBodyDef::look.
#define SW_MAX_SCENE_LOOKS 255

/// The text that a scene was read from.
typedef struct swSceneSource swSceneSource;

/// A scene file, read. Its wave systems point into it: do not copy it. Its values may be changed, and written back to
/// the file with swWriteScene().
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
    int rasterCount;
    swSceneRaster* rasters;
    int meshCount;
    swSceneMesh* meshes;
    int hullCount;
    swSceneHull* hulls;
    int splineCount;
    swSceneSpline* splines;
    int lookCount;
    swWaterDef* looks; ///< of bodies of water, for swShot::bodyWaters
    int waterBodyCount;
    swSceneWaterBody* waterBodies;
    int inputCount;
    swSceneInput* inputs;
    int windSeaCount;
    swSceneWindSea* windSeas;
    swHost host;           ///< who gave the memory
    swSceneSource* source; ///< what it was read from
} swScene;

/// Tables of a scene's own values and of a view's, see field.h. The other values are those of their defs.
SW_API const swFields* swGetSceneFields(void);
SW_API const swFields* swGetSceneViewFields(void);

/// A scene with nothing but defaults, no waves and no views, to be filled and written.
/// @return SW_ERROR_NO_MEMORY
SW_API swResult swCreateScene(const swHost* host, swScene** scene);

/// Read a scene file. Relative paths in it are relative to the file.
/// @return SW_ERROR_FILE, SW_ERROR_FORMAT (file, line and remedy in the host's log), SW_ERROR_NO_MEMORY
SW_API swResult swReadScene(const swHost* host, const char* path, swScene** scene);

/// The same from memory; `name` stands in messages, relative paths are relative to `folder`.
SW_API swResult swReadSceneText(const swHost* host, const char* text, size_t size, const char* name, const char* folder,
                                swScene** scene);

/// NULL is allowed.
SW_API void swDestroyScene(swScene* scene);

/// Fastest that an input goes by its motion, m/s: along, on its orbit and along its path together.
SW_API float swSceneMotion_GetSpeed(const swSceneMotion* motion);

/// Table of the keys of an input's points.
SW_API const swFields* swGetInputPointFields(void);

/// Tables of keys of what moves.
SW_API const swFields* swGetSceneMotionFields(void);
SW_API const swFields* swGetScenePathFields(void);

/// @name Changing a scene
/// Plain values are changed where they stand: scene->sky.haze, scene->waves[i].def.chop, scene->waves[i].record,
/// scene->views[i].pitch, and of inputs and bodies of water what their defs' tables have under a key, their tides, and
/// the numbers of the points that they have. What comes and goes has functions. The scene's seas, if there are any, do
/// not follow; do not remove waves that a swSceneSea replays.
/// @{

/// Add a wave system behind the others: a formula, an equaliser, or waves given by hand, which are copied. A table is
/// no part of scene files: name the file that holds it in the scene.
/// @return SW_ERROR_INVALID if the def is outside its ranges, SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT
SW_API swResult swScene_AddWaves(swScene* scene, const swWaveSystemDef* def);

/// Let a wave system be of another def. Waves given by hand are copied; a measured sea stays as it is.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY
SW_API swResult swScene_SetWaves(swScene* scene, int index, const swWaveSystemDef* def);

/// Remove a wave system; those behind it move up, and the numbers that inputs and bodies of water name waves by follow.
/// An input of the removed waves is left out, also of what is written, and a body of water that had them has none of
/// its own.
SW_API void swScene_RemoveWaves(swScene* scene, int index);

/// Add an input behind the others; its points are copied. A raster, a mesh, a hull or a spline is one of the scene's.
/// @param waves index of the scene's waves that it weighs; -1: all
/// @return SW_ERROR_INVALID if the def is outside its ranges or names what the scene does not have,
/// SW_ERROR_UNSUPPORTED for a function, which no file can hold, SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT
SW_API swResult swScene_AddInput(swScene* scene, const swInputDef* def, int waves);

/// Other points for an input, which are copied.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY; then it has the old ones
SW_API swResult swScene_SetInputPoints(swScene* scene, int index, int count, const swInputPoint* points);

/// Another shore for a body of water, which is copied.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY; then it has the old one
SW_API swResult swScene_SetShore(swScene* scene, int index, int count, const swVec2* points);

/// Remove an input; those behind it move up.
SW_API void swScene_RemoveInput(swScene* scene, int index);

/// Add a viewpoint behind the others; it needs a name that no other has.
/// @return SW_ERROR_INVALID, SW_ERROR_LIMIT
SW_API swResult swScene_AddView(swScene* scene, const swSceneView* view);

/// Remove a viewpoint; those behind it move up.
SW_API void swScene_RemoveView(swScene* scene, int index);

/// @}

/// The scene as the text of a scene file: the text that it was read from, in which only what was changed since is
/// changed. Comments, order, quotes and line ends stay. A value that a key of the file tells is written there; others
/// come behind those that stand there, and only where they differ from the default. The text is read again to see that
/// it says the same.
/// @param text room for `*size` bytes; NULL to ask for the size. No zero is added
/// @param size in: bytes of room; out: bytes needed
/// @return SW_ERROR_LIMIT if there is too little room; SW_ERROR_FORMAT, with line and remedy in the host's log, if the
/// text cannot be changed so: values that & and * share between two places, items in another order; SW_ERROR_INVALID if
/// a value is outside its range; SW_ERROR_NO_MEMORY
SW_API swResult swPrintScene(const swScene* scene, char* text, size_t* size);

/// Write the scene to a file as swPrintScene() has it, and go on from there: the scene counts as read from that text.
/// The file is replaced when all of the new one is on the disk, so that nothing is lost if it fails. A scene that was
/// read from this file is refused if the file has changed since; so is one that names a spectrum file relative to its
/// folder which is not there from the new path.
/// @return what swPrintScene() returns, and SW_ERROR_FILE
SW_API swResult swWriteScene(swScene* scene, const char* path);

/// View by name; NULL name: the first. NULL if there is none.
SW_API const swSceneView* swScene_FindView(const swScene* scene, const char* name);

/// The scene's sky as a view sees it: with the view's own sun if it has one. NULL view: the scene's.
SW_API swSkyDef swScene_GetSky(const swScene* scene, const swSceneView* view);

/// Something that a scene is rarely meant to be. docs/checks.md lists all.
typedef struct swSceneRemark
{
    const char* code;    ///< stays the same when sentences change
    swLogLevel severity; ///< SW_LOG_WARNING or SW_LOG_INFO
    int line;            ///< of the file; its first of what is missing in the whole scene; 0: read from no text
    char text[512];      ///< what is found, and what helps
} swSceneRemark;

/// Look for what a scene is rarely meant to be: no views, waves that are nowhere, inputs that say nothing, and the
/// like.
/// @param world that the scene was opened as, for what only a world can tell; may be NULL
/// @param remarks room for `capacity`
/// @return how many there are, also if there is room for fewer
SW_API int swScene_Check(const swScene* scene, const swWorld* world, int capacity, swSceneRemark* remarks);

/// The wave systems, bodies of water and inputs of a scene in a world, in the scene's order, and what drives waves that
/// are replayed.
typedef struct swSceneSea
{
    int systemCount;
    swWaveSystemId systems[SW_MAX_WAVE_SYSTEMS];
    swSeaReplay* replays[SW_MAX_WAVE_SYSTEMS]; ///< NULL where nothing is replayed
    int inputCount;
    swInputId* inputs; ///< in the scene's order; null handles of those that are left out. NULL if there are none
    int nestedCount;
    swInputId* nested; ///< inputs of nests but the first of each, which stands among `inputs`
    int waterBodyCount;
    swWaterBodyId* waterBodies; ///< in the scene's order; NULL if there are none
    int windSeaCount;
    swWindSea* windSeas; ///< in the scene's order; NULL if there are none
    int inputRoom, nestedRoom, waterBodyRoom, windSeaRoom;
    swWorld* world;       ///< that they are in
    const swScene* scene; ///< that they are of
    swPosXZ origin;       ///< of the world when they were made: the scene's coordinates are those
    swHost host;          ///< who gave the memory of inputs and bodies
} swSceneSea;

/// Add the scene's wave systems, bodies of water and inputs to a world; replays begin at the world's present time. The
/// scene has to outlive the sea.
/// @return what swCreateWaveSystem(), swCreateSeaReplay() and swCreateInput() return; the world is then as it was
SW_API swResult swCreateSceneSea(swWorld* world, const swScene* scene, swSceneSea* sea);

/// The same of a host that makes the wave systems itself: `systems` are those of the scene's waves, in its order; null
/// handles of those that are not there, whose inputs are left out. Nothing is replayed.
SW_API swResult swCreateSceneInputs(swWorld* world, const swScene* scene, const swWaveSystemId* systems,
                                    swSceneSea* sea);

/// Set replayed systems to a time, and moving inputs and tides by a table to where and how they are then; call it
/// before each step to that time. Does nothing for a scene without any of these. It takes the scene's defs as they are
/// now. An input whose motion has brought it beyond 1e9 m stays where it was.
/// @return as swSeaReplay_Advance(); SW_ERROR_INVALID for such an input, which the host's log names
SW_API swResult swSceneSea_Advance(swSceneSea* sea, double time);

/// @name What moves in a scene at a time, s
/// The functions of time that swSceneSea_Advance() follows, for hosts that move a scene's inputs themselves.
/// @{

/// Whether an input moves by itself, and whether what it says changes by a table.
SW_API bool swSceneInput_IsMoving(const swSceneInput* input);
SW_API bool swSceneInput_IsChanging(const swSceneInput* input);

/// Where an input is and how it is turned, as for swInput_Move(), in the scene's coordinates.
/// @return false if its motion has brought it beyond 1e9 m, where no input can be
SW_API bool swSceneInput_GetPlace(const swSceneInput* input, double time, swPos* position, swAngles* rotation);

/// What it says: swInputDef::value with what a tide by a table adds.
SW_API void swSceneInput_GetValue(const swSceneInput* input, double time, float value[4]);

/// Height of the still water of a body, as for swWaterBody_SetLevel().
SW_API double swSceneWaterBody_GetLevel(const swSceneWaterBody* body, double time);

/// @}

/// Stop the replays, while the world is still there. Wave systems and inputs stay as they are. NULL is allowed.
SW_API void swDestroySceneSea(swSceneSea* sea);

/// Create a world with the scene's wave systems and step it to the scene's time.
/// @return what swCreateWorld(), swCreateSceneSea() and swWorld_Step() return
SW_API swResult swOpenScene(const swHost* host, const swScene* scene, swWorld** world, swSceneSea* sea);

/// The same without what drives replays: they stand still at the scene's time.
SW_API swResult swCreateSceneWorld(const swHost* host, const swScene* scene, swWorld** world);
