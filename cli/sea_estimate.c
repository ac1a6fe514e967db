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

#include "sea_estimate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sea_transform.h"

// Over density, m^3/s^2: what swDefaultWorldDef() has.
#define SURFACE_TENSION 7.4e-5

// Longest record for the sake of narrow bins, s.
#define TABLE_DURATION 3600.0

// Heave and slopes of all gauges, a gauge's record contiguous.
typedef struct Records
{
    int gaugeCount, sampleCount;
    double dt;
    float* h;
    float* x;
    float* z;
} Records;

void UseTableBins(const swSpectrumTable* table, SeaBins* bins)
{
    bins->count = table->frequencyCount < SEA_MAX_BINS ? table->frequencyCount : SEA_MAX_BINS;
    double edges[SEA_MAX_BINS + 1];
    swSpectrumTable_GetEdges(table, edges);
    for (int i = 0; i < bins->count; ++i)
    {
        bins->center[i] = (double)table->frequencies[i];
        bins->low[i] = edges[i];
        bins->high[i] = edges[i + 1];
    }
}

static double SumTableRow(const swSpectrumTable* table, int row)
{
    double sum = 0.0;
    for (int i = 0; i < table->directionCount; ++i)
    {
        sum += (double)table->density[(size_t)row * (size_t)table->directionCount + (size_t)i];
    }
    return sum;
}

double FindTableDuration(const swSpectrumTable* table)
{
    SeaBins* bins = malloc(sizeof(SeaBins));
    double most = 0.0, narrowest = (double)INFINITY;
    if (bins == NULL)
    {
        return TABLE_DURATION;
    }
    UseTableBins(table, bins);
    for (int i = 0; i < bins->count; ++i)
    {
        most = fmax(most, SumTableRow(table, i));
    }
    for (int i = 0; i < bins->count; ++i)
    {
        bool holdsMuch = SumTableRow(table, i) >= 0.25 * most;
        narrowest = holdsMuch ? fmin(narrowest, bins->high[i] - bins->low[i]) : narrowest;
    }
    free(bins);
    return fmin(8.0 / narrowest, TABLE_DURATION);
}

void UseEqualBins(double low, double high, int count, SeaBins* bins)
{
    bins->count = count < SEA_MAX_BINS ? count : SEA_MAX_BINS;
    double width = (high - low) / bins->count;
    for (int i = 0; i < bins->count; ++i)
    {
        bins->low[i] = low + width * i;
        bins->high[i] = low + width * (i + 1);
        bins->center[i] = low + width * (i + 0.5);
    }
}

void UseGrowingBins(double low, double high, double width, double part, SeaBins* bins)
{
    bins->count = 0;
    while (low < high * (1.0 - 1e-9) && bins->count < SEA_MAX_BINS)
    {
        int i = bins->count++;
        bins->low[i] = low;
        bins->high[i] = fmin(low + fmax(width, part * low), high);
        bins->center[i] = 0.5 * (bins->low[i] + bins->high[i]);
        low = bins->high[i];
    }
}

double FindFrequency(double wavelength, double depth, double gravity)
{
    double k = 2.0 * SW_PI / wavelength;
    double omega2 = (gravity * k + SURFACE_TENSION * k * k * k) * (isfinite(depth) ? tanh(k * depth) : 1.0);
    return sqrt(omega2) / (2.0 * SW_PI);
}

double FindWavelength(double frequency, double depth, double gravity)
{
    double shortest = 1e-4, longest = 1e7; // the frequency falls with the length
    for (int i = 0; i < 80; ++i)
    {
        double middle = sqrt(shortest * longest);
        if (FindFrequency(middle, depth, gravity) > frequency)
        {
            shortest = middle;
        }
        else
        {
            longest = middle;
        }
    }
    return longest;
}

// Points spread evenly however many there are: fractions of two irrational numbers, the plane's golden ratio.
static swPosXZ PlaceGauge(double area, int index)
{
    double x = 0.7548776662466927 * (index + 1), z = 0.5698402909980532 * (index + 1);
    return (swPosXZ){area * (x - floor(x) - 0.5), area * (z - floor(z) - 0.5)};
}

