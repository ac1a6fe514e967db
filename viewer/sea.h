// SPDX-License-Identifier: MIT
#pragma once

// What is looked at: a scene file made into a world, its view, and their twins on the GPU, with every setting that the
// panel may turn.

#include "seaway/query.h"
#include "seaway/scene.h"

// Waves by hand as the panel has them, and the file's beside them.
typedef struct HandWaves
{
    swWaveComponent waves[SW_MAX_FREE_WAVES]; // def.components points here
    int filedRows[SW_MAX_FREE_WAVES];         // which of the file's each is; -1: added
    int appliedRows[SW_MAX_FREE_WAVES];       // the same of those that the world has
    const swWaveComponent* filed;             // belongs to the scene
    int filedCount;
} HandWaves;

typedef struct SeaWaves
{
    int serial; // one number for as long as it lives, whatever goes before it
    swWaveSystemId id;
    swWaveSystemDef def;           // as the panel has it; the world follows with ApplyChanges()
    HandWaves* hand;               // NULL if the waves are not by hand
    const swMeasuredSea* measured; // NULL for formulas; belongs to the scene
    int record;
    const char* file;    // of the measured spectrum, or empty
    swSeaReplay* replay; // NULL: one record stays
    swSeaReplayDef replayDef;
    int records[2]; // that the replay is between, and what they hold
    swSeaState recorded[2];
    swSeaState asked; // what the spectrum holds, at weight 1; of waves by hand only the height
    bool hasChanged;  // since the world had it

    // What the file has, to go back to: see tuning.h.
    bool isAdded;   // the file has no such system
    bool isRemoved; // the file has it, the world no longer
    swWaveSystemDef filedDef;
    int filedRecord;
    swSeaReplayDef filedReplay;
} SeaWaves;

// Systems that were added, and those of the file that were removed and may come back.
#define MAX_SEA_WAVES (2 * SW_MAX_WAVE_SYSTEMS)

// A system that was removed while its waves run down.
typedef struct LeavingWaves
{
    swWaveSystemId id;
    double start, end; // s of the sea
} LeavingWaves;

// Everything to tune but the waves.
typedef struct SeaLook
{
    swSkyDef sky;
    swWaterDef water;
    swFoamDef foam;
    float exposureEv;
} SeaLook;

// An input of the scene, or a body of water, as the panel has it; the world follows with ApplyChanges().
typedef struct SeaInput
{
    swInputId id;        // null of one that is left out
    swInputDef def;      // its points are `points`
    swInputDef filedDef; // its points are the scene's
    swInputDef takenDef; // that the world has, in the file's coordinates
    swInputPoint* points;
    int pointCount;
    bool hasChanged; // since the world had it
    bool isAdded;    // the file has no such input
    bool isRemoved;  // the file has it, and it is disabled in the world; it may come back
} SeaInput;

typedef struct SeaBody
{
    swWaterBodyDef def, filedDef, takenDef; // of `def` the points are `points`, of `filedDef` the scene's
    swVec2* points;
    int pointCount;
    bool hasChanged;
} SeaBody;

typedef struct Sea
{
    const swHost* host;
    swGpu* gpu;

    swScene* scene; // NULL: the open sea that needs no file
    char name[128];
    swWorldDef worldDef;
    SeaLook look, filedLook;
    int wavesCount;
    SeaWaves waves[MAX_SEA_WAVES];
    int lastSerial;
    int leavingCount;
    LeavingWaves leaving[SW_MAX_WAVE_SYSTEMS];
    swSceneSea authored; // handles of inputs and bodies, in the scene's order
    SeaInput* inputs;    // as many as the scene has
    SeaBody* bodies;
    int floorVersion;  // counts what may have changed the sea floor
    bool movesFloor;   // a part of the floor moves by itself
    float transition;  // s of the sea that a change of its waves takes
    double nextChange; // when the next one may begin, s of the sea

    swWorld* world;
    swView* view;
    swGpuWorld* gpuWorld;
    swRenderer* renderer;
    swPicture* picture;
    bool hasRecorded; // a frame: there are layers to read
} Sea;

// Read and build, with slices for pictures of `height` pixels; `path` NULL is an open sea. Reasons for failing go to
// the host's log, and `sea` is then empty.
bool OpenSea(Sea* sea, const swHost* host, swGpu* gpu, uint32_t height, const char* path);

// The device must be idle.
void CloseSea(Sea* sea);

// Let the world's waves run to the settings that changed. Changes that come faster than a part of the transition wait
// their turn: a world cross-fades three of them at most. `isPaused`: at once, since time does not run. If the world
// refuses, the host's log says why and the settings are those of the world again.
void ApplyChanges(Sea* sea, bool isPaused);

