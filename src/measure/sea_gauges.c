// SPDX-License-Identifier: MIT
// A gauge is a particle of the water: it rests at u, and heave and slopes at u are linear in the waves' amplitudes
// however steep the sea, so that their spectra are those that were asked for. (A wave staff at a fixed place sees
// sharper crests, and its spectrum has harmonics.)
//
// A record h(t), hx(t), hz(t) is multiplied by a Hann window w, transformed, and |H|^2 / (sum w^2) is its spectrum; the
// window's power is divided out, so that the expected variance is that of the sea, and no mean or trend is removed,
// which would take energy away from the longest waves. Frequencies are shared among bins by overlap. Records of all
// gauges are averaged [Welch 1967].
// For a wave along (cos, sin), H conj(Hx) = i k cos |H|^2, so with quadrature q and k eliminated [Longuet-Higgins 1963]
//   a1 = q(h, hx) / sqrt(S(h) (S(hx) + S(hz))),  b1 likewise with hz,
//   a2 = (S(hx) - S(hz)) / (S(hx) + S(hz)),  b2 = 2 c(hx, hz) / (S(hx) + S(hz)).

#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "measure/measure_space.h"
#include "measure/measure_transform.h"
#include "seaway/measure.h"

#define MOST_SAMPLES (1 << 26)

// Heave and slopes of all gauges, a gauge's record contiguous.
typedef struct Records
{
    int gaugeCount, sampleCount;
    double dt;
    float* h;
    float* x;
    float* z;
} Records;

// Of a transform of a + i b, both real: the transform of a and of b at bin j.
static void splitPair(const swMeasureComplex* data, int count, int j, swMeasureComplex* a, swMeasureComplex* b)
{
    swMeasureComplex p = data[j], q = data[(count - j) % count];
    *a = (swMeasureComplex){0.5 * (p.re + q.re), 0.5 * (p.im - q.im)};
    *b = (swMeasureComplex){0.5 * (p.im + q.im), 0.5 * (q.re - p.re)};
}

// Share what lies at [low, high] among the bins.
static void addToBins(const swSeaBins* bins, double low, double high, const double values[6], swSeaSums* sums)
{
    for (int i = 0; i < bins->count; ++i)
    {
        double overlap = fmin(high, bins->high[i]) - fmax(low, bins->low[i]);
        if (overlap > 0.0)
        {
            double share = overlap / (high - low);
            sums->h[i] += share * values[0];
            sums->hx[i] += share * values[1];
            sums->hz[i] += share * values[2];
            sums->xx[i] += share * values[3];
            sums->zz[i] += share * values[4];
            sums->xz[i] += share * values[5];
        }
    }
}

// Cross spectra of one gauge's record, added up over gauges in spectra[count / 2][6].
static void addGauge(const Records* records, int gauge, const double* window, const swMeasureComplex* roots,
                     swMeasureComplex* first, swMeasureComplex* second, double* spectra)
{
    int count = records->sampleCount;
    size_t begin = (size_t)gauge * (size_t)count;
    for (int i = 0; i < count; ++i)
    {
        size_t at = begin + (size_t)i;
        first[i] = (swMeasureComplex){window[i] * (double)records->h[at], window[i] * (double)records->x[at]};
        second[i] = (swMeasureComplex){window[i] * (double)records->z[at], 0.0};
    }
    swTransformLine(first, count, roots);
    swTransformLine(second, count, roots);
    for (int j = 1; j < count / 2; ++j)
    {
        swMeasureComplex h, x, z = second[j];
        splitPair(first, count, j, &h, &x);
        double* sum = spectra + 6 * (size_t)j;
        sum[0] += h.re * h.re + h.im * h.im;
        sum[1] += h.im * x.re - h.re * x.im;
        sum[2] += h.im * z.re - h.re * z.im;
        sum[3] += x.re * x.re + x.im * x.im;
        sum[4] += z.re * z.re + z.im * z.im;
        sum[5] += x.re * z.re + x.im * z.im;
    }
}

// Work space of a transform, all in one piece.
typedef struct Workspace
{
    double* window;
    swMeasureComplex *roots, *first, *second;
    double* spectra;
} Workspace;

static size_t getWorkspaceSize(int count)
{
    return (size_t)count * (1 + 1 + 2 + 2 + 3) * sizeof(double);
}

static double* createWorkspace(const swHost* host, int count, Workspace* work)
{
    size_t n = (size_t)count;
    double* memory = swAllocateZero(host, getWorkspaceSize(count));
    if (memory == NULL)
    {
        return NULL;
    }
    work->window = memory;
    work->roots = (swMeasureComplex*)(memory + n);
    work->first = (swMeasureComplex*)(memory + 2 * n);
    work->second = (swMeasureComplex*)(memory + 4 * n);
    work->spectra = memory + 6 * n;
    for (int i = 0; i < count; ++i)
    {
        work->window[i] = 0.5 - 0.5 * cos(2.0 * SW_PI * i / count);
    }
    swFillRoots(count, work->roots);
    return memory;
}

// Spectra of the gauges [begin, end), into the bins.
static void sumGauges(const Records* records, int begin, int end, double scale, const Workspace* work,
                      const swSeaBins* bins, swSeaSums* sums)
{
    int count = records->sampleCount;
    double step = 1.0 / (count * records->dt);
    memset(work->spectra, 0, 3 * (size_t)count * sizeof(double));
    for (int gauge = begin; gauge < end; ++gauge)
    {
        addGauge(records, gauge, work->window, work->roots, work->first, work->second, work->spectra);
    }
    for (int j = 1; j < count / 2; ++j)
    {
        double* values = work->spectra + 6 * (size_t)j;
        for (int i = 0; i < 6; ++i)
        {
            values[i] *= scale;
        }
        addToBins(bins, (j - 0.5) * step, (j + 0.5) * step, values, sums);
    }
    sums->weight += end - begin;
}

