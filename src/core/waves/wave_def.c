// SPDX-License-Identifier: MIT
#include "core/base/host.h"
#include "core/spectra/spectrum.h"
#include "core/waves/wave_def.h"
#include "seaway/math.h"

#define TILES SW_KIND(SW_WAVES_FFT)
#define SINGLE SW_KIND(SW_WAVES_GERSTNER)

// ---- one wave given by hand ----

#define SW_DEF swWaveComponent
static const swField componentFields[] = {
    SW_NUMBER(wavelength, "m", SW_WITHIN(0.0625, 4096.0), 0.0625, .key = "wavelength_m", .label = "length",
              SW_LOG_KNOB(0.0625, 4096.0)),
    SW_NUMBER(direction, "deg", SW_WITHIN(-1000.0, 1000.0), 0.0, .key = "direction_from_deg", .label = "from",
              .tip = "Where it comes from, clockwise from north", .form = SW_FORM_BEARING, SW_KNOB(0.0, 360.0)),
    SW_NUMBER(amplitude, "m", SW_WITHIN(0.0, 40.0), 0.0, .key = "amplitude_m", .label = "amplitude",
              .tip = "Half its height", SW_LOG_KNOB(1e-3, 40.0)),
    SW_NUMBER(phase, "deg", SW_WITHIN(-1e6, 1e6), 0.0, .key = "phase_deg", .label = "phase",
              .tip = "At the origin at time 0", .form = SW_FORM_DEGREES, SW_KNOB(-360.0, 360.0)),
};
#undef SW_DEF

const swFields swWaveComponentFields =
    SW_PART_FIELDS(swWaveComponent, "components", "wave given by hand", componentFields);

// ---- a system ----

static const char* const methodWords[] = {"fft", "gerstner", NULL};
static const char* const methodNames[] = {"Fourier transforms", "few waves (Gerstner)", NULL};

#define SW_DEF swWaveSystemDef
static const swField systemFields[] = {
    SW_PART(spectrum, &swSpectrumFields, .key = NULL, .label = "spectrum"),
    SW_CHOICE(method, methodWords, methodNames, SW_WAVES_FFT, .key = "method", .label = "made by"),
    SW_NUMBER(resolution, "", SW_WITHIN(16.0, 512.0), 128.0, .key = "resolution", .label = "resolution",
              .tip = "Samples along a tile's side, a power of two", SW_LOG_KNOB(16.0, 512.0), .kinds = TILES),
    SW_NUMBER(tileWaves, "", SW_WITHIN(4.0, 128.0), 32.0, .key = "tile_waves", .label = "waves a tile",
              .tip = "Shortest waves of a band along a tile's side: more repeat less", SW_KNOB(4.0, 128.0),
              .kinds = TILES),
    SW_NUMBER(componentsPerOctave, "", SW_WITHIN(1.0, 32.0), 8.0, .key = "components_per_octave",
              .label = "waves an octave", SW_KNOB(1.0, 32.0), .kinds = SINGLE),
    SW_NUMBER(reverseWeight, "", SW_WITHIN(0.0, 1.0), 0.0, .key = "reverse_weight", .label = "twins back",
              .tip = "Height of a twin of each wave that runs the other way: 1 makes standing waves", SW_KNOB(0.0, 1.0),
              .kinds = SINGLE),
    SW_NUMBER(directionVariance, "deg", SW_WITHIN(0.0, SW_PI), 0.0, .key = "direction_variance_deg",
              .label = "directions within", .zero = "as it spreads", .form = SW_FORM_DEGREES, SW_KNOB(0.0, 180.0),
              .kinds = SINGLE),
    SW_NUMBER(leastJacobian, "", SW_WITHIN(-10.0, 0.9), 0.1, .key = "least_jacobian", .label = "least Jacobian",
              .tip = "Sideways motion is held back where water would fold more: 1 is flat, 0 a fold",
              SW_KNOB(-1.0, 0.9), .kinds = SINGLE),
    SW_LIST(components, componentCount, SW_MAX_FREE_WAVES, &swWaveComponentFields, .key = "components",
            .label = "waves given by hand", .kinds = SINGLE),
    SW_NUMBER(minWavelength, "m", SW_WITHIN(0.0625, 4096.0), 0.0625, .key = "min_wavelength_m",
              .label = "shortest wave", SW_LOG_KNOB(0.0625, 4096.0)),
    SW_NUMBER(maxWavelength, "m", SW_WITHIN(0.0625, 4096.0), 4096.0, .key = "max_wavelength_m", .label = "longest wave",
              SW_LOG_KNOB(0.0625, 4096.0)),
    SW_NUMBER(chop, "", SW_WITHIN(0.0, 2.0), 1.0, .key = "chop", .label = "chop",
              .tip = "Horizontal motion; 1 is that of a trochoidal wave", SW_KNOB(0.0, 2.0)),
    SW_NUMBER(weight, "", SW_WITHIN(0.0, 10.0), 1.0, .key = "weight", .label = "weight",
              .tip = "Factor on displacement", SW_KNOB(0.0, 2.0)),
    SW_NUMBER(attenuation, "", SW_WITHIN(0.0, 1.0), 1.0, .key = "attenuation", .label = "attenuation",
              .tip = "How much they die out towards the shore", SW_KNOB(0.0, 1.0)),
    SW_NUMBER(shallowsDepth, "m", SW_WITHIN(0.0, 1e4), 0.0, .key = "shallows_depth_m", .label = "shallows end",
              .tip = "Deeper water attenuates none of them, however long", .zero = "by their lengths",
              SW_LOG_KNOB(1.0, 1000.0)),
    SW_NUMBER(currentX, "m/s", SW_WITHIN(-(double)SW_MAX_CURRENT, (double)SW_MAX_CURRENT), 0.0, .key = "current_x_m_s",
              .label = "current along x", .tip = "A current that carries all of these waves, by x", SW_KNOB(-5.0, 5.0)),
    SW_NUMBER(currentZ, "m/s", SW_WITHIN(-(double)SW_MAX_CURRENT, (double)SW_MAX_CURRENT), 0.0, .key = "current_z_m_s",
              .label = "current along z", .tip = "A current that carries all of these waves, by z", SW_KNOB(-5.0, 5.0)),
    SW_SWITCH(isLocal, false, .key = "is_local", .label = "local",
              .tip = "Its waves are only where an input gives them weight"),
    SW_NUMBER(loopPeriod, "s", SW_WITHIN(0.0, SW_LARGEST_TIME), 0.0, .key = "loop_period_s", .label = "loop",
              .tip = "The waves repeat exactly after this time", .zero = "never", SW_LOG_KNOB(1.0, 600.0)),
    SW_NUMBER(seed, "", SW_WITHIN(0.0, 4294967295.0), 1.0, .key = "seed", .label = "seed",
              .tip = "Another seed is another sea of the same statistics", SW_KNOB(0.0, 100.0)),
    SW_SWITCH(takesWind, false, .key = "takes_wind", .label = "takes the world's wind",
              .tip = "Speed and direction of the world's wind in place of its own"),
};
#undef SW_DEF

