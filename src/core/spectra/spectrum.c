// SPDX-License-Identifier: MIT
// Directional wave spectra. Inside, densities are over angular frequency, S(omega) = S(f) / (2 pi).
//
// JONSWAP [Hasselmann 1973]:
//   S = alpha g^2 omega^-5 exp(-5/4 (omega_p / omega)^4) gamma^exp(-(omega - omega_p)^2 / (2 sigma^2 omega_p^2)),
//   sigma = 0.07 up to omega_p and 0.09 above, alpha = 0.076 x^-0.22, omega_p = 2 pi 3.5 (g / U) x^-0.33, x = g F /
//   U^2; or, by another growth law, omega_p = 22 (g / U) x^(-1/3).
// Pierson-Moskowitz [Pierson 1964]:
//   S = 0.0081 g^2 omega^-5 exp(-0.74 (g / (U19.5 omega))^4), with the wind at 19.5 m taken as 1.026 U10: the same
//   shape with gamma = 1 and omega_p = (0.8 * 0.74)^(1/4) g / U19.5.
// Phillips [Phillips 1958], with the cut-off of [Tessendorf 2001] at waves longer than L = U^2 / g, exp(-1 / (k L)^2):
//   S = 0.0081 g^2 omega^-5 exp(-(g / (U omega))^4), so omega_p = 0.8^(1/4) g / U.
// TMA [Bouws 1985]: JONSWAP times [Kitaigorodskii 1975]
//   Phi = tanh^2(k d) / (1 + 2 k d / sinh(2 k d)), k of gravity waves of that omega at depth d.
// Elfouhaily: by wave number, in spectrum_elfouhaily.c; S(omega) = S(k) / c_g over deep water.
// Octaves: in spectrum_octaves.c.
// All formulas are over the frequency that a wave keeps when it comes over a sea floor.
// Table: in spectrum_table.c.

#include "core/spectra/compiled.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "core/spectra/spreading.h"

bool swHasSpectrumWind(const swSpectrumDef* def)
{
    bool isFree = def->kind == SW_SPECTRUM_TABLE || (def->kind == SW_SPECTRUM_OCTAVES && !def->octaves.limitByWind);
    return def->hasWind || (!isFree && def->significantHeight == 0.0f && def->peakPeriod == 0.0f);
}

bool swPrepareSpectrum(swCompiledSpectrum* spectrum, const swSpectrumDef* def, double gravity, double surfaceTension,
                       swComplaint* complaint)
{
    SW_ASSERT(def->internalValue == SW_DEF_COOKIE);
    memset(spectrum, 0, sizeof(*spectrum));
    if (!swCheckSpectrumDef(complaint, def))
    {
        return false;
    }
    spectrum->kind = def->kind;
    spectrum->dispersion = (swDispersion){gravity, surfaceTension, (double)def->depth};
    spectrum->direction = (double)def->direction;
    if (def->kind == SW_SPECTRUM_TABLE)
    {
        return swPrepareTable(spectrum, def, complaint);
    }
    return swPrepareFormula(spectrum, def, complaint);
}

static swResult copyTable(const swHost* host, swCompiledSpectrum* spectrum)
{
    swSpectrumTable* table = &spectrum->table;
    size_t frequencyCount = (size_t)table->frequencyCount;
    size_t densityCount = frequencyCount * (size_t)table->directionCount;
    spectrum->memorySize = (2 * frequencyCount + densityCount) * sizeof(float);
    float* memory = swAllocate(host, spectrum->memorySize);
    if (memory == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for a spectrum table of %zu bytes.", spectrum->memorySize);
    }
    memcpy(memory, table->frequencies, frequencyCount * sizeof(float));
    memcpy(memory + frequencyCount, table->bandwidths, frequencyCount * sizeof(float));
    memcpy(memory + 2 * frequencyCount, table->density, densityCount * sizeof(float));
    table->frequencies = memory;
    table->bandwidths = memory + frequencyCount;
    table->density = memory + 2 * frequencyCount;
    spectrum->memory = memory;
    return SW_SUCCESS;
}

swResult swCompileSpectrum(const swHost* host, const swSpectrumDef* def, double gravity, double surfaceTension,
                           swCompiledSpectrum** spectrum)
{
    *spectrum = NULL;
    swCompiledSpectrum* compiled = swAllocate(host, sizeof(*compiled));
    if (compiled == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for a spectrum of %zu bytes.", sizeof(*compiled));
    }
    swComplaint complaint;
    swResult result = SW_SUCCESS;
    if (!swPrepareSpectrum(compiled, def, gravity, surfaceTension, &complaint))
    {
        result = swFail(host, SW_ERROR_INVALID, "%s", complaint.text);
    }
    else if (compiled->kind == SW_SPECTRUM_TABLE)
    {
        result = copyTable(host, compiled);
    }
    else
    {
        swTabulateSpreadScales(&compiled->spreading);
    }
    if (result != SW_SUCCESS)
    {
        swFree(host, compiled, sizeof(*compiled));
        return result;
    }
    *spectrum = compiled;
    return SW_SUCCESS;
}

void swFreeCompiledSpectrum(const swHost* host, swCompiledSpectrum* spectrum)
{
    if (spectrum != NULL)
    {
        swFree(host, spectrum->memory, spectrum->memorySize);
        swFree(host, spectrum, sizeof(*spectrum));
    }
}

swDispersion swGetCompiledDispersion(const swCompiledSpectrum* spectrum)
{
    return spectrum->dispersion;
}

