// SPDX-License-Identifier: MIT
#include "core/waves/wind_level.h"

#include <math.h>

#include "core/spectra/compiled.h"
#include "core/waves/waves_fft.h"

// Level of the equilibrium range over g U. With 4 beta I = 0.12 [Thomson 2013] it stands for u* = U / 32. Seas after
// [Pierson 1964] have 0.0045, after [Hasselmann 1973] 0.0035 (10 km) to 0.0055 (300 km); winds at a buoy off Boston
// over six days fit 0.0037 best.
#define LEVEL 0.0037

// A level is a mean over AVERAGE steps. It must be held over HELD means, each a step further: an octave of frequency.
#define AVERAGE 4
#define HELD 5

#define STEPS (SW_MAX_BANDS * SW_WIND_STEPS)

// Waves break only where they are steep enough. Below SMOOTHEST = A omega / g^2 at the short end of the range, the
// level is that of a swell's flank, which no wind keeps up; above ROUGHEST it counts in full. Wind seas have 0.006 and
// more [Hasselmann 1973].
#define SMOOTHEST 0.002
#define ROUGHEST 0.004

// rad/m of a step's shortest wave.
static double getStepNumber(int step)
{
    static const double roots[SW_WIND_STEPS] = {1.0, 1.1892071150027210, 1.4142135623730951, 1.6817928305074290};
    return SW_TURN / ldexp(roots[step % SW_WIND_STEPS], step / SW_WIND_STEPS - 4);
}

// Of S(k) = A / 2 g^-1/2 k^-5/2, the same as A omega^-4 over deep water and the law that shallow water keeps.
static double getLevel(double variance, double gravity, double k0, double k1)
{
    return 3.0 * sqrt(gravity) * variance / (1.0 / (k0 * sqrt(k0)) - 1.0 / (k1 * sqrt(k1))) / LEVEL;
}

void swFillWindLevels(const swCompiledSpectrum* spectrum, const swSpectrumDef* def, swBandModes* bands)
{
    if (swHasSpectrumWind(def))
    {
        for (int band = 0; band < SW_MAX_BANDS; ++band)
        {
            bands[band].knownWind = def->windSpeed;
        }
        return;
    }
    swDispersion dispersion = swGetCompiledDispersion(spectrum);
    for (int step = 0; step < STEPS; ++step)
    {
        double k1 = getStepNumber(step);
        double k0 = getStepNumber(step + 1);
        double variance = swIntegrateCompiled(spectrum, swGetOmega(&dispersion, k0), swGetOmega(&dispersion, k1));
        bands[step / SW_WIND_STEPS].wind[step % SW_WIND_STEPS] = (float)getLevel(variance, dispersion.gravity, k0, k1);
    }
}

// 0 to 1 as waves of this level become steep enough to break.
static double getRoughness(double level, double gravity, double k)
{
    double steepness = LEVEL * level * sqrt(gravity * k) / gravity;
    double x = fmin(fmax((steepness - SMOOTHEST) / (ROUGHEST - SMOOTHEST), 0.0), 1.0);
    return x * x * (3.0 - 2.0 * x);
}

float swFindWind(const float* levels, double gravity)
{
    double means[STEPS - AVERAGE + 1];
    for (int i = 0; i <= STEPS - AVERAGE; ++i)
    {
        means[i] = 0.0;
        for (int k = 0; k < AVERAGE; ++k)
        {
            means[i] += (double)levels[i + k] / AVERAGE;
        }
    }
    double wind = 0.0;
    for (int i = 0; i <= STEPS - AVERAGE + 1 - HELD; ++i)
    {
        double held = means[i];
        for (int k = 1; k < HELD; ++k)
        {
            held = fmin(held, means[i + k]);
        }
        wind = fmax(wind, held * getRoughness(means[i], gravity, getStepNumber(i + AVERAGE / 2)));
    }
    return fminf((float)wind, SW_STRONGEST_WIND);
}
