// SPDX-License-Identifier: MIT
#pragma once

#include "id.h"
#include "spectrum.h"

/// @file
/// Wave systems: a spectrum made into waves by fast Fourier transforms [Tessendorf 2001]. Each octave of wavelength is a
/// band with a periodic tile of its own; tile sides of neighbouring bands are incommensurate, so their sum never
/// visibly repeats.

typedef struct swWorld swWorld;

/// Bands (octaves) a system can have: band b holds wavelengths [2^(b - 4), 2^(b - 3)) m, 0.0625 m to 4096 m.
#define SW_MAX_BANDS 16

/// Wave systems and tiles (bands with energy, over all systems) that a world can have.
#define SW_MAX_WAVE_SYSTEMS 16
#define SW_MAX_TILES 64

/// Must be initialized with swDefaultWaveSystemDef().
typedef struct swWaveSystemDef
{
    swSpectrumDef spectrum;

    /// Samples along a tile's side. Power of two in [16, 512]. Default 128.
    int resolution;

    /// Waves of the band's shortest length along a tile's side. Range [4, resolution / 4]. Default 32. More waves repeat
    /// less; more samples per wave (resolution / tileWaves) interpolate better. The sea depends on tileWaves and seed but
    /// not on resolution.
    int tileWaves;

    /// Wavelengths to make, m. Default 0.0625 to 4096. Waves outside carry no energy.
    float minWavelength;
    float maxWavelength;

    /// Horizontal displacement relative to that of a trochoidal wave. Range [0, 2]. Default 1.
    float chop;

    /// Factor on displacement. Range [0, 10]. Default 1.
    float weight;

    /// The waves repeat exactly after this time, s. Default 0: never.
    float loopPeriod;

    /// Another seed is another sea of the same statistics. Default 1.
    uint32_t seed;

    /// Set by swDefaultWaveSystemDef().
    int internalValue;
} swWaveSystemDef;

/// A fresh breeze's sea, see swDefaultSpectrumDef().
SW_API swWaveSystemDef swDefaultWaveSystemDef(void);

/// Add waves. They are part of the surface from the next step on.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT (systems or tiles)
SW_API swResult swCreateWaveSystem(swWorld* world, const swWaveSystemDef* def, swWaveSystemId* id);

/// Remove waves from the next step on.
SW_API void swDestroyWaveSystem(swWorld* world, swWaveSystemId id);

SW_API bool swWaveSystem_IsValid(const swWorld* world, swWaveSystemId id);

/// Replace the spectrum, keeping seed and phases; the surface changes with the next step. Costs a fresh initial
/// spectrum: some 20 ms on one thread, shared out over the host's workers.
SW_API swResult swWaveSystem_SetSpectrum(swWorld* world, swWaveSystemId id, const swSpectrumDef* spectrum);

/// Range [0, 10]. Takes effect with the next step.
SW_API void swWaveSystem_SetWeight(swWorld* world, swWaveSystemId id, float weight);
SW_API float swWaveSystem_GetWeight(const swWorld* world, swWaveSystemId id);

/// What a band of a system holds, for displays and tests.
typedef struct swBandInfo
{
    float minWavelength, maxWavelength; ///< m
    float tileSide;                     ///< m
    int modeCount;                      ///< waves in the band
    float variance;                     ///< of height, m^2
    float meanSquareSlope;              ///< of both directions together
} swBandInfo;

/// Bands with energy, shortest first. `bands` has room for SW_MAX_BANDS.
/// @return their number
SW_API int swWaveSystem_GetBands(const swWorld* world, swWaveSystemId id, swBandInfo* bands);
