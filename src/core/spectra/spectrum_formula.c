// SPDX-License-Identifier: MIT
// Spectra by formula, which stand in spectrum.c: their density, its integrals, its peak.

#include "core/spectra/compiled.h"

#include <math.h>

#include "core/math/scalar.h"

// Below this part of the peak's frequency there is less than exp(-74) of anything.
#define FIRST_RATIO 0.36

// ---- densities ----

double swGetWindLimit(double peakOmega, double omega)
{
    double ratio = peakOmega / omega;
    return ratio > 5.0 ? 0.0 : swExp(-1.25 * ratio * ratio * ratio * ratio);
}

double swGetDevelopedOmega(double gravity, double windSpeed)
{
    return sqrt(sqrt(0.8 * 0.74)) * gravity / (1.026 * windSpeed);
}

// level omega^-5 with a peak: JONSWAP, Pierson-Moskowitz, Phillips.
static double getPeakedDensity(const swCompiledSpectrum* spectrum, double omega)
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

double swGetDepthFactor(double gravity, double depth, double omega)
{
    double scaled = omega * sqrt(depth / gravity);
    if (isinf(depth) || scaled > 6.0)
    {
        return 1.0; // to 1e-15
    }
    swDispersion dispersion = {gravity, 0.0, depth};
    double x = swGetWaveNumber(&dispersion, omega) * depth;
    double t = swTanh(x);
    // tanh^2 x / (1 + 2 x / sinh 2x), as sinh 2x = 2 t / (1 - t^2)
    return t > 0.0 ? t * t * t / (t + x * (1.0 - t * t)) : 0.0;
}

// Over frequency instead of wave number.
static double getUnifiedDensity(const swCompiledSpectrum* spectrum, double omega)
{
    if (!(omega > 0.2 * spectrum->peakOmega))
    {
        return 0.0;
    }
    swDispersion deep = spectrum->dispersion;
    deep.depth = (double)INFINITY;
    double k = swGetWaveNumber(&deep, omega);
    return spectrum->level * swGetElfouhailyDensity(&spectrum->elfouhaily, k) / swGetGroupSpeed(&deep, k);
}

static double getOctavesDensity(const swCompiledSpectrum* spectrum, double omega)
{
    double density = spectrum->level * swGetOctaveDensity(&spectrum->octaves, omega);
    bool isLimited = spectrum->octaves.isLimited && density > 0.0;
    return isLimited ? density * swGetWindLimit(spectrum->peakOmega, omega) : density;
}

double swGetFormulaDensity(const swCompiledSpectrum* spectrum, double omega)
{
    switch (spectrum->kind)
    {
    case SW_SPECTRUM_TMA:
    {
        double deep = getPeakedDensity(spectrum, omega);
        return deep > 0.0 ? deep * swGetDepthFactor(spectrum->dispersion.gravity, spectrum->dispersion.depth, omega)
                          : 0.0;
    }
    case SW_SPECTRUM_ELFOUHAILY:
        return getUnifiedDensity(spectrum, omega);
    case SW_SPECTRUM_OCTAVES:
        return getOctavesDensity(spectrum, omega);
    default:
        return getPeakedDensity(spectrum, omega);
    }
}

// ---- integrals ----

// Whether there is nothing below FIRST_RATIO.
static bool isCut(const swCompiledSpectrum* spectrum)
{
    return spectrum->kind != SW_SPECTRUM_OCTAVES || spectrum->octaves.isLimited;
}

// Where the panel that starts at omega ends: narrow where the density climbs by exp(-5/4 x^-4), 0.05 of the peak's
// frequency around the peak, then growing with omega; and never across a break. Order 8 on these is good to 1e-9.
static double getPanelEnd(const swCompiledSpectrum* spectrum, double omega)
{
    double x = omega / spectrum->peakOmega;
    double step = 0.05;
    if (x > 1.5 || !isCut(spectrum))
    {
        step = 0.15 * x;
    }
    else if (x < 0.7)
    {
        step = 0.3 * x * x * x * x * x;
    }
    double end = (x + step) * spectrum->peakOmega;
    for (int i = 0; i < spectrum->breakCount; ++i)
    {
        if (spectrum->breaks[i] > omega)
        {
            return spectrum->breaks[i] < end ? spectrum->breaks[i] : end;
        }
    }
    return end;
}