// Set replays, and what moves by itself, to a time, before the step to it.
bool AdvanceSea(Sea* sea, double time);

// Let a replay run at another speed from now on, or from another moment of its records.
void ChangeReplay(Sea* sea, int index, double seconds, double speed);

// Play the records of another place, from the same moment on.
void ChangeReplayPlace(Sea* sea, int index, int location);

// ---- sea_edit.c: systems and rows that come and go ----

typedef enum NewWaves
{
    NEW_WIND_SEA, // Beaufort 4
    NEW_SWELL,
    NEW_EQUALISER,
    NEW_BY_HAND,
    NEW_WAVES_COUNT
} NewWaves;

// Add a system, whose waves rise over the transition; it runs as the first one does. False, with a sentence in the
// host's log, if the world has no room for it.
bool AddWaves(Sea* sea, NewWaves kind);

// Take a system away; its waves run down over the transition. One of the file stays in the list, to be brought back.
void RemoveWaves(Sea* sea, int index);
bool BringBackWaves(Sea* sea, int index);

// Waves by hand: a copy of a row behind it; a row away, but never the last; the file's rows that are missing, back.
bool AddRow(Sea* sea, int index, int row);
bool RemoveRow(Sea* sea, int index, int row);
void BringBackRows(Sea* sea, int index);

// An error in the host's log.
void SayInSea(const Sea* sea, const char* text);

// Make a system in the world that waits for its weight until the next ApplyChanges().
swResult RaiseWaves(Sea* sea, SeaWaves* waves);

// Systems that have run down are destroyed. ApplyChanges() calls it.
void ClearLeavingWaves(Sea* sea, bool isPaused);

// ---- sea_inputs.c: what the scene puts into the sea ----

// All of it, into the world that has the wave systems.
swResult OpenInputs(Sea* sea);
void CloseInputs(Sea* sea);

// Let the world have what has changed; an input whose waves were removed is not there. ApplyChanges() calls it.
void ApplyInputs(Sea* sea);

// Of inputs and bodies that have to do with waves that are about to go, or that came back.
void FollowWaves(Sea* sea, int waves);

// A circle of a field around a place of the file's coordinates, behind the others. False, with a sentence in the host's
// log, if there is no scene or no room.
bool AddInput(Sea* sea, swInputField field, swPos position);

// One of the file stays in the list, to be brought back.
void RemoveInput(Sea* sea, int index);
void BringBackInput(Sea* sea, int index);

// Let an input say something else, with a value that is seen; or lie elsewhere: shapes through points begin as a
// square of the input's size where it has none.
void ChangeInputField(SeaInput* input, swInputField field);
bool ChangeInputShape(SeaInput* input, swInputShape shape);

// Whether a shape needs no more than a panel can give, and suits the input's field.
bool IsShapeFree(const SeaInput* input, swInputShape shape);
bool HasPoints(swInputShape shape);

// A copy of a point half way to the next one, or a metre beside it if there is no way; a point away, if the shape can
// spare it. False if there is no memory.
bool AddInputPoint(SeaInput* input, int row);
void RemoveInputPoint(SeaInput* input, int row);

// Take over other points, such as the world's or the file's. False if there is no memory.
bool TakeInputPoints(SeaInput* input, int count, const swInputPoint* points);

// The same of the shore of a body, which has three points and more.
bool AddShorePoint(SeaBody* body, int row);
void RemoveShorePoint(SeaBody* body, int row);
bool TakeShore(SeaBody* body, int count, const swVec2* points);

// Another constituent of a tide, of an input or a body, and one away.
int CountTide(const swTideConstituent tide[SW_MAX_TIDE]);
void AddConstituent(swTideConstituent tide[SW_MAX_TIDE]);
void RemoveConstituent(swTideConstituent tide[SW_MAX_TIDE], int row);

// Those that move by themselves, and tides by a table, to a time. AdvanceSea() calls it.
void MoveInputs(Sea* sea, double time);

// One, or everything, as the file has it; one that was added goes.
void ResetInput(Sea* sea, int index);
void ResetInputs(Sea* sea);

// UTC in seconds since 1970 that a replay has reached.
double GetReplaySeconds(const Sea* sea, int index);

// The same by the file's settings, and back to it.
double GetFiledReplaySeconds(const Sea* sea, int index);
void ResetReplayMoment(Sea* sea, int index);

// Significant height asked for by all systems together, and what their bands carry, m.
float GetAskedHeight(const Sea* sea);
float GetCarriedHeight(const Sea* sea);