const swFields swWaveSystemFields = SW_FIELDS(swWaveSystemDef, "waves", "waves", systemFields, 1);

const swFields* swGetWaveComponentFields(void)
{
    return &swWaveComponentFields;
}

const swFields* swGetWaveSystemFields(void)
{
    return &swWaveSystemFields;
}

swWaveSystemDef swDefaultWaveSystemDef(void)
{
    swWaveSystemDef def;
    swFillDef(&swWaveSystemFields, &def);
    def.spectrum = swDefaultSpectrumDef();
    return def;
}

// ---- what the table cannot say ----

static swResult checkTiles(const swHost* host, const swWaveSystemDef* def)
{
    if ((def->resolution & (def->resolution - 1)) != 0)
    {
        return swFail(host, SW_ERROR_INVALID, "swWaveSystemDef::resolution is %d; it must be a power of two.",
                      def->resolution);
    }
    if (def->tileWaves > def->resolution / 4)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "swWaveSystemDef::tileWaves is %d; with resolution %d its range is [4, %d].", def->tileWaves,
                      def->resolution, def->resolution / 4);
    }
    return SW_SUCCESS;
}

swResult swCheckWaveSystemDef(const swHost* host, const swWaveSystemDef* def)
{
    swResult result = swCheckDef(host, &swWaveSystemFields, def);
    result = result == SW_SUCCESS ? swCheckSpectrum(host, &def->spectrum) : result;
    if (result == SW_SUCCESS && !(def->minWavelength < def->maxWavelength))
    {
        return swFail(host, SW_ERROR_INVALID,
                      "swWaveSystemDef::minWavelength is %g m; it must be below maxWavelength, which is %g m.",
                      (double)def->minWavelength, (double)def->maxWavelength);
    }
    bool isByHand = def->method == SW_WAVES_GERSTNER && def->componentCount > 0;
    if (result == SW_SUCCESS && def->takesWind && (def->spectrum.kind == SW_SPECTRUM_TABLE || isByHand))
    {
        return swFail(host, SW_ERROR_INVALID,
                      "swWaveSystemDef::takesWind is true; it must be false of a table and of given components, which "
                      "no wind can change.");
    }
    return result == SW_SUCCESS && def->method == SW_WAVES_FFT ? checkTiles(host, def) : result;
}

bool swAreSameWaves(const swWaveSystemDef* a, const swWaveSystemDef* b)
{
    swWaveSystemDef other = *b;
    other.weight = a->weight;
    other.currentX = a->currentX;
    other.currentZ = a->currentZ;
    return swIsSameDef(&swWaveSystemFields, a, &other) && swIsSameTable(&a->spectrum, &b->spectrum);
}
