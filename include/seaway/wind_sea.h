// SPDX-License-Identifier: MIT
#pragma once

#include "input.h"
#include "waves.h"

/// @file
/// A wind sea that differs from place to place, by a map of the wind: in the lee of an island, at a front, in a storm
/// that turns. Waves cannot be turned where they are, since a wave's phase is of all the sea; so the sea is made of
/// local wave systems, each for one heading and one speed of the wind with waves of its own, and a place mixes those
/// next to its wind. The map holds winds and no fetch: where waves have had time to grow is for the map to say.

/// Must be initialized with swDefaultWindSeaDef().
typedef struct swWindSeaDef
{
    /// What the systems have in common. Its spectrum must be a formula that follows the wind: without a height and a
    /// period of its own. The wind's speed and direction come from the map, and seeds are made from its seed. Default
    /// swDefaultWaveSystemDef().
    swWaveSystemDef waves;

    /// The wind along x and z, m/s, at 10 m: two channels. Nothing is known of the sea outside of it. Default NULL.
    const swRaster* raster;

    /// Where the map lies, m: it is moved by so much from where the raster says. Range [-1e9, 1e9]. Default 0.
    swPos position;

    /// How it is turned, radians, its winds with it: by the yaw, as swInputDef::rotation has it. Range [-1000, 1000].
    /// Default 0.
    swAngles rotation;

    /// Factor on the map's winds. Range [-1e6, 1e6]. Default 1.
    float gain;

    /// How far inwards from the map's edge the sea grows to its full height, m. Range [0, 1e6]. Default 0.
    float feather;

    /// Of the inputs that weigh the systems, as swInputDef::order. Range [-1000000, 1000000]. Default 0.
    int order;

    /// All other waves below `order` go where the map is, by its feather. Default false.
    bool removesWaves;

    /// Headings on the full circle, the first along the map's mean wind. Mean directions of the sea are off by at most
    /// a quarter of the way from one to the next. Range [4, 64]. Default 12.
    int headingCount;

    /// Speeds, each the same factor above the one below, from a quarter of the map's strongest wind (or its weakest, if
    /// that is more) up to the strongest. Between two of them heights are those that the spectrum's law asks for, and
    /// wavelengths are mixed. Range [1, 4]. Default 2.
    int speedCount;

    /// Set by swDefaultWindSeaDef().
    int internalValue;
} swWindSeaDef;

/// The systems of a wind sea, and the inputs that weigh them.
typedef struct swWindSea
{
    int count;
    swWaveSystemId systems[SW_MAX_WAVE_SYSTEMS];
    swInputId inputs[SW_MAX_WAVE_SYSTEMS];
} swWindSea;

SW_API swWindSeaDef swDefaultWindSeaDef(void);
SW_API const swFields* swGetWindSeaFields(void);

/// Add a sea by a map of the wind. Only headings and speeds that the map needs are made: those whose waves have more
/// than a fiftieth of a place's height. On failure the world is as it was before.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT (systems or tiles: ask for fewer headings or speeds, or
/// leave out the shortest waves)
SW_API swResult swCreateWindSea(swWorld* world, const swWindSeaDef* def, swWindSea* sea);

/// Remove what is still there of it, and make its handles null.
SW_API void swDestroyWindSea(swWorld* world, swWindSea* sea);
