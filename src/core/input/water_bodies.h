// SPDX-License-Identifier: MIT
#pragma once

// The bodies of water of a world. Each owns up to five inputs over its polygon, which say all that queries, slices and
// pictures know of it. What a body's number is in the field BODY is its slot here.

#include "core/base/field.h"
#include "core/frame/frame.h"
#include "core/input/inputs.h"
#include "seaway/water_body.h"

#define SW_BODY_INPUTS 5

extern const swFields swWaterBodyFields;

typedef struct swWaterBody
{
    bool isUsed;
    uint32_t generation;
    swWaterBodyDef def;          // its place is in the sea, its points are `points`
    swVec2* points;              // [def.pointCount]
    swVec2 low, high;            // their bounds
    swId inputs[SW_BODY_INPUTS]; // null where it has none
} swWaterBody;

typedef struct swWaterBodies
{
    swInputs* inputs;
    swArray slots; // swWaterBody
    int count;
    swArray shown; // swBodyFrame, as many as slots
} swWaterBodies;

void swBeginWaterBodies(swWaterBodies* bodies, swInputs* inputs);
void swEndWaterBodies(swWaterBodies* bodies);

// What a def must hold; the log has a sentence otherwise.
swResult swCheckWaterBodyDef(const swHost* host, const swWaterBodyDef* def);

// Defs have their place in the sea and were checked. SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT; then nothing has changed.
swResult swAddWaterBody(swWaterBodies* bodies, const swWaterBodyDef* def, swId* id);
swResult swChangeWaterBody(swWaterBodies* bodies, swWaterBody* body, const swWaterBodyDef* def);
void swRemoveWaterBody(swWaterBodies* bodies, swWaterBody* body);
void swSetWaterBodyLevel(swWaterBodies* bodies, swWaterBody* body, double level);

// NULL for a handle that is null or stale.
swWaterBody* swFindWaterBody(const swWaterBodies* bodies, swId id);
swId swGetWaterBodyId(const swWaterBodies* bodies, const swWaterBody* body);
// NULL where none has the number.
swWaterBody* swGetWaterBodyAt(const swWaterBodies* bodies, int slot);

// For saved worlds: the next slot, with a body or free; a body that is as it was, with the shore that it has; a slot
// that is as free as it was. Inputs are read before.
swResult swRestoreWaterBody(swWaterBodies* bodies, const swWaterBodyDef* def, uint32_t generation,
                            const swId inputs[SW_BODY_INPUTS]);
swResult swRestoreFreeWaterBody(swWaterBodies* bodies, uint32_t generation);
void swRewindWaterBody(swWaterBodies* bodies, swWaterBody* body, const swWaterBodyDef* def,
                       const swId inputs[SW_BODY_INPUTS]);
void swForgetWaterBody(swWaterBodies* bodies, swWaterBody* body, uint32_t generation);

// The bodies as pictures see them, of a frame. Allocates nothing.
void swStepWaterBodies(swWaterBodies* bodies, swFrame* frame);