// Of a transform of a + i b, both real: the transform of a and of b at bin j.
static void SplitPair(const SeaComplex* data, int count, int j, SeaComplex* a, SeaComplex* b)
{
    SeaComplex p = data[j], q = data[(count - j) % count];
    *a = (SeaComplex){0.5 * (p.re + q.re), 0.5 * (p.im - q.im)};
    *b = (SeaComplex){0.5 * (p.im + q.im), 0.5 * (q.re - p.re)};
}

// Share what lies at [low, high] among the bins.
static void AddToBins(const SeaBins* bins, double low, double high, const double values[6], SeaSums* sums)
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
static void AddGauge(const Records* records, int gauge, const double* window, const SeaComplex* roots,
                     SeaComplex* first, SeaComplex* second, double* spectra)
{
    int count = records->sampleCount;
    size_t begin = (size_t)gauge * (size_t)count;
    for (int i = 0; i < count; ++i)
    {
        size_t at = begin + (size_t)i;
        first[i] = (SeaComplex){window[i] * (double)records->h[at], window[i] * (double)records->x[at]};
        second[i] = (SeaComplex){window[i] * (double)records->z[at], 0.0};
    }
    TransformLine(first, count, roots);
    TransformLine(second, count, roots);
    for (int j = 1; j < count / 2; ++j)
    {
        SeaComplex h, x, z = second[j];
        SplitPair(first, count, j, &h, &x);
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
    SeaComplex *roots, *first, *second;
    double* spectra;
} Workspace;

static double* CreateWorkspace(int count, Workspace* work)
{
    size_t n = (size_t)count;
    double* memory = calloc(n * (1 + 1 + 2 + 2 + 3), sizeof(double));
    if (memory == NULL)
    {
        return NULL;
    }
    work->window = memory;
    work->roots = (SeaComplex*)(memory + n);
    work->first = (SeaComplex*)(memory + 2 * n);
    work->second = (SeaComplex*)(memory + 4 * n);
    work->spectra = memory + 6 * n;
    for (int i = 0; i < count; ++i)
    {
        work->window[i] = 0.5 - 0.5 * cos(2.0 * SW_PI * i / count);
    }
    FillRoots(count, work->roots);
    return memory;
}

// Spectra of the gauges [begin, end), into the bins.
static void SumGauges(const Records* records, int begin, int end, double scale, const Workspace* work,
                      const SeaBins* bins, SeaSums* sums)
{
    int count = records->sampleCount;
    double step = 1.0 / (count * records->dt);
    memset(work->spectra, 0, 3 * (size_t)count * sizeof(double));
    for (int gauge = begin; gauge < end; ++gauge)
    {
        AddGauge(records, gauge, work->window, work->roots, work->first, work->second, work->spectra);
    }
    for (int j = 1; j < count / 2; ++j)
    {
        double* values = work->spectra + 6 * (size_t)j;
        for (int i = 0; i < 6; ++i)
        {
            values[i] *= scale;
        }
        AddToBins(bins, (j - 0.5) * step, (j + 0.5) * step, values, sums);
    }
    sums->weight += end - begin;
}

static bool SumRecords(const Records* records, const SeaBins* bins, int groupCount, SeaSums* sums)
{
    int count = records->sampleCount;
    Workspace work;
    double* memory = CreateWorkspace(count, &work);
    if (memory == NULL)
    {
        return false;
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
        SumGauges(records, begin, end, scale, &work, bins, sums + group);
    }
    free(memory);
    return true;
}

// Step through the record and note heave and slopes of all gauges.
static bool FillRecords(swWorld* world, const SeaGauges* gauges, Records* records)
{
    size_t count = (size_t)records->gaugeCount;
    swPosXZ* points = malloc(count * sizeof(swPosXZ));
    swVec3* displacement = malloc(count * sizeof(swVec3));
    swVec2* slopes = malloc(count * sizeof(swVec2));
    bool isFine = points != NULL && displacement != NULL && slopes != NULL;
    for (int i = 0; i < records->gaugeCount && isFine; ++i)
    {
        points[i] = PlaceGauge(gauges->area, i);
    }
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.displacement = displacement};
    for (int j = 0; j < records->sampleCount && isFine; ++j)
    {
        swWorld_SetTime(world, gauges->begin + records->dt * j);
        isFine = swWorld_Step(world, 0.0) == SW_SUCCESS;
        swMoment_QueryParticles(swWorld_GetMoment(world), &def, records->gaugeCount, points, &samples, slopes, NULL);
        for (size_t i = 0; i < count; ++i)
        {
            size_t at = i * (size_t)records->sampleCount + (size_t)j;
            records->h[at] = displacement[i].y;
            records->x[at] = slopes[i].x;
            records->z[at] = slopes[i].y;
        }
    }
    free(points);
    free(displacement);
    free(slopes);
    return isFine;
}