void swIntegrateFormula(const swCompiledSpectrum* spectrum, double omega0, double omega1, swSpectrumMoments* moments)
{
    double first = isCut(spectrum) ? FIRST_RATIO * spectrum->peakOmega : 0.0;
    double last = omega1;
    if (spectrum->kind == SW_SPECTRUM_OCTAVES)
    {
        double longest = spectrum->octaves.omega[SW_OCTAVE_COUNT], shortest = spectrum->octaves.omega[0];
        first = first > longest ? first : longest;
        last = last < shortest ? last : shortest;
    }
    double begin = omega0 > first ? omega0 : first;
    while (begin < last)
    {
        double end = getPanelEnd(spectrum, begin);
        end = end < last ? end : last;
        swAddSpectrumPanel(moments, swGetFormulaDensity, spectrum, begin, end);
        begin = end;
    }
}

// Of all frequencies.
static double getFormulaVariance(const swCompiledSpectrum* spectrum)
{
    swSpectrumMoments moments = {0};
    if (spectrum->kind == SW_SPECTRUM_ELFOUHAILY || spectrum->kind == SW_SPECTRUM_OCTAVES)
    {
        swIntegrateFormula(spectrum, 0.0, 3000.0, &moments); // waves of 2 mm
        return moments.zero;
    }
    // From 20 peak frequencies on, in deep water, the density is level omega^-5 within 1e-5, and holds 1e-5 of the
    // variance.
    double end = 20.0 * spectrum->peakOmega;
    if (spectrum->kind == SW_SPECTRUM_TMA)
    {
        double deep = 5.0 * sqrt(spectrum->dispersion.gravity / spectrum->dispersion.depth);
        end = deep > end ? deep : end;
    }
    swIntegrateFormula(spectrum, 0.0, end, &moments);
    return moments.zero + 0.25 * spectrum->level / (end * end * end * end);
}

// ---- the peak ----

double swFindFormulaPeak(const swCompiledSpectrum* spectrum, double omega0, double omega1)
{
    enum
    {
        STEPS = 400
    };
    double low = FIRST_RATIO * spectrum->peakOmega;
    if (!isCut(spectrum))
    {
        low = 1.0000001 * spectrum->octaves.omega[SW_OCTAVE_COUNT];
    }
    low = omega0 > low ? omega0 : low < omega1 ? low : omega1;
    double factor = swExp(swLn(omega1 / low) / STEPS);
    double best = low, largest = swGetFormulaDensity(spectrum, low), omega = low;
    for (int i = 1; i <= STEPS; ++i)
    {
        omega = i < STEPS ? omega * factor : omega1;
        double density = swGetFormulaDensity(spectrum, omega);
        best = density > largest ? omega : best;
        largest = density > largest ? density : largest;
    }
    // Narrow down, within what was asked.
    double begin = best / factor > low ? best / factor : low, end = best * factor < omega1 ? best * factor : omega1;
    for (int i = 0; i < 60; ++i)
    {
        double a = begin + 0.382 * (end - begin), b = begin + 0.618 * (end - begin);
        bool isLeft = swGetFormulaDensity(spectrum, a) >= swGetFormulaDensity(spectrum, b);
        begin = isLeft ? begin : a;
        end = isLeft ? b : end;
    }
    double middle = 0.5 * (begin + end);
    return swGetFormulaDensity(spectrum, middle) >= largest ? middle : best;
}

// ---- preparation ----

double swGetGrownOmega(swGrowthLaw law, double scaledFetch)
{
    return law == SW_GROWTH_CUBE_ROOT ? 22.0 * swPow(scaledFetch, -1.0 / 3.0)
                                      : SW_TURN * 3.5 * swPow(scaledFetch, -0.33);
}

static void prepareJonswap(swCompiledSpectrum* spectrum, const swSpectrumDef* def, double gravity)
{
    double wind = (double)def->windSpeed;
    double scaledFetch = gravity * (double)def->fetch / (wind * wind);
    spectrum->level = 0.076 * swPow(scaledFetch, -0.22) * gravity * gravity;
    spectrum->peakOmega = swGetGrownOmega(def->growth, scaledFetch) * gravity / wind;
    spectrum->gamma = (double)def->gamma;
}

