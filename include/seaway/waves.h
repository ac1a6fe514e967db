// SPDX-License-Identifier: MIT
#pragma once

#include "id.h"
#include "spectrum.h"

/// @file
/// Wave systems: a spectrum made into waves. Any number of systems add up to the sea; each may change while it runs,
/// without a jump.
///
/// SW_WAVES_FFT makes tens of thousands of waves by fast Fourier transforms [Tessendorf 2001]. Each octave of
/// wavelength is a band with a periodic tile of its own; tile sides of neighbouring bands are incommensurate, so their
/// sum never visibly repeats. A narrow swell, whose energy is all in one octave, has up to three such tiles there, side
/// by side. SW_WAVES_GERSTNER makes some hundred waves at most, each with its exact length and direction
/// [Gerstner 1802]: cheap where there are few, and to be placed by hand.

typedef struct swWorld swWorld;

/// Bands (octaves) a system can have: band b holds wavelengths [2^(b - 4), 2^(b - 3)) m, 0.0625 m to 4096 m.
#define SW_MAX_BANDS 16

/// Wave systems and tiles (bands with energy, over all systems) that a world can have, and waves of its Gerstner
/// systems.
#define SW_MAX_WAVE_SYSTEMS 32
#define SW_MAX_TILES 128
#define SW_MAX_FREE_WAVES 1024

/// Fastest current that may carry the waves of a system, m/s.
#define SW_MAX_CURRENT 100.0f

/// Longest time that a change may take, s.
#define SW_MAX_TRANSITION 86400.0

typedef enum swWaveMethod
{
    SW_WAVES_FFT,
    SW_WAVES_GERSTNER,
    SW_WAVE_METHOD_COUNT
} swWaveMethod;

/// One wave of a Gerstner system, given by hand: height amplitude * cos(k x - omega t + phase).
typedef struct swWaveComponent
{
    float wavelength; ///< m. Range [0.0625, 4096]
    float direction;  ///< where it goes, radians from +x towards +z. Range [-1000, 1000]
    float amplitude;  ///< half its height, m. Range [0, 40]
    float phase;      ///< at the sea's origin at time 0, radians. Range [-1e6, 1e6]
} swWaveComponent;

/// Must be initialized with swDefaultWaveSystemDef().
typedef struct swWaveSystemDef
{
    /// Also of a Gerstner system, unless its components are given; then only its depth counts.
    swSpectrumDef spectrum;

    /// Default SW_WAVES_FFT.
    swWaveMethod method;

    /// FFT: samples along a tile's side. A power of two. Range [16, 512]. Default 128.
    int resolution;

    /// FFT: waves of the band's shortest length along a tile's side. Range [4, resolution / 4]. Default 32. More waves
    /// repeat less; more samples per wave (resolution / tileWaves) interpolate better. The sea depends on tileWaves and
    /// seed but not on resolution.
    int tileWaves;

    /// Gerstner: waves an octave. Range [1, 32]. Default 8.
    int componentsPerOctave;

    /// Gerstner: height of a twin that each wave has and that runs the other way, relative to the wave's own. The two
    /// share the spectrum's energy. Range [0, 1]. Default 0.
    float reverseWeight;

    /// Gerstner: directions lie evenly within this angle of the mean direction, radians, instead of as the spectrum
    /// spreads. Range [0, pi]. Default 0: as the spectrum spreads.
    float directionVariance;

    /// Gerstner: what the Jacobian of the waves' horizontal displacement (1 flat, 0 a fold) stays above at all but one
    /// place in ten thousand. Where chop would fold more, horizontal displacement is held back, of all waves alike;
    /// heights stay. Of each system by itself, at weight 1. Range [-10, 0.9]. Default 0.1; -10 takes chop as it is. Not
    /// of given components.
    float leastJacobian;

    /// Gerstner: the waves themselves, instead of a spectrum's. Copied by the call that takes the def. Default NULL, 0;
    /// at most SW_MAX_FREE_WAVES.
    const swWaveComponent* components;
    int componentCount;

    /// Shortest wave to make, m; below maxWavelength. Range [0.0625, 4096]. Default 0.0625. Waves outside of the two
    /// carry no energy. Given components are all made.
    float minWavelength;

    /// Longest wave to make, m. Range [0.0625, 4096]. Default 4096.
    float maxWavelength;

    /// Horizontal displacement relative to that of a water particle in a wave of small height. Range [0, 2]. Default 1.
    float chop;

    /// Factor on displacement. Range [0, 10]. Default 1.
    float weight;

    /// How much the waves die out over a floor: 1 as waves do, untouched where the water is deeper than half their
    /// length and gone at its edge; 0 a system that does not care for the floor. See docs/depth.md. Range [0, 1].
    /// Default 1.
    float attenuation;

    /// Depth from which on none of the waves is attenuated, however long, m: of a sea whose floor is known near the
    /// shore only. Range [0, 1e4]. Default 0: by their lengths alone.
    float shallowsDepth;

    /// Velocity of a current that carries all of the system's waves, m/s along x and z: their frequencies become
    /// omega + k . U, exactly, and a wave that runs against it stands still where U is its speed. The waves and the
    /// foam: the water's own velocity is what SW_INPUT_FLOW says, which carries waves as well, exactly where it is the
    /// same everywhere; one current is given in one of both ways, see docs/flow.md. A change of the current never moves
    /// the waves, whether it takes time or none; afterwards the sea depends on when it came. A sea with a loop loops as
    /// seen from the moving water. Range [-SW_MAX_CURRENT, SW_MAX_CURRENT]. Default 0, 0.
    float currentX, currentZ;

    /// The waves are only where inputs of SW_INPUT_WAVES give them weight, see input.h. Default false: they are
    /// everywhere, but for what inputs take from them.
    bool isLocal;

    /// The waves repeat exactly after this time, s. Range [0, SW_LARGEST_TIME]. Default 0: never.
    float loopPeriod;

    /// Another seed is another sea of the same statistics. Range [0, UINT32_MAX]. Default 1. Give each system of a
    /// world a seed of its own: of FFT systems with one seed the waves that they have in common run in step, and their
    /// heights add up instead of their energies. The log warns of it.
    uint32_t seed;

    /// Take speed and direction of the world's wind (wind.h) in place of the spectrum's, and change with it; the
    /// spectrum's own stand where the world names no wind. Heights and periods that are given stay. Not of a table, nor
    /// of given components. Default false.
    bool takesWind;

    /// Set by swDefaultWaveSystemDef().
    int internalValue;
} swWaveSystemDef;