double swGetCompiledDensity(const swCompiledSpectrum* spectrum, double omega)
{
    if (spectrum->kind == SW_SPECTRUM_TABLE)
    {
        return swGetTableDensity(spectrum, omega);
    }
    return swGetFormulaDensity(spectrum, omega);
}

static double getSpreading(const swCompiledSpectrum* spectrum, double omega, double theta)
{
    if (spectrum->kind == SW_SPECTRUM_TABLE)
    {
        double density = swGetTableDensity(spectrum, omega);
        return density > 0.0 ? swGetTableDensity2(spectrum, omega, theta) / density : 0.0;
    }
    swSpread spread = swFindSpread(&spectrum->spreading, omega);
    return swGetSpread(&spread, theta - spectrum->direction);
}

double swGetCompiledDensity2(const swCompiledSpectrum* spectrum, double omega, double theta)
{
    if (spectrum->kind == SW_SPECTRUM_TABLE)
    {
        return swGetTableDensity2(spectrum, omega, theta);
    }
    double density = swGetCompiledDensity(spectrum, omega);
    return density > 0.0 ? density * getSpreading(spectrum, omega, theta) : 0.0;
}

void swIntegrateMoments(const swCompiledSpectrum* spectrum, double omega0, double omega1, swSpectrumMoments* moments)
{
    if (spectrum->kind == SW_SPECTRUM_TABLE)
    {
        swIntegrateTable(spectrum, omega0, omega1, moments);
    }
    else
    {
        swIntegrateFormula(spectrum, omega0, omega1, moments);
    }
}

double swIntegrateCompiled(const swCompiledSpectrum* spectrum, double omega0, double omega1)
{
    swSpectrumMoments moments = {0};
    swIntegrateMoments(spectrum, omega0, omega1, &moments);
    return moments.zero;
}

static_assert(SW_MAX_SPECTRUM_BINS == SW_MAX_TABLE_FREQUENCIES + 2, "one bin below and one above a table's");

int swFindCompiledBin(const swCompiledSpectrum* spectrum, double omega)
{
    return spectrum->kind == SW_SPECTRUM_TABLE ? swFindTableBin(spectrum, omega / SW_TURN) + 1 : 0;
}

int swGetCompiledBins(const swCompiledSpectrum* spectrum, double omega0, double omega1, double* variances)
{
    if (spectrum->kind != SW_SPECTRUM_TABLE)
    {
        variances[0] = swIntegrateCompiled(spectrum, omega0, omega1);
        return 1;
    }
    int count = spectrum->table.frequencyCount;
    for (int i = 0; i < count; ++i)
    {
        double whole = spectrum->scale * spectrum->energy[i] * (spectrum->edges[i + 1] - spectrum->edges[i]);
        variances[i + 1] = whole * swGetBinPart(spectrum, i, omega0 / SW_TURN, omega1 / SW_TURN);
    }
    variances[0] = 0.0;
    double tail = SW_TURN * spectrum->highEdge;
    variances[count + 1] = tail < omega1 ? swIntegrateCompiled(spectrum, tail > omega0 ? tail : omega0, omega1) : 0.0;
    return count + 2;
}

bool swGetCompiledBinMean(const swCompiledSpectrum* spectrum, int bin, double* x, double* z)
{
    int count = spectrum->kind == SW_SPECTRUM_TABLE ? spectrum->table.frequencyCount : 0;
    int first = bin - 1, last = bin; // rows; the tail has the directions of several
    if (bin == count + 1)
    {
        first = count - swGetTailBins(&spectrum->table);
        last = count;
    }
    if (bin < 1 || bin > count + 1 || count == 0)
    {
        return false;
    }
    double energy = 0.0;
    *x = *z = 0.0;
    for (int i = first; i < last; ++i)
    {
        double rowX, rowZ;
        swGetBinVector(spectrum, i, &rowX, &rowZ);
        *x += rowX;
        *z += rowZ;
        energy += spectrum->energy[i];
    }
    *x = energy > 0.0 ? *x / energy : 0.0;
    *z = energy > 0.0 ? *z / energy : 0.0;
    return energy > 0.0;
}

void swSpectrum_GetDensities(const swSpectrumDef* def, int count, const float* frequencies, float* densities)
{
    SW_REQUIRE_VOID(count <= 0 || (frequencies != NULL && densities != NULL), NULL,
                    "swSpectrum_GetDensities() needs frequencies and a place for their densities");
    swCompiledSpectrum spectrum;
    swComplaint complaint;
    SW_ASSERT(def != NULL);
    bool isFine =
        def != NULL && swPrepareSpectrum(&spectrum, def, SW_STANDARD_GRAVITY, SW_STANDARD_SURFACE_TENSION, &complaint);
    for (int i = 0; i < count; ++i)
    {
        double omega = SW_TURN * (double)frequencies[i];
        densities[i] = isFine ? (float)(swGetCompiledDensity(&spectrum, omega) * SW_TURN) : 0.0f;
    }
}

float swSpectrum_GetDensity(const swSpectrumDef* def, float frequency)
{
    float density;
    swSpectrum_GetDensities(def, 1, &frequency, &density);
    return density;
}

float swSpectrum_GetSpreading(const swSpectrumDef* def, float frequency, float direction)
{
    SW_REQUIRE(def != NULL, 0.0f, NULL, "swSpectrum_GetSpreading() needs a def");
    swCompiledSpectrum spectrum;
    swComplaint complaint;
    if (!swPrepareSpectrum(&spectrum, def, SW_STANDARD_GRAVITY, SW_STANDARD_SURFACE_TENSION, &complaint))
    {
        return 0.0f;
    }
    return (float)getSpreading(&spectrum, SW_TURN * (double)frequency, (double)direction);
}