static void prepareElfouhaily(swCompiledSpectrum* spectrum, const swSpectrumDef* def, double gravity)
{
    double wind = (double)def->windSpeed;
    double fetch = gravity * (double)def->fetch / (wind * wind);
    double age = 0.84 * swPow(swTanh(swPow(fetch / 2.2e4, 0.4)), -0.75);
    if (def->peakPeriod > 0.0f)
    {
        age = wind * SW_TURN / ((double)def->peakPeriod * gravity);
    }
    spectrum->level = 1.0;
    age = age < 0.84 ? 0.84 : age > 5.0 ? 5.0 : age;
    spectrum->elfouhaily = swMakeElfouhaily(gravity, wind, age, swGetDragCoefficient(wind));
    if (def->peakPeriod > 0.0f) // of a swell as well, whose age has no law
    {
        spectrum->elfouhaily.peakSpeed = gravity * (double)def->peakPeriod / SW_TURN;
        spectrum->elfouhaily.peakNumber = gravity / (spectrum->elfouhaily.peakSpeed * spectrum->elfouhaily.peakSpeed);
    }
    spectrum->peakOmega = sqrt(gravity * spectrum->elfouhaily.peakNumber);
}

static void prepareKind(swCompiledSpectrum* spectrum, const swSpectrumDef* def, double gravity)
{
    spectrum->gamma = 1.0;
    spectrum->level = 0.0081 * gravity * gravity;
    switch (def->kind)
    {
    case SW_SPECTRUM_JONSWAP:
    case SW_SPECTRUM_TMA:
        prepareJonswap(spectrum, def, gravity);
        break;
    case SW_SPECTRUM_ELFOUHAILY:
        prepareElfouhaily(spectrum, def, gravity);
        break;
    case SW_SPECTRUM_PHILLIPS:
        spectrum->peakOmega = sqrt(sqrt(0.8)) * gravity / (double)def->windSpeed;
        break;
    case SW_SPECTRUM_OCTAVES:
        spectrum->level = (double)def->octaves.multiplier * (double)def->octaves.multiplier;
        spectrum->octaves = swMakeOctaveShape(&def->octaves, &spectrum->dispersion);
        spectrum->peakOmega = swGetDevelopedOmega(gravity, (double)def->windSpeed);
        break;
    default:
        spectrum->peakOmega = swGetDevelopedOmega(gravity, (double)def->windSpeed);
        break;
    }
    if (def->peakPeriod > 0.0f && def->kind != SW_SPECTRUM_ELFOUHAILY)
    {
        spectrum->peakOmega = SW_TURN / (double)def->peakPeriod;
    }
}

static void addBreak(swCompiledSpectrum* spectrum, double omega)
{
    int i = spectrum->breakCount++;
    for (; i > 0 && spectrum->breaks[i - 1] > omega; --i)
    {
        spectrum->breaks[i] = spectrum->breaks[i - 1];
    }
    spectrum->breaks[i] = omega;
}

static void findBreaks(swCompiledSpectrum* spectrum)
{
    addBreak(spectrum, spectrum->peakOmega); // sigma changes here
    double ratios[2];
    int jumps = swGetSpreadJumps(&spectrum->spreading, ratios);
    for (int i = 0; i < jumps; ++i)
    {
        addBreak(spectrum, ratios[i] * spectrum->peakOmega);
    }
    for (int i = 0; i <= SW_OCTAVE_COUNT && spectrum->kind == SW_SPECTRUM_OCTAVES; ++i)
    {
        addBreak(spectrum, spectrum->octaves.omega[i]);
    }
}

bool swPrepareFormula(swCompiledSpectrum* spectrum, const swSpectrumDef* def, swComplaint* complaint)
{
    const swDispersion* dispersion = &spectrum->dispersion;
    prepareKind(spectrum, def, dispersion->gravity);
    spectrum->spreading = swMakeSpreadModel(def, dispersion->gravity, dispersion->surfaceTension, spectrum->peakOmega);
    findBreaks(spectrum);
    if (def->significantHeight > 0.0f)
    {
        double height = (double)def->significantHeight;
        double variance = getFormulaVariance(spectrum);
        if (!(variance > 1e-20))
        {
            return swComplain(complaint, "The spectrum cannot be made %g m high: it has no energy.", height);
        }
        spectrum->level *= height * height / (16.0 * variance);
    }
    return true;
}
