// SPDX-License-Identifier: MIT

// From a spectrum to the waves of each band [Tessendorf 2001].
//
// A band's waves stand on the lattice k = 2 pi q / side, in the ring of wave numbers of its octave. A wave gets the
// energy that the directional spectrum has in its lattice cell,
//   E = integral over the cell of S(omega, theta) (d omega / d k) / k,
// where the ring cuts a cell: in the part inside. Then all are scaled so that the band's variance is exactly the
// integral of S over its frequencies, and of a table that of each of its bins (waves_bins.c). Amplitudes are sqrt(2 E)
// with random phases: every seed has the energy asked for, and hundreds to thousands of waves a band make the surface
// as good as Gaussian.
//
// A tile holds spline coefficients, and a cubic B-spline over samples damps a wave of q bins of N by sinc^4(q / N)
// along each axis [Unser 1999]; the stored amplitudes are divided by that, so that the spline has the energy, not its
// samples.
//
// A narrow swell has nearly all of its energy in one octave, and there in a few dozen waves: it would be seen to repeat
// from one tile to the next. Such a band gets a second and a third tile beside the first, whose sides have no common
// multiple near. Each has the same spectrum on another lattice with phases of its own, and its part of the energy.
//
// Frequencies are those of dispersion.h, rounded to 2^-64 turns a tick, some 10^-12 Hz; from there on a phase is
// an integer, exact after any time. With a loop period they are whole numbers of turns a loop.

#include "core/waves/waves_fft.h"

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/math/random.h"
#include "core/math/scalar.h"
#include "core/waves/waves_bins.h"
#include "core/waves/waves_kernels.h"

#define TURN (2.0 * SW_PI)

// Points an axis that tell how much of a cell is inside the ring.
#define RIM_POINTS 8

// Bands with less variance than this have no waves, m^2: a millionth of a metre high.
#define LEAST_VARIANCE 1e-12

// Waves with a smaller part of the band's energy than this are left out.
#define LEAST_PART 1e-11

// A band is narrow whose energy is in a smaller part of its waves than this: swells that spread by up to some 15
// degrees, and no wind sea. Then no tile has a larger part of the system's energy than this, unless it takes more than
// SW_BAND_TILES.
#define NARROW 0.12
#define LARGEST_SHARE 0.25

// What all tiles of a system share while they are built.
typedef struct Builder
{
    const swHost* host;
    const swWaveSystemDef* def;
    const swCompiledSpectrum* spectrum;
    swDispersion dispersion;
    swBandModes* bands;
    swResult results[SW_MAX_BANDS]; // of first tiles
} Builder;

// One band's lattice.
typedef struct Ring
{
    int points;    // an axis of Gauss's rule for a cell
    double dk;     // 2 pi / side, rad/m
    double k0, k1; // rad/m
    swBandCells cells;
} Ring;

double swGetTileSide(int tile, int tileWaves)
{
    // Any two sides of a band, times 1 to 4, are a seventh of the first apart at least.
    static const double parallel[SW_BAND_TILES] = {1.0, 0.714, 0.856};
    int band = tile % SW_MAX_BANDS;
    // Multiples of the golden section modulo one keep away from each other and from simple ratios. The largest factor
    // leaves the bin `tileWaves` itself empty for the usual 32 waves.
    double golden = 0.6180339887498949 * (band + 1);
    double factor = 0.86 + 0.12 * (golden - floor(golden));
    double shortest = ldexp(1.0, band - 4);
    return tileWaves * shortest * factor * parallel[tile / SW_MAX_BANDS];
}

static double getWaveNumber(const Ring* ring, int qx, int qz)
{
    return ring->dk * sqrt((double)(qx * qx + qz * qz));
}

// Energy per area of the k plane, m^4, at a point of the wave's cell. A point beyond an edge of the spectrum's bin that
// the wave is in stands for its direction only.
static double getDensity(const Builder* builder, const Ring* ring, int qx, int qz, double kx, double kz)
{
    double k = sqrt(kx * kx + kz * kz);
    double omega = swGetOmega(&builder->dispersion, k);
    double theta = swAtan2(kz, kx);
    if (swFindCompiledBin(builder->spectrum, omega) != ring->cells.bins[swGetCellIndex(&ring->cells, qx, qz)])
    {
        k = getWaveNumber(ring, qx, qz);
        omega = swGetOmega(&builder->dispersion, k);
    }
    double density = swGetCompiledDensity2(builder->spectrum, omega, theta);
    return density > 0.0 ? density * swGetGroupSpeed(&builder->dispersion, k) / k : 0.0;
}

