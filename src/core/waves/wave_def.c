// SPDX-License-Identifier: MIT
// What the def of a wave system is by default, and what it must hold.

#include <math.h>

#include "core/base/host.h"
#include "core/waves/waves.h"

swWaveSystemDef swDefaultWaveSystemDef(void)
{
    return (swWaveSystemDef){
        .spectrum = swDefaultSpectrumDef(),
        .method = SW_WAVES_FFT,
        .resolution = 128,
        .tileWaves = 32,
        .componentsPerOctave = 8,
        .leastJacobian = 0.1f,
        .minWavelength = 0.0625f,
        .maxWavelength = 4096.0f,
        .chop = 1.0f,
        .weight = 1.0f,
        .seed = 1,
        .internalValue = SW_DEF_COOKIE,
    };
}

static bool isPowerOfTwo(int value)
{
    return value > 0 && (value & (value - 1)) == 0;
}

static swResult checkTiles(const swHost* host, const swWaveSystemDef* def)
{
    if (!isPowerOfTwo(def->resolution) || def->resolution < 16 || def->resolution > 512)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "a wave system's resolution is %d; it must be a power of two in [16, 512]", def->resolution);
    }
    if (def->tileWaves < 4 || def->tileWaves > def->resolution / 4)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "a wave system's tileWaves is %d; with resolution %d it must be in [4, %d]", def->tileWaves,
                      def->resolution, def->resolution / 4);
    }
    return SW_SUCCESS;
}

static bool isWithin(float value, double least, double most)
{
    return (double)value >= least && (double)value <= most; // false for NaN
}

static swResult checkComponents(const swHost* host, const swWaveSystemDef* def)
{
    if (def->componentCount < 0 || def->componentCount > SW_MAX_FREE_WAVES ||
        (def->componentCount > 0 && def->components == NULL))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's components are %d at %s; it may have up to %d",
                      def->componentCount, def->components == NULL ? "NULL" : "an address", SW_MAX_FREE_WAVES);
    }
    for (int i = 0; i < def->componentCount; ++i)
    {
        const swWaveComponent* c = &def->components[i];
        if (!isWithin(c->wavelength, 0.0625, 4096.0) || !isWithin(c->direction, -1000.0, 1000.0) ||
            !isWithin(c->amplitude, 0.0, 40.0) || !isWithin(c->phase, -1e6, 1e6))
        {
            return swFail(
                host, SW_ERROR_INVALID,
                "component %d of a wave system has wavelength %g m (0.0625 to 4096), direction %g rad (-1000 to "
                "1000), amplitude %g m (0 to 40) and phase %g rad (-1e6 to 1e6)",
                i, (double)c->wavelength, (double)c->direction, (double)c->amplitude, (double)c->phase);
        }
    }
    return SW_SUCCESS;
}

static swResult checkGerstner(const swHost* host, const swWaveSystemDef* def)
{
    if (def->componentsPerOctave < 1 || def->componentsPerOctave > 32)
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's componentsPerOctave is %d; it must be in [1, 32]",
                      def->componentsPerOctave);
    }
    if (!isWithin(def->reverseWeight, 0.0, 1.0) || !isWithin(def->directionVariance, 0.0, 3.1416))
    {
        return swFail(host, SW_ERROR_INVALID,
                      "a wave system's reverseWeight is %g (0 to 1) and its directionVariance %g rad (0 to pi)",
                      (double)def->reverseWeight, (double)def->directionVariance);
    }
    if (!isWithin(def->leastJacobian, -10.0, 0.9))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's leastJacobian is %g; it must be in [-10, 0.9]",
                      (double)def->leastJacobian);
    }
    return checkComponents(host, def);
}

static swResult checkWaves(const swHost* host, const swWaveSystemDef* def)
{
    if (!(def->minWavelength >= 0.0625f && def->minWavelength < def->maxWavelength && def->maxWavelength <= 4096.0f))
    {
        return swFail(host, SW_ERROR_INVALID,
                      "a wave system's wavelengths are %g to %g m; they must ascend within 0.0625 to 4096",
                      (double)def->minWavelength, (double)def->maxWavelength);
    }
    if (!(def->chop >= 0.0f && def->chop <= 2.0f))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's chop is %g; it must be in [0, 2]", (double)def->chop);
    }
    if (!(def->weight >= 0.0f && def->weight <= 10.0f))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's weight is %g; it must be in [0, 10]",
                      (double)def->weight);
    }
    if (!(def->loopPeriod >= 0.0f && (double)def->loopPeriod <= SW_LARGEST_TIME))
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's loop period is %g s; it must be in [0, %g]",
                      (double)def->loopPeriod, SW_LARGEST_TIME);
    }
    return SW_SUCCESS;
}

swResult swCheckWaveSystemDef(const swHost* host, const swWaveSystemDef* def)
{
    if ((unsigned)def->method >= SW_WAVE_METHOD_COUNT)
    {
        return swFail(host, SW_ERROR_INVALID, "a wave system's method is %d; it must be in [0, %d]", (int)def->method,
                      SW_WAVE_METHOD_COUNT - 1);
    }
    swResult result = swCheckSpectrum(host, &def->spectrum);
    result = result == SW_SUCCESS ? checkWaves(host, def) : result;
    if (result == SW_SUCCESS)
    {
        result = def->method == SW_WAVES_FFT ? checkTiles(host, def) : checkGerstner(host, def);
    }
    return result;
}