bool RecordSea(swWorld* world, const SeaGauges* gauges, const SeaBins* bins, int groupCount, SeaSums* sums)
{
    // Sampled a fifth faster than the last bin needs; a power of two of samples.
    Records records = {.gaugeCount = gauges->gaugeCount, .dt = 1.0 / (2.4 * bins->high[bins->count - 1])};
    records.sampleCount = 64;
    while (records.sampleCount * records.dt < gauges->duration)
    {
        records.sampleCount *= 2;
    }
    size_t count = (size_t)records.gaugeCount * (size_t)records.sampleCount;
    float* memory = malloc(3 * count * sizeof(float));
    if (memory == NULL)
    {
        return false;
    }
    records.h = memory;
    records.x = memory + count;
    records.z = memory + 2 * count;
    bool isFine = FillRecords(world, gauges, &records) && SumRecords(&records, bins, groupCount, sums);
    free(memory);
    return isFine;
}

void AddSums(const SeaSums* from, SeaSums* to)
{
    to->weight += from->weight;
    for (int i = 0; i < SEA_MAX_BINS; ++i)
    {
        to->h[i] += from->h[i];
        to->hx[i] += from->hx[i];
        to->hz[i] += from->hz[i];
        to->xx[i] += from->xx[i];
        to->zz[i] += from->zz[i];
        to->xz[i] += from->xz[i];
    }
}

double FindDensity(const SeaBins* bins, const SeaSums* sums, int bin)
{
    double scale = sums->weight > 0.0 ? 1.0 / sums->weight : 0.0;
    return scale * sums->h[bin] / (bins->high[bin] - bins->low[bin]);
}

int FindPeakBin(const SeaBins* bins, const SeaSums* sums)
{
    int peak = 0;
    for (int i = 1; i < bins->count; ++i)
    {
        peak = FindDensity(bins, sums, i) > FindDensity(bins, sums, peak) ? i : peak;
    }
    return peak;
}

SeaMoments FindMoments(const SeaSums* sums, int bin)
{
    double slopes = sums->xx[bin] + sums->zz[bin], norm = sqrt(sums->h[bin] * slopes);
    if (!(norm > 0.0))
    {
        return (SeaMoments){0};
    }
    return (SeaMoments){sums->hx[bin] / norm, sums->hz[bin] / norm, (sums->xx[bin] - sums->zz[bin]) / slopes,
                        2.0 * sums->xz[bin] / slopes};
}

double FindVariance(const SeaBins* bins, const SeaSums* sums, double low, double high)
{
    double variance = 0.0;
    for (int i = 0; i < bins->count; ++i)
    {
        double overlap = fmin(high, bins->high[i]) - fmax(low, bins->low[i]);
        variance += fmax(overlap, 0.0) * FindDensity(bins, sums, i);
    }
    return variance;
}