// Gauss's rule: three points an axis where cells are wide, two where they are narrow. A cell of the usual 32 waves
// spans two to four degrees; two points are then good to 5e-4 at the peak of the narrowest swell (s = 200).
static double integrateInnerCell(const Builder* builder, const Ring* ring, int qx, int qz)
{
    static const double offsets[2][3] = {{-0.28867513459481288, 0.28867513459481288},
                                         {-0.38729833462074170, 0.0, 0.38729833462074170}};
    static const double weights[2][3] = {{0.5, 0.5}, {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0}};
    int rule = ring->points - 2;
    double dk = ring->dk;
    double sum = 0.0;
    for (int j = 0; j < ring->points; ++j)
    {
        for (int i = 0; i < ring->points; ++i)
        {
            double kx = dk * (qx + offsets[rule][i]);
            double kz = dk * (qz + offsets[rule][j]);
            sum += weights[rule][j] * weights[rule][i] * getDensity(builder, ring, qx, qz, kx, kz);
        }
    }
    return sum * dk * dk;
}

// The part of the cell inside the ring times the density at that part's centre.
static double integrateRimCell(const Builder* builder, const Ring* ring, int qx, int qz)
{
    int count = 0;
    double sumX = 0.0;
    double sumZ = 0.0;
    for (int j = 0; j < RIM_POINTS; ++j)
    {
        double kz = ring->dk * (qz + (j + 0.5) / RIM_POINTS - 0.5);
        for (int i = 0; i < RIM_POINTS; ++i)
        {
            double kx = ring->dk * (qx + (i + 0.5) / RIM_POINTS - 0.5);
            double k2 = kx * kx + kz * kz;
            if (k2 > ring->k0 * ring->k0 && k2 <= ring->k1 * ring->k1)
            {
                count += 1;
                sumX += kx;
                sumZ += kz;
            }
        }
    }
    if (count == 0)
    {
        return 0.0;
    }
    double part = (double)count / (RIM_POINTS * RIM_POINTS);
    return getDensity(builder, ring, qx, qz, sumX / count, sumZ / count) * part * ring->dk * ring->dk;
}

static double integrateCell(const Builder* builder, const Ring* ring, int qx, int qz)
{
    const double halfDiagonal = 0.70710678118654752;
    double q = sqrt((double)(qx * qx + qz * qz));
    double innermost = (q - halfDiagonal) * ring->dk;
    double outermost = (q + halfDiagonal) * ring->dk;
    if (outermost <= ring->k0 || innermost >= ring->k1 || (qx == 0 && qz == 0))
    {
        return 0.0;
    }
    if (innermost > ring->k0 && outermost < ring->k1)
    {
        return integrateInnerCell(builder, ring, qx, qz);
    }
    return integrateRimCell(builder, ring, qx, qz);
}

static double getEnergy(const Ring* ring, int qx, int qz)
{
    return ring->cells.energy[swGetCellIndex(&ring->cells, qx, qz)];
}

// Fill the ring's energies so that each of the spectrum's bins has its own.
static swResult fillEnergies(const Builder* builder, Ring* ring, int binCount, const double* wanted)
{
    for (int qz = -ring->cells.maxBin; qz <= ring->cells.maxBin; ++qz)
    {
        for (int qx = -ring->cells.maxBin; qx <= ring->cells.maxBin; ++qx)
        {
            int i = swGetCellIndex(&ring->cells, qx, qz);
            double omega = swGetOmega(&builder->dispersion, getWaveNumber(ring, qx, qz));
            ring->cells.bins[i] = swFindCompiledBin(builder->spectrum, omega);
            ring->cells.energy[i] = integrateCell(builder, ring, qx, qz);
        }
    }
    return swShareBins(builder->host, builder->spectrum, binCount, wanted, &ring->cells);
}

int64_t swGetLoopTicks(const swWaveSystemDef* def)
{
    double ticks = floor((double)def->loopPeriod * SW_TICKS_PER_SECOND + 0.5);
    return ticks >= 1.0 ? (int64_t)ticks : 0;
}