static swResult sumRecords(const swHost* host, const Records* records, const swSeaBins* bins, int groupCount,
                           swSeaSums* sums)
{
    int count = records->sampleCount;
    Workspace work;
    double* memory = createWorkspace(host, count, &work);
    if (memory == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for the spectra of %d samples.", count);
    }
    double windowPower = 0.0;
    for (int i = 0; i < count; ++i)
    {
        windowPower += work.window[i] * work.window[i];
    }
    double scale = 2.0 / (windowPower * count); // both signs of frequency; Parseval
    for (int group = 0; group < groupCount; ++group)
    {
        int begin = group * records->gaugeCount / groupCount, end = (group + 1) * records->gaugeCount / groupCount;
        sumGauges(records, begin, end, scale, &work, bins, sums + group);
    }
    swFree(host, memory, getWorkspaceSize(count));
    return SW_SUCCESS;
}

typedef struct GaugeSpace
{
    swPosXZ* points;
    swVec3* displacement;
    swVec2* slopes;
} GaugeSpace;

static size_t getGaugeSpaceSize(size_t count)
{
    return count * (sizeof(swPosXZ) + sizeof(swVec3) + sizeof(swVec2));
}

// Step through the record and note heave and slopes of all gauges.
static swResult fillRecords(swWorld* world, const swSeaGauges* gauges, const GaugeSpace* space, Records* records)
{
    for (int i = 0; i < records->gaugeCount; ++i)
    {
        space->points[i] = swPlaceGauge(gauges->area, i);
    }
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.displacement = space->displacement};
    for (int j = 0; j < records->sampleCount; ++j)
    {
        swWorld_SetTime(world, gauges->begin + records->dt * j);
        swResult result = swWorld_Step(world, 0.0);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        swMoment_QueryParticles(swWorld_GetMoment(world), &def, records->gaugeCount, space->points, &samples,
                                space->slopes, NULL);
        for (size_t i = 0; i < (size_t)records->gaugeCount; ++i)
        {
            size_t at = i * (size_t)records->sampleCount + (size_t)j;
            records->h[at] = space->displacement[i].y;
            records->x[at] = space->slopes[i].x;
            records->z[at] = space->slopes[i].y;
        }
    }
    return SW_SUCCESS;
}

static swResult recordWithSpace(swWorld* world, const swSeaGauges* gauges, Records* records, void* memory)
{
    GaugeSpace space = {.points = memory};
    space.displacement = (swVec3*)(space.points + records->gaugeCount);
    space.slopes = (swVec2*)(space.displacement + records->gaugeCount);
    return fillRecords(world, gauges, &space, records);
}

static bool areGaugesValid(const swSeaGauges* gauges)
{
    return gauges != NULL && gauges->area > 0.0 && gauges->area <= SW_FARTHEST_POINT && gauges->gaugeCount > 0 &&
           gauges->duration > 0.0 && isfinite(gauges->duration) && fabs(gauges->begin) <= SW_LARGEST_TIME;
}

static bool areBinsValid(const swSeaBins* bins)
{
    bool isValid = bins != NULL && bins->count > 0 && bins->count <= SW_MAX_SEA_BINS &&
                   bins->high[bins->count - 1] > 0.0 && isfinite(bins->high[bins->count - 1]);
    for (int i = 0; isValid && i < bins->count; ++i)
    {
        isValid = bins->low[i] <= bins->high[i] && (i == 0 || bins->high[i - 1] <= bins->high[i]);
    }
    return isValid;
}

swResult swRecordSea(swWorld* world, const swSeaGauges* gauges, const swSeaBins* bins, int groupCount, swSeaSums* sums)
{
    const swHost* host = swFindHost(world);
    SW_REQUIRE(world != NULL && areGaugesValid(gauges) && areBinsValid(bins), SW_ERROR_INVALID, host,
               "swRecordSea() needs a world, ascending bins, and gauges over an area and a duration above 0, in range");
    SW_REQUIRE(sums != NULL && groupCount > 0, SW_ERROR_INVALID, host,
               "swRecordSea() needs a place for the sums of at least one group");
    // Sampled a fifth faster than the last bin needs; a power of two of samples.
    Records records = {.gaugeCount = gauges->gaugeCount, .dt = 1.0 / (2.4 * bins->high[bins->count - 1])};
    double samples = gauges->duration / records.dt;
    if (samples > MOST_SAMPLES)
    {
        return swFail(host, SW_ERROR_LIMIT, "A record of %g s at %g Hz has too many samples; record a shorter time.",
                      gauges->duration, 1.0 / records.dt);
    }
    records.sampleCount = 64;
    while (records.sampleCount < samples)
    {
        records.sampleCount *= 2;
    }
    size_t count = (size_t)records.gaugeCount * (size_t)records.sampleCount;
    size_t size = 3 * count * sizeof(float) + getGaugeSpaceSize((size_t)records.gaugeCount);
    void* memory = swAllocate(host, size);
    if (memory == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for the records of %d gauges, %zu bytes.",
                      records.gaugeCount, size);
    }
    size_t spaceSize = getGaugeSpaceSize((size_t)records.gaugeCount);
    records.h = (float*)((char*)memory + spaceSize);
    records.x = records.h + count;
    records.z = records.x + count;
    swResult result = recordWithSpace(world, gauges, &records, memory);
    if (result == SW_SUCCESS)
    {
        result = sumRecords(host, &records, bins, groupCount, sums);
    }
    swFree(host, memory, size);
    return result;
}
