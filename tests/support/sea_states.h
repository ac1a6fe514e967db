// SPDX-License-Identifier: MIT
#pragma once

// What tests ask of measured seas.

#include "support/cmocka_setup.h"

#include <math.h>

#include <seaway/measured.h>

// Degrees clockwise from north that waves come from, of a direction where they go. In [0, 360).
static inline double GetBearing(float direction)
{
    double degrees = (double)direction * 180.0 / SW_PI - 90.0;
    return degrees - 360.0 * floor(degrees / 360.0);
}

static inline double GetAngleBetween(double a, double b)
{
    return fabs(remainder(a - b, 360.0));
}

// Of a record as a spectrum, with the tail beyond its table or without.
static inline swSeaState GetSeaState(const swMeasuredSea* sea, int index, bool withTail)
{
    swMeasuredRecord record = swMeasuredSea_GetRecord(sea, index);
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_TABLE;
    def.table = &record.table;
    def.extendTail = withTail;
    swSeaState state;
    assert_int_equal(swSpectrum_GetSeaState(&def, 0.0f, 0.0f, &state), SW_SUCCESS);
    return state;
}