uint64_t swGetTurnsPerTick(double omega, int64_t loopTicks)
{
    double turnsPerTick = omega / TURN / SW_TICKS_PER_SECOND;
    if (loopTicks > 0)
    {
        double turns = floor(turnsPerTick * (double)loopTicks + 0.5);
        turnsPerTick = (turns >= 1.0 ? turns : 1.0) / (double)loopTicks;
    }
    double scaled = floor(ldexp(turnsPerTick, 64) + 0.5);
    return scaled < 0x1p64 ? (uint64_t)scaled : UINT64_MAX;
}

// sin(pi x) / (pi x), to the fourth.
static double getSinc4(double x)
{
    if (x == 0.0)
    {
        return 1.0;
    }
    double sinc = swSin(SW_PI * x) / (SW_PI * x);
    return (sinc * sinc) * (sinc * sinc);
}

void swFillSplineResponse(int resolution, float* response)
{
    for (int q = 0; q <= resolution / 4; ++q)
    {
        response[q] = (float)getSinc4((double)q / resolution);
    }
}

double swGetWaveOmega(const swCompiledSpectrum* spectrum, double k)
{
    swDispersion dispersion = swGetCompiledDispersion(spectrum);
    dispersion.gravity *= swGetCompiledGravityScale(spectrum, k);
    return swGetOmega(&dispersion, k);
}

double swGetOrbitRatio(const swCompiledSpectrum* spectrum, const swWaveSystemDef* def, double k)
{
    double depth = swGetCompiledDispersion(spectrum).depth;
    double ratio = (double)def->chop * swGetCompiledChop(spectrum, k);
    return isinf(depth) ? ratio : ratio / swTanh(k * depth);
}

// Amplitude of the wave at q of a tile: real and imaginary part.
static void getAmplitude(const Builder* builder, int tile, const Ring* ring, int qx, int qz, double* re, double* im)
{
    double amplitude = sqrt(2.0 * getEnergy(ring, qx, qz));
    double phase = TURN * swHashToUnit(swHashWave(builder->def->seed, tile, qx, qz, 0));
    *re = amplitude * swCos(phase);
    *im = amplitude * swSin(phase);
}

static swMode makeMode(const Builder* builder, const swBandModes* band, const Ring* ring, int qx, int qz)
{
    double k = ring->dk * sqrt((double)(qx * qx + qz * qz));
    double size = builder->def->resolution;
    double scale = 0.5 / (getSinc4(qx / size) * getSinc4(qz / size));
    double ar, ai, br, bi;
    int tile = (int)(band - builder->bands);
    getAmplitude(builder, tile, ring, qx, qz, &ar, &ai);
    getAmplitude(builder, tile, ring, -qx, -qz, &br, &bi);
    uint64_t frequency = swGetTurnsPerTick(swGetWaveOmega(builder->spectrum, k), band->loopTicks);
    swMode mode;
    mode.qx = (int16_t)qx;
    mode.qz = (int16_t)qz;
    double ratio = swGetOrbitRatio(builder->spectrum, builder->def, k);
    mode.dx = (float)(ratio * ring->dk * qx / k);
    mode.dz = (float)(ratio * ring->dk * qz / k);
    mode.pr = (float)(scale * (ar + br));
    mode.pi = (float)(scale * (ai - bi));
    mode.qr = (float)(scale * (ar - br));
    mode.qi = (float)(scale * (ai + bi));
    mode.frequencyLow = (uint32_t)frequency;
    mode.frequencyHigh = (uint32_t)(frequency >> 32);
    return mode;
}

// Go through the half plane in order; `modes` may be NULL to count.
static int listModes(const Builder* builder, const swBandModes* band, const Ring* ring, double least, swMode* modes)
{
    int count = 0;
    for (int qz = 0; qz <= ring->cells.maxBin; ++qz)
    {
        for (int qx = qz == 0 ? 1 : -ring->cells.maxBin; qx <= ring->cells.maxBin; ++qx)
        {
            if (getEnergy(ring, qx, qz) + getEnergy(ring, -qx, -qz) <= least)
            {
                continue;
            }
            if (modes != NULL)
            {
                modes[count] = makeMode(builder, band, ring, qx, qz);
            }
            count += 1;
        }
    }
    return count;
}

// Variance times the direction's powers, in the order of swStrain.
static void addStrain(double strain[5], double variance, double c, double s)
{
    strain[0] += variance * c * c * c * c;
    strain[1] += variance * c * c * c * s;
    strain[2] += variance * c * c * s * s;
    strain[3] += variance * c * s * s * s;
    strain[4] += variance * s * s * s * s;
}

