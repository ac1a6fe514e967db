// SPDX-License-Identifier: MIT
// Moments of a density over a panel of frequencies.

#include "core/spectra/compiled.h"

// Nodes and weights of Gauss-Legendre on [-1, 1], order 8, the positive half.
static const double gaussNodes[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
static const double gaussWeights[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

void swAddSpectrumMoments(swSpectrumMoments* moments, const swCompiledSpectrum* spectrum, double omega, double variance)
{
    moments->minusOne += variance / omega;
    moments->zero += variance;
    moments->one += variance * omega;
    moments->two += variance * omega * omega;
    if (moments->isFull)
    {
        double k = swGetWaveNumber(&spectrum->dispersion, omega);
        moments->slope += variance * k * k;
    }
}

void swAddSpectrumPanel(swSpectrumMoments* moments, swSpectrumDensityFcn density, const swCompiledSpectrum* spectrum,
                        double omega0, double omega1)
{
    double middle = 0.5 * (omega0 + omega1);
    double half = 0.5 * (omega1 - omega0);
    double zero = moments->zero, one = moments->one;
    for (int i = 0; i < 4; ++i)
    {
        double low = middle - half * gaussNodes[i];
        double high = middle + half * gaussNodes[i];
        swAddSpectrumMoments(moments, spectrum, low, half * gaussWeights[i] * density(spectrum, low));
        swAddSpectrumMoments(moments, spectrum, high, half * gaussWeights[i] * density(spectrum, high));
    }
    double variance = moments->zero - zero;
    if (moments->isFull && spectrum->kind != SW_SPECTRUM_TABLE && variance > 0.0)
    {
        // Directions change slowly: one look at the panel's mean frequency.
        double r1, r2;
        swSpread spread = swFindSpread(&spectrum->spreading, (moments->one - one) / variance);
        swGetSpreadMoments(&spread, &r1, &r2);
        moments->r1 += variance * r1;
    }
}
