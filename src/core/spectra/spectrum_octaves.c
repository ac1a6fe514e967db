// SPDX-License-Identifier: MIT
// The equaliser. A power is log10 S(omega) at its octave's shortest wave, whose omega the dispersion gives. Between two
// edges ln S runs linearly over ln omega, so that the power laws of wind seas are met exactly and not only at the
// edges; the longest octave goes on as omega^-5. What an octave holds is the integral of that, neither doubled nor
// tuned.

#include "core/spectra/compiled.h"

#include <math.h>

#include "core/math/scalar.h"
#include "core/base/misuse.h"

#define LN_10 2.302585092994046
#define LEAST_POWER -10.0
#define LARGEST_POWER 5.0

static double getShortest(int octave)
{
    return ldexp(1.0, octave - 4);
}

// log10 of density, of a sea with much in its long waves; what artists start from.
static const float defaultPowers[SW_OCTAVE_COUNT] = {-7.11f, -6.43f, -5.94f, -5.28f, -4.68f, -3.72f, -3.18f,
                                                     -2.61f, -1.94f, -1.12f, -0.86f, -0.37f, 0.04f,  -8.0f};

swOctaves swDefaultOctaves(void)
{
    swOctaves octaves = {.multiplier = 1.0f, .chop = 1.0f, .gravityScale = 1.0f, .limitByWind = true};
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        octaves.octaves[i] = (swOctave){defaultPowers[i], i < SW_OCTAVE_COUNT - 1, 1.0f, 1.0f};
    }
    return octaves;
}

swOctaves swDefaultSwellOctaves(void)
{
    swOctaves octaves = swDefaultOctaves();
    for (int i = 0; i < 8; ++i)
    {
        octaves.octaves[i].isEnabled = false;
    }
    return octaves;
}

swOctaveShape swMakeOctaveShape(const swOctaves* octaves, const swDispersion* dispersion)
{
    swOctaveShape shape = {.isLimited = octaves->limitByWind,
                           .wholeChop = (double)octaves->chop,
                           .wholeGravityScale = (double)octaves->gravityScale};
    for (int i = 0; i <= SW_OCTAVE_COUNT; ++i)
    {
        shape.omega[i] = swGetOmega(dispersion, SW_TURN / getShortest(i));
        shape.logOmega[i] = swLn(shape.omega[i]);
    }
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        const swOctave* octave = &octaves->octaves[i];
        shape.logDensity[i] = LN_10 * (double)octave->power;
        shape.isEnabled[i] = octave->isEnabled;
        shape.chop[i] = (double)octave->chop;
        shape.gravityScale[i] = (double)octave->gravityScale;
    }
    int last = SW_OCTAVE_COUNT;
    shape.logDensity[last] = shape.logDensity[last - 1] - 5.0 * (shape.logOmega[last] - shape.logOmega[last - 1]);
    return shape;
}

double swGetOctaveDensity(const swOctaveShape* shape, double omega)
{
    if (!(omega <= shape->omega[0] && omega > shape->omega[SW_OCTAVE_COUNT]))
    {
        return 0.0;
    }
    int octave = 0;
    while (omega <= shape->omega[octave + 1])
    {
        octave += 1;
    }
    if (!shape->isEnabled[octave])
    {
        return 0.0;
    }
    double step = shape->logOmega[octave + 1] - shape->logOmega[octave];
    double part = (swLn(omega) - shape->logOmega[octave]) / step;
    double rise = shape->logDensity[octave + 1] - shape->logDensity[octave];
    return swExp(shape->logDensity[octave] + part * rise);
}

int swFindOctave(double k)
{
    double wavelength = SW_TURN / k;
    int octave = 0;
    while (octave < SW_OCTAVE_COUNT - 1 && wavelength >= getShortest(octave + 1))
    {
        octave += 1;
    }
    return octave;
}

double swGetCompiledChop(const swCompiledSpectrum* spectrum, double k)
{
    const swOctaveShape* shape = &spectrum->octaves;
    return spectrum->kind == SW_SPECTRUM_OCTAVES ? shape->wholeChop * shape->chop[swFindOctave(k)] : 1.0;
}

double swGetCompiledGravityScale(const swCompiledSpectrum* spectrum, double k)
{
    const swOctaveShape* shape = &spectrum->octaves;
    return spectrum->kind == SW_SPECTRUM_OCTAVES ? shape->wholeGravityScale * shape->gravityScale[swFindOctave(k)]
                                                 : 1.0;
}

// ---- an equaliser from another spectrum ----

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
        double omega = swGetOmega(&source->dispersion, SW_TURN / getShortest(i));
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