static void measureVariances(const Builder* builder, swBandModes* band, const Ring* ring)
{
    double variance = 0.0;
    double squares = 0.0;
    double strain[5] = {0};
    double slopeX = 0.0;
    double slopeZ = 0.0;
    for (int qz = -ring->cells.maxBin; qz <= ring->cells.maxBin; ++qz)
    {
        for (int qx = -ring->cells.maxBin; qx <= ring->cells.maxBin; ++qx)
        {
            double energy = getEnergy(ring, qx, qz);
            variance += energy;
            squares += energy * energy;
            slopeX += energy * (ring->dk * qx) * (ring->dk * qx);
            slopeZ += energy * (ring->dk * qz) * (ring->dk * qz);
            double k = ring->dk * sqrt((double)(qx * qx + qz * qz));
            if (energy > 0.0)
            {
                double ratio = swGetOrbitRatio(builder->spectrum, builder->def, k);
                addStrain(strain, energy * k * k * ratio * ratio, ring->dk * qx / k, ring->dk * qz / k);
            }
        }
    }
    band->variance = (float)variance;
    band->slopeVarianceX = (float)slopeX;
    band->slopeVarianceZ = (float)slopeZ;
    band->strain = (swStrain){(float)strain[0], (float)strain[1], (float)strain[2], (float)strain[3], (float)strain[4]};
    double octave = SW_PI * (ring->k1 * ring->k1 - ring->k0 * ring->k0) / (ring->dk * ring->dk);
    band->breadth = (float)(variance * variance / squares / octave);
}

static int findMaxBin(const swBandModes* band)
{
    int maxBin = 0;
    for (int i = 0; i < band->modeCount; ++i)
    {
        int x = band->modes[i].qx < 0 ? -band->modes[i].qx : band->modes[i].qx;
        int z = band->modes[i].qz;
        maxBin = x > maxBin ? x : maxBin;
        maxBin = z > maxBin ? z : maxBin;
    }
    return maxBin;
}