/// A fresh breeze's sea, see swDefaultSpectrumDef().
SW_API swWaveSystemDef swDefaultWaveSystemDef(void);

/// Add waves. They are part of the surface from the next step on. Systems that ask for the same waves share them: the
/// second one costs nothing.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT (systems, tiles or free waves)
SW_API swResult swCreateWaveSystem(swWorld* world, const swWaveSystemDef* def, swWaveSystemId* id);

/// Remove waves from the next step on. For waves that should go gently, let their weight run to 0 first.
SW_API void swDestroyWaveSystem(swWorld* world, swWaveSystemId id);

SW_API bool swWaveSystem_IsValid(const swWorld* world, swWaveSystemId id);

/// Change anything about a system. Over `seconds` of the world's time, from its last step on, the sea turns into the
/// new one without a jump; 0 changes it with the next step. Afterwards the surface is that of the def alone: a def that
/// is changed and changed back gives the same bits at the same time, unless its current changed in between.
///
/// Where only amplitudes differ (spectrum, wavelengths, chop, weight), each wave keeps its phase and changes its
/// height, which costs no more than a sea that stays. Changes of seed, tiles, depth, loop or method cross-fade two seas
/// of the same energy; both cost until it is over. A change may interrupt another.
/// Costs a fresh initial spectrum: 12 to 50 ms on one thread, shared out over the host's workers.
/// @param seconds range [0, SW_MAX_TRANSITION]
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT (tiles or free waves, or a fourth cross-fade at once);
/// then nothing has changed
SW_API swResult swWaveSystem_Set(swWorld* world, swWaveSystemId id, const swWaveSystemDef* def, double seconds);

/// The def that was asked for last. Its table and components are the world's, until the next change or step.
SW_API swWaveSystemDef swWaveSystem_Get(const swWorld* world, swWaveSystemId id);

/// swWaveSystem_Set() with another spectrum, at once.
SW_API swResult swWaveSystem_SetSpectrum(swWorld* world, swWaveSystemId id, const swSpectrumDef* spectrum);

/// Range [0, 10]. Takes effect with the next step, or runs there evenly over `seconds`. Costs nothing.
SW_API void swWaveSystem_SetWeight(swWorld* world, swWaveSystemId id, float weight);
SW_API void swWaveSystem_FadeWeight(swWorld* world, swWaveSystemId id, float weight, double seconds);

/// The weight at the last step.
SW_API float swWaveSystem_GetWeight(const swWorld* world, swWaveSystemId id);

/// What a band of a system holds, for displays and tests.
typedef struct swBandInfo
{
    float minWavelength, maxWavelength; ///< m
    float tileSide;                     ///< m, of the largest of its tiles; 0 of a Gerstner system
    int tileCount;         ///< 1, up to 3 where a narrow swell would be seen to repeat; 0 of a Gerstner system
    int modeCount;         ///< waves in the band
    float variance;        ///< of height, m^2
    float meanSquareSlope; ///< of both directions together
} swBandInfo;

/// Bands with energy, shortest first, of the sea as it is now (of a cross-fade: of the sea to come). `bands` has room
/// for SW_MAX_BANDS.
/// @return their number
SW_API int swWaveSystem_GetBands(const swWorld* world, swWaveSystemId id, swBandInfo* bands);
