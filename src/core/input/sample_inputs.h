// SPDX-License-Identifier: MIT
#pragma once

// The fields that inputs make, at points in the sea. The GPU's twin is shaders/lib/inputs.glsl.

#include "core/input/input_index.h"
#include "seaway/water_body.h"
#include "shared/displace.h"
#include "shared/ribbon_looks.h"

// Bits of a mask of fields.
#define SW_FIELD_BIT(field) (1u << (field))

// A field at points in the sea, with derivatives along x and z, per metre. `system` is the slot of a wave system, of
// SW_INPUT_WAVES. Heights of floors count from sea level; SW_NO_FLOOR is none.
void swFindInputValues(const swInputSet* set, int field, int system, int count, const swPosXZ* points,
                       swInputValue* values);

// The same where `values` hold what is below all inputs: of the wind the world's.
void swJoinInputValues(const swInputSet* set, int field, int system, int count, const swPosXZ* points,
                       swInputValue* values);

// The first number of a field of the water's own: inputs that follow the waves count where the water rests, the others
// where it is.
void swFindWaterValues(const swInputSet* set, int field, int count, const swPosXZ* here, const swPosXZ* rest,
                       float* values);

// The value of SW_INPUT_BODY as a number: -1 for all that is none.
static inline int swGetBodyNumber(float value)
{
    return value >= 0.0f && value < SW_MAX_WATER_BODIES ? (int)value : -1;
}

// A system's waves at points in the sea: the weight of those that lie as ever, and those along splines.
void swFindWaveLooks(const swInputSet* set, int system, int count, const swPosXZ* points, swWaveLooks* looks);

// Inputs of displacement at a point: those that follow the waves join the waves' own where they rest, the others change
// a height above still water where it is.
void swDisplaceAt(const swInputSet* set, swDisplaceRange range, swPosXZ rest, swInputValue* waves);
void swDisplaceHeightAt(const swInputSet* set, swDisplaceRange range, swPosXZ point, swInputChannel* height);

// The cells within `reach` metres of a point; false where they do not fit 32 bits.
bool swFindCellBox(swPosXZ point, double reach, swCellBox* box);
