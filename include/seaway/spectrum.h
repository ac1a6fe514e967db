// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"
#include "math.h"

/// @file
/// Directional wave spectra S(f, theta): formulas, and tables read from measurements.
/// Frequencies f in Hz, directions theta in radians where waves GO, from +x towards +z (see math.h),
/// densities in m^2/Hz/rad. Whatever the source, the surface's variance is the integral of the spectrum.

typedef enum swSpectrumKind
{
    /// [Hasselmann 1973]: a growing wind sea, given wind and fetch, or height and peak period. The published laws know
    /// no end: beyond some 20,000 U^2 / g of fetch the sea outgrows a fully developed one. swMakeWindSeaSpectrum() does
    /// not.
    SW_SPECTRUM_JONSWAP,
    /// [Pierson 1964]: a fully developed wind sea, given wind, or height and peak period.
    SW_SPECTRUM_PIERSON_MOSKOWITZ,
    /// [Bouws 1985]: JONSWAP over a sea floor, times Kitaigorodskii's depth factor. Wants `depth`.
    SW_SPECTRUM_TMA,
    /// [Elfouhaily 1997]: a wind sea by wind and fetch from its longest waves to the ripples of millimetres, with the
    /// slopes that the sun's glitter shows. A peak period stands for the fetch.
    SW_SPECTRUM_ELFOUHAILY,
    /// [Phillips 1958] [Tessendorf 2001]: the equilibrium range f^-5 down to the wave that the wind keeps up with.
    SW_SPECTRUM_PHILLIPS,
    /// An equaliser, octave by octave: see swOctaves.
    SW_SPECTRUM_OCTAVES,
    /// A table, such as a buoy's record.
    SW_SPECTRUM_TABLE,
    SW_SPECTRUM_KIND_COUNT
} swSpectrumKind;

/// The law by which the peak of a JONSWAP or TMA spectrum falls as the sea grows, with x = g fetch / windSpeed^2.
typedef enum swGrowthLaw
{
    /// omega_p = 2 pi 3.5 (g / U) x^-0.33, as it is printed [Hasselmann 1973].
    SW_GROWTH_HASSELMANN,
    /// omega_p = 22 (g^2 / (U F))^(1/3), that is 22 (g / U) x^(-1/3): a rounding that many programs and textbooks take.
    /// Its period is 1 to 5 % longer and its sea 3 to 9 % higher, the more the longer the fetch: by 3 and 6 % at x =
    /// 10,000.
    SW_GROWTH_CUBE_ROOT,
    SW_GROWTH_LAW_COUNT
} swGrowthLaw;

/// How waves spread about their mean direction. All but a table's; every one integrates to one at every frequency.
typedef enum swSpreadingKind
{
    /// cos^2s(theta / 2), the same at every frequency [Longuet-Higgins 1963]. Given spreadExponent.
    SW_SPREADING_COSINE_2S,
    /// cos^2s(theta / 2), narrowest at the peak: s by frequency and by how old the sea is [Mitsuyasu 1975].
    SW_SPREADING_MITSUYASU,
    /// The same with other laws for s [Hasselmann 1980].
    SW_SPREADING_HASSELMANN,
    /// sech^2(beta theta), beta by frequency [Donelan 1985] [Banner 1990]. The age of the sea has no part in it.
    SW_SPREADING_DONELAN_BANNER,
    /// All directions alike.
    SW_SPREADING_FLAT,
    /// (1 + Delta cos 2 theta) / (2 pi), Delta by wave number [Elfouhaily 1997]. It says how slopes lie, with the wind
    /// or across it, and not which way waves run: as many run against the wind as with it. Not for a sea seen moving.
    SW_SPREADING_ELFOUHAILY,
    SW_SPREADING_KIND_COUNT
} swSpreadingKind;

/// Octaves of the equaliser: octave i holds wavelengths [2^(i - 4), 2^(i - 3)) m, 0.0625 m to 1024 m.
#define SW_OCTAVE_COUNT 14

/// One octave of SW_SPECTRUM_OCTAVES.
typedef struct swOctave
{
    /// log10 of the density S(omega) in m^2 s at the octave's shortest wave, without the wind's limit. Range [-10, 5].
    float power;

    /// An octave that is not enabled has no waves. Its power still is where its longer neighbour's begins.
    bool isEnabled;

    /// Factor on the waves' horizontal displacement. Range [0, 4]. Default 1.
    float chop;

    /// Factor on gravity, for the waves' speed and nothing else. Range [0, 4]. Default 1.
    float gravityScale;
} swOctave;

