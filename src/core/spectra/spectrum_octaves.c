// SPDX-License-Identifier: MIT
// The equaliser. A power is log10 S(omega) at its octave's shortest wave, whose omega the dispersion gives. Between two
// edges ln S runs linearly over ln omega, so that the power laws of wind seas are met exactly and not only at the
// edges; the longest octave goes on as omega^-5. What an octave holds is the integral of that, neither doubled nor
// tuned.

#include "core/spectra/compiled.h"

#include <math.h>

#include "core/math/scalar.h"

#define LN_10 2.302585092994046

double swGetShortestOfOctave(int octave)
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
        shape.omega[i] = swGetOmega(dispersion, SW_TURN / swGetShortestOfOctave(i));
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
    while (octave < SW_OCTAVE_COUNT - 1 && wavelength >= swGetShortestOfOctave(octave + 1))
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