void FindSeaState(const SeaBins* bins, const SeaSums* sums, swSeaState* state)
{
    double before = 0.0, m0 = 0.0, m1 = 0.0, m2 = 0.0, slope = 0.0, a = 0.0, b = 0.0, peakA = 0.0, peakB = 0.0;
    double scale = sums->weight > 0.0 ? 1.0 / sums->weight : 0.0;
    int peak = FindPeakBin(bins, sums);
    memset(state, 0, sizeof(*state));
    for (int i = 0; i < bins->count; ++i)
    {
        double variance = sums->h[i] * scale, f = bins->center[i];
        SeaMoments moments = FindMoments(sums, i);
        before += variance / f;
        m0 += variance;
        m1 += variance * f;
        m2 += variance * f * f;
        slope += (sums->xx[i] + sums->zz[i]) * scale;
        a += variance * moments.a1;
        b += variance * moments.b1;
        peakA = i == peak ? sums->hx[i] : peakA;
        peakB = i == peak ? sums->hz[i] : peakB;
    }
    if (m0 <= 0.0)
    {
        return;
    }
    state->significantHeight = (float)(4.0 * sqrt(m0));
    state->peakPeriod = (float)(1.0 / bins->center[peak]);
    state->periodTm01 = (float)(m0 / m1);
    state->periodTm02 = (float)sqrt(m0 / m2);
    state->energyPeriod = (float)(before / m0);
    state->meanDirection = (float)atan2(b, a);
    state->peakDirection = (float)atan2(peakB, peakA);
    state->spread = (float)sqrt(fmax(2.0 * (1.0 - sqrt(a * a + b * b) / m0), 0.0));
    state->meanSquareSlope = (float)slope;
}

// The state's numbers as an array, to go through them.
#define STATE_NUMBERS 9
static void ListState(const swSeaState* state, double numbers[STATE_NUMBERS])
{
    const float* fields[STATE_NUMBERS] = {&state->significantHeight, &state->peakPeriod,   &state->periodTm01,
                                          &state->periodTm02,        &state->energyPeriod, &state->meanDirection,
                                          &state->peakDirection,     &state->spread,       &state->meanSquareSlope};
    for (int i = 0; i < STATE_NUMBERS; ++i)
    {
        numbers[i] = (double)*fields[i];
    }
}

static void LeaveOut(const SeaSums* all, const SeaSums* group, SeaSums* rest)
{
    rest->weight = all->weight - group->weight;
    for (int i = 0; i < SEA_MAX_BINS; ++i)
    {
        rest->h[i] = all->h[i] - group->h[i];
        rest->hx[i] = all->hx[i] - group->hx[i];
        rest->hz[i] = all->hz[i] - group->hz[i];
        rest->xx[i] = all->xx[i] - group->xx[i];
        rest->zz[i] = all->zz[i] - group->zz[i];
        rest->xz[i] = all->xz[i] - group->xz[i];
    }
}

bool FindSeaError(const SeaBins* bins, int groupCount, const SeaSums* groups, swSeaState* error)
{
    SeaSums* sums = calloc(2, sizeof(SeaSums)); // of all, and of all but one
    if (sums == NULL)
    {
        return false;
    }
    for (int i = 0; i < groupCount; ++i)
    {
        AddSums(groups + i, sums);
    }
    double whole[STATE_NUMBERS], shift[STATE_NUMBERS] = {0.0}, square[STATE_NUMBERS] = {0.0}, errors[STATE_NUMBERS];
    swSeaState state;
    FindSeaState(bins, sums, &state);
    ListState(&state, whole);
    for (int i = 0; i < groupCount; ++i)
    {
        double numbers[STATE_NUMBERS];
        LeaveOut(sums, groups + i, sums + 1);
        FindSeaState(bins, sums + 1, &state);
        ListState(&state, numbers);
        for (int j = 0; j < STATE_NUMBERS; ++j)
        {
            double change = numbers[j] - whole[j];
            change = j == 5 || j == 6 ? remainder(change, 2.0 * SW_PI) : change;
            shift[j] += change / groupCount;
            square[j] += change * change / groupCount;
        }
    }
    for (int j = 0; j < STATE_NUMBERS; ++j)
    {
        double spread = fmax(square[j] - shift[j] * shift[j], 0.0);
        errors[j] = groupCount > 1 ? sqrt((groupCount - 1) * spread) : (double)NAN;
    }
    // The peak's place within its bin is not known: the deviation of what is evenly spread over the bin.
    int peak = FindPeakBin(bins, sums);
    double within = (bins->high[peak] - bins->low[peak]) / (sqrt(12.0) * bins->center[peak] * bins->center[peak]);
    errors[1] = sqrt(errors[1] * errors[1] + within * within);
    *error = (swSeaState){.significantHeight = (float)errors[0],
                          .peakPeriod = (float)errors[1],
                          .periodTm01 = (float)errors[2],
                          .periodTm02 = (float)errors[3],
                          .energyPeriod = (float)errors[4],
                          .meanDirection = (float)errors[5],
                          .peakDirection = (float)errors[6],
                          .spread = (float)errors[7],
                          .meanSquareSlope = (float)errors[8]};
    free(sums);
    return true;
}