/// The equaliser: a density whose logarithm runs linearly over that of frequency between the octaves' powers, and on as
/// omega^-5 through the longest. Variance is its integral.
typedef struct swOctaves
{
    /// Shortest first.
    swOctave octaves[SW_OCTAVE_COUNT];

    /// Factor on the waves' height. Range [0, 10]. Default 1.
    float multiplier;

    /// Factor on every octave's chop. Range [0, 4]. Default 1.
    float chop;

    /// Factor on every octave's gravity scale. Range [0, 25]. Default 1.
    float gravityScale;

    /// Take away the waves that are too long for the wind: times exp(-5/4 (omega_p / omega)^4), with omega_p of the
    /// fully developed sea under windSpeed, or of peakPeriod if that is given. Default true.
    bool limitByWind;
} swOctaves;

/// A sea with more in its long waves and less in its middle ones than a wind makes.
SW_API swOctaves swDefaultOctaves(void);

/// The same without the eight shortest octaves: a swell. Give it a narrow spreading.
SW_API swOctaves swDefaultSwellOctaves(void);

/// A directional spectrum on a grid. Arrays belong to the caller; objects that take a table copy it.
typedef struct swSpectrumTable
{
    /// Number of frequencies, range [2, 1024], and of directions, range [4, 720].
    int frequencyCount;
    int directionCount;

    /// Hz, ascending. [frequencyCount]
    const float* frequencies;

    /// Bandwidth of each frequency bin, Hz. [frequencyCount]
    const float* bandwidths;

    /// m^2/Hz/rad at frequency i, direction firstDirection + 2 pi j / directionCount (where waves go).
    /// [frequencyCount][directionCount]
    const float* density;

    /// Direction of the first column, radians. Default 0.
    float firstDirection;
} swSpectrumTable;

/// Where a table's bins begin and end, Hz. Bin i reaches from edges[i] to edges[i + 1] and holds density times
/// bandwidth. Bandwidths that fit together, around their frequencies or half-way to the neighbours, are kept; of others
/// the nearest edges are taken that leave each frequency in its own bin.
/// Misuse, such as NULL or a table without frequencies, leaves edges as they are.
/// @param edges [frequencyCount + 1]
SW_API void swSpectrumTable_GetEdges(const swSpectrumTable* table, double* edges);

/// Must be initialized with swDefaultSpectrumDef().
typedef struct swSpectrumDef
{
    /// Default SW_SPECTRUM_JONSWAP.
    swSpectrumKind kind;

    /// Wind at 10 m above the water, m/s. Range (0, 100]. Default 10. Tables use it only with hasWind.
    float windSpeed;

    /// Whether windSpeed is known to blow over these waves although their height or period was given, or a table.
    /// Whitecaps then follow it. Without it a given sea tells of its own wind, and a formula that was given nothing but
    /// wind and fetch has that wind anyway. The one-knob functions set it, a swell's wind being a breath. Default
    /// false.
    bool hasWind;

    /// Distance over which the wind has blown, m. Range [1e3, 1e7]. Default 300e3. JONSWAP, TMA and Elfouhaily.
    float fetch;

    /// Which law gives the peak by wind and fetch. Default SW_GROWTH_HASSELMANN. JONSWAP and TMA without a peakPeriod.
    swGrowthLaw growth;

    /// Peak enhancement. Range [1, 10]. Default 3.3. JONSWAP and TMA.
    float gamma;

    /// Significant wave height 4 sqrt(m0), m; a table's without its tail. Range [0, 40]. Default 0: what wind and fetch
    /// (or the table, or the octaves) give. Every kind takes it: the density is scaled, its shape stays.
    float significantHeight;

    /// Period of the spectral peak, s. Range [0, 60]. Default 0: what wind and fetch give. Of TMA, the peak over deep
    /// water; of Elfouhaily's, the period from which the age of the sea follows; of octaves, where limitByWind has its
    /// effect. Unused by tables.
    float peakPeriod;

    /// Mean direction where waves go, radians from +x towards +z. Range [-1000, 1000]. Default 0 (eastward). Tables
    /// turn by it.
    float direction;

    /// Default SW_SPREADING_COSINE_2S. Unused by tables, as the next three.
    swSpreadingKind spreading;

    /// Exponent s of the spreading cos^2s(theta / 2). Range [0, 200]. Default 8; 0 is all directions alike, 75 a swell.
    /// SW_SPREADING_COSINE_2S only.
    float spreadExponent;

    /// Part of the energy that goes in all directions alike. Range [0, 1]. Default 0.
    float turbulence;

    /// How far waves are drawn out into long parallel crests, the longest most: the distribution is multiplied by
    /// cos^2s(theta / 2), s = 16 tanh(omega_p / omega) swell^2 [Horvath 2015]. Range [0, 1]. Default 0.
    float swell;

    /// For SW_SPECTRUM_OCTAVES. Default swDefaultOctaves().
    swOctaves octaves;

    /// Depth of the water, m: for the waves' lengths and speeds, omega^2 = (g k + sigma k^3) tanh(k depth), with the
    /// world's gravity and surface tension. Range [0.001, inf]. Default infinite.
    float depth;

    /// For SW_SPECTRUM_TABLE. Read only during the call that takes the def. Default NULL.
    const swSpectrumTable* table;

    /// Continue a table beyond its highest frequency with an f^-5 tail, so that it has short waves.
    /// Default true. The tail's energy comes on top of the table's.
    bool extendTail;

    /// Set by swDefaultSpectrumDef().
    int internalValue;
} swSpectrumDef;

