// SPDX-License-Identifier: MIT
// JONSWAP and Pierson-Moskowitz; the formulas stand in spectrum.c.

#include "core/waves/compiled.h"

#include <math.h>

#include "core/math/scalar.h"
#include "core/waves/spreading.h"

double swGetFormulaDensity(const swCompiledSpectrum* spectrum, double omega)
{
    double ratio = spectrum->peakOmega / omega;
    if (!(omega > 0.0) || ratio > 5.0)
    {
        return 0.0; // exp(-781)
    }
    double ratio4 = ratio * ratio * ratio * ratio;
    double exponent = -1.25 * ratio4;
    if (spectrum->gamma > 1.0)
    {
        double sigma = omega <= spectrum->peakOmega ? 0.07 : 0.09;
        double distance = (omega - spectrum->peakOmega) / (sigma * spectrum->peakOmega);
        exponent += swLn(spectrum->gamma) * swExp(-0.5 * distance * distance);
    }
    double omega2 = omega * omega;
    return spectrum->level / (omega2 * omega2 * omega) * swExp(exponent);
}

// Where the panel that starts at omega ends: narrow where the density climbs by exp(-5/4 x^-4), 0.05 of the peak's
// frequency around the peak, then growing with omega. Order 8 on these is good to 1e-9.
static double getPanelEnd(const swCompiledSpectrum* spectrum, double omega)
{
    double x = omega / spectrum->peakOmega;
    double step = 0.05;
    if (x < 0.7)
    {
        step = 0.3 * x * x * x * x * x;
    }
    else if (x > 1.5)
    {
        step = 0.15 * x;
    }
    double end = x + step;
    if (x < 1.0 && end > 1.0)
    {
        end = 1.0; // sigma changes here
    }
    return end * spectrum->peakOmega;
}

void swIntegrateFormula(const swCompiledSpectrum* spectrum, double omega0, double omega1, swSpectrumMoments* moments)
{
    double begin = omega0 > 0.2 * spectrum->peakOmega ? omega0 : 0.2 * spectrum->peakOmega;
    while (begin < omega1)
    {
        double end = getPanelEnd(spectrum, begin);
        end = end < omega1 ? end : omega1;
        swAddSpectrumPanel(moments, swGetFormulaDensity, spectrum, begin, end);
        begin = end;
    }
}

static double getFormulaVariance(const swCompiledSpectrum* spectrum)
{
    // From 20 peak frequencies on the density is level omega^-5 within 1e-5, and holds 1e-5 of the variance.
    double end = 20.0 * spectrum->peakOmega;
    swSpectrumMoments moments = {0};
    swIntegrateFormula(spectrum, 0.0, end, &moments);
    return moments.zero + 0.25 * spectrum->level / (end * end * end * end);
}

void swPrepareFormula(swCompiledSpectrum* spectrum, const swSpectrumDef* def, double gravity)
{
    double wind = (double)def->windSpeed;
    double alpha = 0.0081;
    spectrum->gamma = 1.0;
    if (def->kind == SW_SPECTRUM_JONSWAP)
    {
        double fetch = (double)def->fetch;
        alpha = 0.076 * swPow(wind * wind / (fetch * gravity), 0.22);
        spectrum->peakOmega = 22.0 * swPow(gravity * gravity / (wind * fetch), 1.0 / 3.0);
        spectrum->gamma = (double)def->gamma;
    }
    else
    {
        spectrum->peakOmega = sqrt(sqrt(0.8 * 0.74)) * gravity / (1.026 * wind);
    }
    if (def->peakPeriod > 0.0f)
    {
        spectrum->peakOmega = SW_TURN / (double)def->peakPeriod;
    }
    spectrum->level = alpha * gravity * gravity;
    if (def->significantHeight > 0.0f)
    {
        double height = (double)def->significantHeight;
        spectrum->level *= height * height / (16.0 * getFormulaVariance(spectrum));
    }
    spectrum->spreadExponent = (double)def->spreadExponent;
    spectrum->spreadScale = swGetCosineSpreadScale(spectrum->spreadExponent);
}