bool LookAtSurface(const swWorld* world, double area, int count, SurfaceSums* sums)
{
    size_t n = (size_t)count;
    swPosXZ* points = malloc(n * sizeof(swPosXZ));
    float* height = malloc(n * sizeof(float));
    swVec3* normal = malloc(n * sizeof(swVec3));
    swVec2* slopes = malloc(n * sizeof(swVec2));
    bool isFine = points != NULL && height != NULL && normal != NULL && slopes != NULL;
    if (isFine)
    {
        swQueryDef def = swDefaultQueryDef();
        swSurfaceSamples samples = {.height = height, .normal = normal};
        for (int i = 0; i < count; ++i)
        {
            points[i] = PlaceGauge(area, i);
        }
        swMoment_QuerySurface(swWorld_GetMoment(world), &def, count, points, &samples, NULL);
        swMoment_QueryParticles(swWorld_GetMoment(world), &def, count, points, &(swSurfaceSamples){0}, slopes, NULL);
    }
    for (int i = 0; i < count && isFine; ++i)
    {
        double h = (double)height[i] - swWorld_GetSeaLevel(world);
        double x = (double)normal[i].x, y = (double)normal[i].y, z = (double)normal[i].z;
        sums->count += 1.0;
        sums->height += h;
        sums->heightSquare += h * h;
        sums->slopeSquare += y > 0.0 ? (x * x + z * z) / (y * y) : 0.0;
        sums->particleSlopeSquare +=
            (double)slopes[i].x * (double)slopes[i].x + (double)slopes[i].y * (double)slopes[i].y;
    }
    free(points);
    free(height);
    free(normal);
    free(slopes);
    return isFine;
}

// Slices of texels of 0.5 m to 16 m: 64 m to 2 km.
#define FOAM_RESOLUTION 128
#define FOAM_SLICES 6

// Foam is looked at every second after the first ones, the mean being right from the start.
#define FOAM_WARM_UP 4
#define FOAM_LOOKS 8
#define FOAM_STEPS 10 // a second

static double GetMeanFoam(const swView* view)
{
    double sum = 0.0;
    for (int slice = 0; slice < FOAM_SLICES; ++slice)
    {
        const float* foam = swView_GetFoam(view, slice);
        for (int i = 0; i < FOAM_RESOLUTION * FOAM_RESOLUTION; ++i)
        {
            sum += (double)foam[i];
        }
    }
    return sum / (FOAM_SLICES * FOAM_RESOLUTION * FOAM_RESOLUTION);
}

double MeasureFoam(swWorld* world, double x, double z)
{
    swViewDef def = swDefaultViewDef();
    def.resolution = FOAM_RESOLUTION;
    def.sliceCount = FOAM_SLICES;
    def.finestTexel = 0.5f;
    def.enableCpuLayers = true;
    swView* view = NULL;
    if (swCreateView(world, &def, &view) != SW_SUCCESS)
    {
        return (double)NAN;
    }
    swView_SetViewpoint(view, (swPos){x, swWorld_GetSeaLevel(world), z});
    double sum = 0.0;
    bool isFine = true;
    for (int step = 0; step <= (FOAM_WARM_UP + FOAM_LOOKS) * FOAM_STEPS && isFine; ++step)
    {
        isFine = swWorld_Step(world, step == 0 ? 0.0 : 1.0 / FOAM_STEPS) == SW_SUCCESS;
        bool isLook = step > FOAM_WARM_UP * FOAM_STEPS && step % FOAM_STEPS == 0;
        sum += isFine && isLook ? GetMeanFoam(view) / FOAM_LOOKS : 0.0;
    }
    swDestroyView(view);
    return isFine ? sum : (double)NAN;
}