/// A JONSWAP sea under a 10 m/s wind blowing east over 300 km.
SW_API swSpectrumDef swDefaultSpectrumDef(void);

/// An equaliser that has the shape of another spectrum, at the octaves' edges, and its height. Directions and depth are
/// those of the source. The powers stand on what limitByWind takes away at the source's peak.
/// @param source of any kind; of a table's directions, mean and spread are kept
SW_API swSpectrumDef swMakeOctaveSpectrum(const swSpectrumDef* source);

/// @name One knob
/// Seas as people name them. Wind seas spread as SW_SPREADING_HASSELMANN, and none outgrows the fully developed sea of
/// its wind. Change whatever field you like in what they return.
/// @{

/// A sea by Beaufort's number, which may lie between two: the wave height that the World Meteorological Organization
/// gives as probable in the open sea, the wind 0.836 number^1.5 m/s, the period of a sea that has grown to that height
/// under that wind. Numbers outside [0, 12] are moved to the nearest.
SW_API swSpectrumDef swMakeBeaufortSpectrum(float number, float direction);

/// A sea by the World Meteorological Organization's (Douglas's) state of the sea, code table 3700: the middle of its
/// range of heights, 0.05, 0.3, 0.875, 1.875, 3.25, 5, 7.5, 11.5 and 16 m for 1 to 9. States outside [0, 9] are moved
/// to the nearest, between two the height is between theirs.
SW_API swSpectrumDef swMakeSeaStateSpectrum(float state, float direction);

/// A wind sea by wind (m/s at 10 m), the distance over which it blows (m) and for how long (s); the smaller of both
/// effects counts [Carter 1982], and growth ends at the fully developed sea. INFINITY is allowed for fetch and
/// duration.
SW_API swSpectrumDef swMakeWindSeaSpectrum(float windSpeed, float fetch, float duration, float direction);

/// A swell: height (m), peak period (s), and the standard deviation of its directions (radians, range [0.1, 1.41]; 0.15
/// is a swell from far away).
SW_API swSpectrumDef swMakeSwellSpectrum(float significantHeight, float peakPeriod, float direction, float spread);

/// @}

/// Integral parameters of a spectrum. Directions in radians where waves go.
typedef struct swSeaState
{
    float significantHeight; ///< Hs = 4 sqrt(m0), m
    float peakPeriod;        ///< Tp: 1 / frequency of the largest density, s
    float periodTm01;        ///< m0 / m1, s
    float periodTm02;        ///< sqrt(m0 / m2), s
    float energyPeriod;      ///< Te = m-1 / m0, s
    float meanDirection;     ///< energy-weighted over all frequencies
    float peakDirection;     ///< mean direction at the peak frequency
    float spread;            ///< sqrt(2 (1 - r1)) over all frequencies, radians
    float meanSquareSlope;   ///< integral of k^2 S of the frequencies integrated, k by depth and surface tension
} swSeaState;

/// One-dimensional density at f, m^2/Hz. Returns 0 outside the spectrum. Any thread. Like the next one, each call
/// prepares the spectrum anew, about 0.2 ms.
SW_API float swSpectrum_GetDensity(const swSpectrumDef* def, float frequency);

/// The same at many frequencies, preparing the spectrum once.
SW_API void swSpectrum_GetDensities(const swSpectrumDef* def, int count, const float* frequencies, float* densities);

/// Density of direction at f, 1/rad; integrates to 1 over the circle. Any thread.
SW_API float swSpectrum_GetSpreading(const swSpectrumDef* def, float frequency, float direction);

/// Integrate the spectrum over [minFrequency, maxFrequency] Hz, a table with its tail; or, with 0 and 0, over all of
/// it: a formula up to 5 Hz (waves of 6 cm), a table by its own bins and widths, without the tail.
/// @return SW_ERROR_INVALID if the def is outside its ranges or has no energy
SW_API swResult swSpectrum_GetSeaState(const swSpectrumDef* def, float minFrequency, float maxFrequency,
                                       swSeaState* seaState);
