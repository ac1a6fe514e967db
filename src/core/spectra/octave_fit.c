// SPDX-License-Identifier: MIT
// An equaliser from another spectrum: the densities at the octaves' edges, and a factor that keeps the height.

#include "core/base/misuse.h"
#include "core/math/scalar.h"
#include "core/spectra/compiled.h"

#define LN_10 2.302585092994046
#define LEAST_POWER -10.0
#define LARGEST_POWER 5.0

// Directions of a table, as one cosine.
static void takeTableDirections(swSpectrumDef* def, const swSeaState* seaState)
{
    double r1 = 1.0 - 0.5 * (double)seaState->spread * (double)seaState->spread;
    double s = r1 < 0.995 ? r1 / (1.0 - r1) : 200.0;
    def->direction = seaState->meanDirection;
    def->spreading = SW_SPREADING_COSINE_2S;
    def->spreadExponent = (float)(s > 0.0 ? s : 0.0);
    def->turbulence = 0.0f;
    def->swell = 0.0f;
}

// The density before the limit. Where that leaves next to nothing, the last one goes on as omega^-5.
static void samplePowers(swSpectrumDef* def, const swCompiledSpectrum* source, double peakOmega)
{
    double before = LEAST_POWER * LN_10;
    double logBefore = 0.0;
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        double omega = swGetOmega(&source->dispersion, SW_TURN / swGetShortestOfOctave(i));
        double limit = swGetWindLimit(peakOmega, omega);
        double density = swGetCompiledDensity(source, omega);
        double value = limit > 1e-6 ? (density > 1e-30 ? swLn(density / limit) : LEAST_POWER * LN_10)
                                    : before - 5.0 * (swLn(omega) - logBefore);
        double power = value / LN_10;
        power = power < LEAST_POWER ? LEAST_POWER : power > LARGEST_POWER ? LARGEST_POWER : power;
        def->octaves.octaves[i] = (swOctave){(float)power, true, 1.0f, 1.0f};
        before = value;
        logBefore = swLn(omega);
    }
}

swSpectrumDef swMakeOctaveSpectrum(const swSpectrumDef* sourceDef)
{
    SW_REQUIRE(sourceDef != NULL, swDefaultSpectrumDef(), NULL, "swMakeOctaveSpectrum() needs a def");
    swSpectrumDef def = *sourceDef;
    if (def.kind == SW_SPECTRUM_OCTAVES)
    {
        return def;
    }
    def.kind = SW_SPECTRUM_OCTAVES;
    def.hasWind = swHasSpectrumWind(sourceDef);
    def.table = NULL;
    def.significantHeight = 0.0f;
    def.octaves = swDefaultOctaves();
    swSeaState seaState;
    swCompiledSpectrum source;
    swComplaint complaint;
    if (swSpectrum_GetSeaState(sourceDef, 0.0f, 0.0f, &seaState) != SW_SUCCESS ||
        !swPrepareSpectrum(&source, sourceDef, SW_STANDARD_GRAVITY, SW_STANDARD_SURFACE_TENSION, &complaint))
    {
        return def;
    }
    if (sourceDef->kind == SW_SPECTRUM_TABLE)
    {
        takeTableDirections(&def, &seaState);
    }
    def.peakPeriod = seaState.peakPeriod < 60.0f ? seaState.peakPeriod : 60.0f;
    samplePowers(&def, &source, SW_TURN / (double)def.peakPeriod);
    swSeaState made;
    if (swSpectrum_GetSeaState(&def, 0.0f, 0.0f, &made) == SW_SUCCESS)
    {
        float factor = seaState.significantHeight / made.significantHeight;
        def.octaves.multiplier = factor < 10.0f ? factor : 10.0f;
    }
    return def;
}
