// SPDX-License-Identifier: MIT
#pragma once

// A query on the GPU as the passes see it, and what the passes of queries share. Queries are owned by query/.

#include "gpu/pass/gpu_world.h"
#include "shared/query.h"

// What a frame leaves of a query, and the points that it was asked. There is one slot more than frames in flight, so
// that the newest that has arrived can be read while all others are on their way.
#define SW_QUERY_SLOTS (SW_MAX_FRAMES_IN_FLIGHT + 1)
typedef struct swGpuQuerySlot
{
    bool isRecorded;
    uint64_t frameIndex;
    double time;
    double seaLevel;
    uint32_t pointsVersion;
    int count;
} swGpuQuerySlot;

struct swGpuQuery
{
    swGpuWorld* gpuWorld;
    swGpuQuery *previous, *next; // in the world's list
    swGpuQueryDef def;
    int slotCount;

    // Places to answer: the host's, in one of the slots of `points`, or in a buffer of its own. A slot holds
    // swQueryPoint[] and, of the water below, the places' heights above `level`; or swQueryRay[].
    int count;
    uint32_t pointsVersion;
    swPosXZ origin; // of cells, or of the floats, in the host's coordinates
    double level;   // m
    swBuffer points;
    int pointSlot;
    bool isPointSlotUsed;  // a recorded frame reads it
    VkDeviceSize levelsAt; // in a slot
    VkBuffer hostPoints;   // null: `points`
    VkDeviceSize hostOffset;

    // Answers: planes of `capacity` elements, see swGpuQueryBuffer.
    swBuffer answers;
    swGpuQueryBuffer planes;
    VkDeviceSize answerSize; // of all planes
    swBuffer copies;         // of the answers, for each slot; none unless def.readBack
    int answerSlot;          // of the last recorded frame
    swGpuQuerySlot slots[SW_QUERY_SLOTS];

    // Set by each swGpuWorld_Record(), valid for this frame.
    swUpload tiles; // swQueryTile[]
    swUpload waves; // swQueryWave[]
    swQueryParams params;
    swUpload volumeTiles; // swVolumeTile[]; of the water below
    swVolumeParams volume;
    swRayParams rays; // of a query of rays
};

// Whether a query of this kind asks for anything in this frame.
bool swHasQuery(const swGpuWorld* gpuWorld, swGpuQueryKind kind);

// Points that the host set, or the part of the host's buffer that holds them; fills `source`.
swBinding swBindPoints(const swGpuQuery* query, swQuerySource* source);
swBinding swBindPlane(const swGpuQuery* query, VkDeviceSize offset); // of the answers
// Workgroups of `points` points each.
void swDispatchPoints(swGpu* gpu, VkCommandBuffer commands, const swGpuQuery* query, uint32_t points);
