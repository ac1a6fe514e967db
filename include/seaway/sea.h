// SPDX-License-Identifier: MIT
#pragma once

#include "waves.h"

/// @file
/// A sea as one meets it: a wind sea and the swells of other winds, far away or long ago, each with a height, a period
/// and a direction of its own. One call makes a wave system of each.

/// Swells that a sea can have.
#define SW_MAX_SWELLS 4

/// Must be initialized with swDefaultSeaDef().
typedef struct swSeaDef
{
    /// The wind sea, and what all of the sea's systems have in common: resolution, tile, chop, loop period and weight.
    /// Default swDefaultWaveSystemDef(). Its seed is that of the sea; every system has one of its own made from it.
    swWaveSystemDef windSea;

    /// Default true. False leaves the wind sea out.
    bool enableWindSea;

    /// Number of swells, range [0, SW_MAX_SWELLS]. Default 0.
    int swellCount;

    /// Their spectra, such as swMakeSwellSpectrum() gives. A formula's waves shorter than a sixteenth of the peak's are
    /// left out: a swell has lost them, and the wind sea has them already. Default swDefaultSpectrumDef().
    swSpectrumDef swells[SW_MAX_SWELLS];

    /// Set by swDefaultSeaDef().
    int internalValue;
} swSeaDef;

/// The wave systems of a sea, to change or destroy one by one as any other. Null where there is none.
typedef struct swSea
{
    swWaveSystemId windSea;
    int swellCount;
    swWaveSystemId swells[SW_MAX_SWELLS];
} swSea;

/// A fresh breeze's wind sea and no swell.
SW_API swSeaDef swDefaultSeaDef(void);

/// Add a sea. On failure the world is as it was before.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT (systems or tiles)
SW_API swResult swCreateSea(swWorld* world, const swSeaDef* def, swSea* sea);

/// Remove what is still there of a sea, and make its handles null.
SW_API void swDestroySea(swWorld* world, swSea* sea);
