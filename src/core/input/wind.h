// SPDX-License-Identifier: MIT
#pragma once

// The wind of a world as a function of place and time, see seaway/wind.h: what lies below all inputs of the field WIND.

#include "core/base/field.h"
#include "core/base/hash.h"
#include "core/base/stream.h"
#include "core/frame/frame.h"
#include "seaway/wind.h"

extern const swFields swWindFields;

// The wind that the world has, and the one that it turns into.
typedef struct swWind
{
    swWindDef from, to;
    int64_t begin, length; // of the change, ticks
} swWind;

swWind swMakeWind(const swWindDef* def);
// From what it is at a time on.
void swChangeWind(swWind* wind, const swWindDef* def, int64_t ticks, double seconds);

// What the frame has of it. It holds at every time, as long as the wind is not changed.
void swDeriveWind(const swWind* wind, int64_t ticks, swWindFrame* frame);

// The mean at a time, m/s along x and z.
swVec2 swFindMeanWind(const swWindFrame* wind, int64_t ticks);

// Mean and gusts at places in the sea.
void swFindWinds(const swWindFrame* wind, int64_t ticks, int count, const swPosXZ* points, swVec2* winds);

// Of numbers that came from elsewhere.
bool swIsWindGood(const swWind* wind);

// The def that it turns into is the world's, and is not among these bytes.
void swStreamWind(swStream* stream, const swWindDef* to, swWind* wind);
void swAddHashWind(swHash* hash, const swWind* wind, int64_t ticks);