// Energies are there: make the waves.
static swResult fillModes(const Builder* builder, swBandModes* band, const Ring* ring, double variance)
{
    double least = variance * LEAST_PART;
    int count = listModes(builder, band, ring, least, NULL);
    swMode* modes = swAllocate(builder->host, (size_t)count * sizeof(swMode));
    if (modes == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    band->modes = modes;
    band->modeCount = listModes(builder, band, ring, least, modes);
    band->maxBin = findMaxBin(band);
    measureVariances(builder, band, ring);
    return SW_SUCCESS;
}

static swResult buildTile(const Builder* builder, int index, swBandModes* band)
{
    const swWaveSystemDef* def = builder->def;
    double shortest = fmax(ldexp(1.0, band->band - 4), (double)def->minWavelength);
    double longest = fmin(ldexp(1.0, band->band - 3), (double)def->maxWavelength);
    if (!(shortest < longest))
    {
        return SW_SUCCESS;
    }
    band->side = swGetTileSide(index, def->tileWaves);
    band->minWavelength = (float)shortest;
    band->maxWavelength = (float)longest;
    Ring ring = {.dk = TURN / band->side, .k0 = TURN / longest, .k1 = TURN / shortest};
    double wanted[SW_MAX_SPECTRUM_BINS], variance = 0.0;
    int binCount = swGetCompiledBins(builder->spectrum, swGetOmega(&builder->dispersion, ring.k0),
                                     swGetOmega(&builder->dispersion, ring.k1), wanted);
    for (int i = 0; i < binCount; ++i)
    {
        variance += wanted[i];
    }
    if (!(variance > LEAST_VARIANCE))
    {
        return SW_SUCCESS;
    }
    ring.points = ldexp(band->side, 4 - band->band) < 0.85 * 16.0 ? 3 : 2;
    // A cell reaches half a bin inwards, so the largest bin is at most tileWaves.
    ring.cells.maxBin = (int)floor(ring.k1 / ring.dk + 0.5);
    size_t cellCount = (size_t)((2 * ring.cells.maxBin + 1) * (2 * ring.cells.maxBin + 1));
    size_t size = cellCount * (sizeof(double) + sizeof(int));
    ring.cells.energy = swAllocate(builder->host, size);
    if (ring.cells.energy == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    ring.cells.bins = (int*)(ring.cells.energy + cellCount);
    swResult result = fillEnergies(builder, &ring, binCount, wanted);
    if (result == SW_SUCCESS)
    {
        result = fillModes(builder, band, &ring, variance);
    }
    swFree(builder->host, ring.cells.energy, size);
    return result == SW_ERROR_INVALID ? SW_SUCCESS : result; // a band without waves
}

static void buildTiles(void* context, int begin, int end, int worker)
{
    (void)worker;
    Builder* builder = context;
    for (int tile = begin; tile < end; ++tile)
    {
        builder->results[tile] = buildTile(builder, tile, &builder->bands[tile]);
    }
}

static swResult buildFirstTiles(Builder* builder)
{
    const swHost* host = builder->host;
    host->parallelFor(host->taskContext, buildTiles, builder, SW_MAX_BANDS, 1);
    for (int band = 0; band < SW_MAX_BANDS; ++band)
    {
        if (builder->results[band] != SW_SUCCESS)
        {
            return builder->results[band];
        }
    }
    return SW_SUCCESS;
}

static void scaleEnergy(swBandModes* band, double part)
{
    float factor = (float)sqrt(part);
    for (int i = 0; i < band->modeCount; ++i)
    {
        swMode* mode = &band->modes[i];
        mode->pr *= factor;
        mode->pi *= factor;
        mode->qr *= factor;
        mode->qi *= factor;
    }
    band->variance *= (float)part;
    band->slopeVarianceX *= (float)part;
    band->slopeVarianceZ *= (float)part;
    swScaleStrain(&band->strain, (float)part);
}

// Tiles that a band is shared out to; `total` is the system's variance.
static int countParallel(const swBandModes* band, double total)
{
    if (band->modeCount == 0 || (double)band->breadth >= NARROW || band->band < SW_FIRST_PARALLEL_BAND)
    {
        return 1;
    }
    double wanted = ceil((double)band->variance / (LARGEST_SHARE * total));
    return wanted < SW_BAND_TILES ? (int)wanted : SW_BAND_TILES;
}

// Tiles beside the first, each with all of the band's energy until it is shared out.
static swResult addParallelTiles(Builder* builder)
{
    double total = 0.0;
    for (int band = 0; band < SW_MAX_BANDS; ++band)
    {
        total += (double)builder->bands[band].variance;
    }
    for (int band = 0; band < SW_MAX_BANDS; ++band)
    {
        int count = countParallel(&builder->bands[band], total), made = 1;
        for (int k = 1; k < count; ++k)
        {
            int tile = k * SW_MAX_BANDS + band;
            swResult result = buildTile(builder, tile, &builder->bands[tile]);
            if (result != SW_SUCCESS)
            {
                return result;
            }
            made += builder->bands[tile].modeCount > 0;
        }
        for (int k = 0; k < count && made > 1; ++k)
        {
            scaleEnergy(&builder->bands[k * SW_MAX_BANDS + band], 1.0 / made);
        }
    }
    return SW_SUCCESS;
}

swResult swBuildModes(const swHost* host, const swWaveSystemDef* def, float gravity, float surfaceTension,
                      swBandModes* bands)
{
    memset(bands, 0, SW_SET_TILES * sizeof(swBandModes));
    Builder builder = {.host = host, .def = def, .bands = bands};
    swCompiledSpectrum* spectrum = NULL;
    swResult result = swCompileSpectrum(host, &def->spectrum, (double)gravity, (double)surfaceTension, &spectrum);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    builder.spectrum = spectrum;
    builder.dispersion = swGetCompiledDispersion(spectrum);
    swWarnOfLongWaves(host, def, spectrum);
    for (int tile = 0; tile < SW_SET_TILES; ++tile)
    {
        bands[tile].band = tile % SW_MAX_BANDS;
        bands[tile].loopTicks = swGetLoopTicks(def);
        bands[tile].depth = (float)builder.dispersion.depth;
    }
    swFillWindLevels(spectrum, &def->spectrum, bands);
    result = buildFirstTiles(&builder);
    result = result == SW_SUCCESS ? addParallelTiles(&builder) : result;
    swFreeCompiledSpectrum(host, spectrum);
    if (result != SW_SUCCESS)
    {
        swFreeModes(host, bands);
    }
    return result;
}

void swFreeModes(const swHost* host, swBandModes* bands)
{
    for (int tile = 0; tile < SW_SET_TILES; ++tile)
    {
        swFree(host, bands[tile].modes, (size_t)bands[tile].modeCount * sizeof(swMode));
        bands[tile].modes = NULL;
        bands[tile].modeCount = 0;
    }
}

#if defined(__x86_64__)

static bool hasAvx512(void)
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512dq");
}

static const swWaveKernels* findBestKernels(void)
{
    if (hasAvx512())
    {
        return &swWaveKernelsAvx512;
    }
    return __builtin_cpu_supports("avx2") ? &swWaveKernelsAvx2 : &swWaveKernelsSse2;
}

#elif defined(__aarch64__)

static const swWaveKernels* findBestKernels(void)
{
    return &swWaveKernelsNeon;
}

#else

static const swWaveKernels* findBestKernels(void)
{
    return &swWaveKernelsScalar;
}

#endif

const swWaveKernels* swGetWaveKernels(swIsa isa)
{
    switch (isa)
    {
    case SW_ISA_BEST:
        return findBestKernels();
    case SW_ISA_SCALAR:
        return &swWaveKernelsScalar;
#if defined(__x86_64__)
    case SW_ISA_SSE2:
        return &swWaveKernelsSse2;
    case SW_ISA_AVX2:
        return __builtin_cpu_supports("avx2") ? &swWaveKernelsAvx2 : NULL;
    case SW_ISA_AVX512:
        return hasAvx512() ? &swWaveKernelsAvx512 : NULL;
#elif defined(__aarch64__)
    case SW_ISA_NEON:
        return &swWaveKernelsNeon;
#endif
    default:
        return NULL;
    }
}

swIsa swGetWaveKernelsIsa(const swWaveKernels* kernels)
{
    return kernels->isa;
}

double swSumTilePowers(const swTile* tile)
{
    double sum = 0.0;
    for (int i = 0; i < tile->modeCount; ++i)
    {
        const swMode* m = &tile->modes[i];
        double response = (double)tile->response[m->qx < 0 ? -m->qx : m->qx] * (double)tile->response[m->qz];
        sum += response * response *
               ((double)m->pr * (double)m->pr + (double)m->pi * (double)m->pi + (double)m->qr * (double)m->qr +
                (double)m->qi * (double)m->qi);
    }
    return sum;
}

size_t swGetTileScratchSize(int resolution)
{
    // As layOutScratch() in waves_kernels.inl: six fields of panels and of columns, work and three planes.
    size_t rows = (size_t)resolution;
    size_t panels = (size_t)swGetPanelCount(resolution);
    return (6 * panels * rows + 6 * panels * 8 + 4 * rows) * 16 * sizeof(float);
}

void swTransformTiles(const swWaveKernels* kernels, const swTile* a, float* texelsA, const swTile* b, float* texelsB,
                      int64_t ticks, int derivative, void* scratch)
{
    kernels->transformTiles(a, texelsA, b, texelsB, ticks, derivative, scratch);
}

void swSampleTiles(const swWaveKernels* kernels, int tileCount, const swTile* tiles, int count, const swPosXZ* points,
                   float* out, float* gradients)
{
    const swTileChoice all = {.count = tileCount, .tiles = tiles};
    kernels->sampleTiles(&all, count, points, out, gradients);
}

void swSampleChosenTiles(const swWaveKernels* kernels, const swTileChoice* choice, int count, const swPosXZ* points,
                         float* out, float* gradients)
{
    kernels->sampleTiles(choice, count, points, out, gradients);
}

void swAddTile(const swWaveKernels* kernels, const swTile* tile, int field, int count, const swPosXZ* points,
               const swTileShape* shape, bool withSlopes, swPointSums* sums)
{
    if (shape != NULL)
    {
        kernels->addShapedTile(tile, field, count, points, shape, withSlopes, sums);
        return;
    }
    kernels->addTile(tile, field, count, points, withSlopes, sums);
}

void swFindDepthShares(const swWaveKernels* kernels, swAttenuation law, float k, int count, const float* depths,
                       float* shares, float* slopes)
{
    kernels->findDepthShares(law, k, count, depths, shares, slopes);
}

void swStorePointSums(const swWaveKernels* kernels, int count, const swPointSums* sums, float* out, float* gradients)
{
    kernels->storeSums(count, sums, out, gradients);
}

void swSampleRow(const swWaveKernels* kernels, const swTileChoice* choice, int count, const double* x, double z,
                 float* out, float (*gradients)[8])
{
    kernels->sampleRow(choice, count, x, z, out, gradients);
}

void swSumWaves(const swWaveKernels* kernels, const swWaveSumJob* job)
{
    kernels->sumWaves(job);
}
