// SPDX-License-Identifier: MIT
// The foam that a sea has. The wind says how much, the waves say where.
//
// Cover by wind: the geometric mean of W = 3.84e-6 U^3.41 [Monahan and O'Muircheartaigh 1980] and of the cubics of
// [Callaghan 2008], of which the upper one goes on beyond its 23 m/s; W is then bent to 1 - exp(-W), so that a
// hurricane is not all foam.
//
// A place of the surface folds when J = (1 + a)(1 + b) - c^2 falls below a threshold, where the strains a = dDx/dx,
// b = dDz/dz and the shear c = dDx/dz of a Gaussian sea are normal numbers. Their variances follow from the spectrum.
// Each fold leaves foam, which fades at the rate f. With folds at the rate n a place and second, each turning the share
// q of what is clear into foam, the mean of the steady state is
//   W = n q / (n q + f),
// exactly so if folds come at random times (that the foam before a fold is the mean). So n follows from W, and the
// threshold from n: the rate at which J crosses it downwards [Rice 1945]. Thresholds by the expected fold of a spectrum
// are the idea of [Dupuy and Bruneton 2012].
//
// Growth is such that a mean fold, growth x (integral of threshold - J over its time) = GROWN, covers the share
// 1 - exp(-GROWN) of a place; as folds differ, q = SHARE in the mean: the fold's height over the threshold is
// exponential, its area goes with the power 3/2 of that. Where no wave is known foam grows by the mean fold all the
// time, with unknownGrowth, which makes the same W.

#include "core/sim/whitecaps.h"

#include <math.h>
#include <string.h>

#include "core/lod/scroll.h"
#include "core/math/scalar.h"
#include "core/sim/foam.h"

#define GROWN 1.0
#define SHARE 0.41682 // the mean of 1 - exp(-GROWN h^3/2 / Gamma(5/2)) over exponential h

// No sea is covered more than this, whatever the artist's gain.
#define MOST_COVER 0.98

// Points over which the strain across the waves and the shear are averaged: every three quarters of a deviation, up to
// 4.5.
#define POINTS 13
#define POINT_STEP 0.75
#define POINT_COUNT (POINTS * (POINTS / 2 + 1))

// Three or four are enough for most seas; more only where the sea folds all over.
#define MOST_SECANTS 24

// J of the least threshold that is looked at: the surface has long passed through itself.
#define LEAST_THRESHOLD (-4.0)

#define MOST_GROWTH 1e5

// Waves of all directions alike want 0.7, waves of one 1.
#define LEAST_BEND 0.3f

// Callaghan's two cubics meet here, m/s.
#define CALLAGHAN_CHANGE 10.18

float swGetWhitecapCover(float wind)
{
    double u = (double)wind;
    if (!(u > 3.7))
    {
        return 0.0f;
    }
    double low = u - 3.7, high = u + 1.98;
    double callaghan = u < CALLAGHAN_CHANGE ? 3.18e-5 * low * low * low : 4.82e-6 * high * high * high;
    double monahan = 3.84e-6 * swPow(u, 3.41);
    return (float)(1.0 - swExp(-sqrt(callaghan * monahan)));
}

// ---- strain ----

static void addStrain(swStrain* sum, const swStrain* strain)
{
    sum->cccc += strain->cccc;
    sum->cccs += strain->cccs;
    sum->ccss += strain->ccss;
    sum->csss += strain->csss;
    sum->ssss += strain->ssss;
}

// Mean wave number of a tile, rad/m, and omega^2.
static double getSquareOmega(double gravity, double depth, double wavelength)
{
    double k = 2.0 * SW_PI / wavelength;
    double kd = k * depth;
    return gravity * k * (kd < 20.0 ? swTanh(kd) : 1.0);
}

static bool isLocal(const swFrame* frame, int system)
{
    return frame->inputs != NULL && (frame->inputs->localSystems >> system & 1u) != 0;
}

// Local systems are not all in one place. The law is that of a place which has one of them, beside the systems that are
// everywhere: the one that strains the surface most, at weight 1. -1 where there is none.
static int findLocalSystem(const swFrame* frame)
{
    float strains[SW_MAX_WAVE_SYSTEMS] = {0.0f};
    for (int i = 0; i < frame->tileCount; ++i)
    {
        strains[frame->tiles[i].system] += swGetStrainVariance(&frame->tiles[i].strain);
    }
    for (int i = 0; i < frame->waveCount; ++i)
    {
        swStrain strain = {0};
        swAddFreeWaveStrain(&strain, &frame->waves[i]);
        strains[frame->waves[i].system] += swGetStrainVariance(&strain);
    }
    int most = -1;
    for (int system = 0; system < SW_MAX_WAVE_SYSTEMS; ++system)
    {
        bool isMore = isLocal(frame, system) && (most < 0 || strains[system] > strains[most]);
        most = isMore ? system : most;
    }
    return most;
}

// Strain of the waves from minWavelength up to below maxWavelength, and of its rate's variance, if asked for.
static swStrain sumStrain(const swFrame* frame, float minWavelength, float maxWavelength, double* rate)
{
    bool hasLocal = frame->inputs != NULL && frame->inputs->localSystems != 0;
    int local = hasLocal ? findLocalSystem(frame) : -1;
    swStrain sum = {0};
    double gravity = (double)frame->gravity;
    double rates = 0.0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        bool isThere = !hasLocal || tile->system == local || !isLocal(frame, tile->system);
        if (isThere && tile->minWavelength >= minWavelength && tile->minWavelength < maxWavelength)
        {
            addStrain(&sum, &tile->strain);
            double middle = sqrt((double)tile->minWavelength * (double)tile->maxWavelength);
            rates += (double)swGetStrainVariance(&tile->strain) * getSquareOmega(gravity, (double)tile->depth, middle);
        }
    }
    for (int i = 0; i < frame->waveCount; ++i)
    {
        const swFreeWave* wave = &frame->waves[i];
        bool isThere = !hasLocal || wave->system == local || !isLocal(frame, wave->system);
        if (isThere && wave->wavelength >= minWavelength && wave->wavelength < maxWavelength)
        {
            swStrain strain = {0};
            swAddFreeWaveStrain(&strain, wave);
            addStrain(&sum, &strain);
            rates += (double)swGetStrainVariance(&strain) *
                     getSquareOmega(gravity, (double)wave->depth, (double)wave->wavelength);
        }
    }
    if (rate != NULL)
    {
        *rate = rates;
    }
    return sum;
}

// The axis along which waves strain most, as a unit vector.
static void findAxis(const swStrain* strain, float* x, float* z)
{
    double difference = (double)strain->cccc - (double)strain->ssss; // E[c^2 - s^2]
    double cross = 2.0 * ((double)strain->cccs + (double)strain->csss);
    double length = sqrt(difference * difference + cross * cross);
    double c2 = length > 0.0 ? difference / length : 1.0;
    double c = sqrt(fmax(0.5 * (1.0 + c2), 0.0));
    double s = sqrt(fmax(0.5 * (1.0 - c2), 0.0));
    *x = (float)c;
    *z = (float)(cross < 0.0 ? -s : s);
}

// Variances of the strain along and across the waves, and of the shear, which is also the covariance of the other two.
typedef struct Axes
{
    float along, across, shear;
} Axes;

static Axes turnStrain(const swStrain* strain)
{
    float c, s;
    findAxis(strain, &c, &s);
    float along = c * c * c * c * strain->cccc + 4.0f * c * c * c * s * strain->cccs +
                  6.0f * c * c * s * s * strain->ccss + 4.0f * c * s * s * s * strain->csss +
                  s * s * s * s * strain->ssss;
    float across = s * s * s * s * strain->cccc - 4.0f * s * s * s * c * strain->cccs +
                   6.0f * c * c * s * s * strain->ccss - 4.0f * s * c * c * c * strain->csss +
                   c * c * c * c * strain->ssss;
    along = fmaxf(along, 0.0f);
    across = fmaxf(across, 0.0f);
    return (Axes){
        .along = along,
        .across = across,
        .shear = fmaxf(0.5f * (swGetStrainVariance(strain) - along - across), 0.0f),
    };
}

// ---- folds ----

// J over the strain across the waves and the shear: at each point the strain along them is a normal number.
typedef struct Points
{
    int count;
    double weights[POINT_COUNT]; // sum 1
    double scales[POINT_COUNT];  // of J with the strain along the waves
    double offsets[POINT_COUNT]; // edge = factor threshold + offset, in deviations
    double factors[POINT_COUNT];
    double deviation; // of the strain along the waves, given the others
} Points;

typedef struct Folds
{
    double rate; // at which J falls below the threshold, 1/s
    double mean; // of max(threshold - J, 0)
} Folds;

static void placePoints(const Axes* all, Points* points)
{
    double acrossDeviation = sqrt((double)all->across);
    double slope = all->across > 0.0f ? (double)all->shear / (double)all->across : 0.0;
    double sum = 0.0;
    points->deviation = sqrt(fmax((double)all->along - slope * (double)all->shear, 1e-12));
    points->count = 0;
    for (int i = 0; i < POINTS; ++i)
    {
        double z = POINT_STEP * (i - POINTS / 2);
        double across = z * acrossDeviation;
        double scale = fmax(1.0 + across, 0.05);
        for (int j = 0; j <= POINTS / 2; ++j)
        {
            double y = POINT_STEP * j;
            double square = y * y * (double)all->shear;
            int n = points->count++;
            points->weights[n] = (j == 0 ? 1.0 : 2.0) * swExp(-0.5 * (z * z + y * y));
            points->scales[n] = scale;
            points->factors[n] = 1.0 / (scale * points->deviation);
            points->offsets[n] = square * points->factors[n] - (1.0 + slope * across) / points->deviation;
            sum += points->weights[n];
        }
    }
    for (int n = 0; n < points->count; ++n)
    {
        points->weights[n] /= sum;
    }
}

// Folds at the rate exp(-margin^2 / 2) of all crossings.
static double findMargin(const Points* points, double threshold)
{
    double part = 0.0;
    for (int n = 0; n < points->count; ++n)
    {
        double edge = points->factors[n] * threshold + points->offsets[n];
        part += points->weights[n] * swExp(-0.5 * edge * edge);
    }
    return sqrt(fmax(-2.0 * swLn(fmin(fmax(part, 1e-300), 1.0)), 0.0));
}

static Folds findFolds(const Points* points, double crossing, double threshold)
{
    Folds folds = {0};
    for (int n = 0; n < points->count; ++n)
    {
        double edge = points->factors[n] * threshold + points->offsets[n];
        folds.rate += points->weights[n] * crossing * swExp(-0.5 * edge * edge);
        folds.mean += points->weights[n] * points->scales[n] * points->deviation * (double)swFoamExcess((float)edge);
    }
    return folds;
}

// The threshold with that margin, which falls all but linearly: by secants that are kept between two bounds.
static double findThreshold(const Points* points, double deviation, double margin)
{
    double low = LEAST_THRESHOLD, high = 1.0;
    double before = high, marginBefore = findMargin(points, high);
    if (marginBefore >= margin)
    {
        return high;
    }
    double threshold = fmax(1.0 - margin * deviation, low);
    for (int i = 0; i < MOST_SECANTS; ++i)
    {
        double found = findMargin(points, threshold);
        if (fabs(found - margin) < 1e-6)
        {
            break;
        }
        low = found > margin ? threshold : low;
        high = found > margin ? high : threshold;
        double step = found != marginBefore ? (margin - found) * (threshold - before) / (found - marginBefore) : 0.0;
        before = threshold;
        marginBefore = found;
        double next = threshold + step;
        threshold = next > low && next < high ? next : 0.5 * (low + high);
    }
    return threshold;
}

// The bend with which swFoamFold() expects the same fold of a place whose waves are all unknown.
static float findBend(float deviation, float threshold, double fold)
{
    float low = LEAST_BEND, high = 1.0f;
    for (int i = 0; i < 20; ++i)
    {
        float middle = 0.5f * (low + high);
        bool isTooMuch = (double)swFoamFold(1.0f, threshold, (swFoamRest){deviation, middle}) > fold;
        low = isTooMuch ? low : middle;
        high = isTooMuch ? middle : high;
    }
    return 0.5f * (low + high);
}

// ---- the law ----

static swFoamLaw makeLaw(const swFoamDef* def, float wind, const swStrain* strain, double strainRate)
{
    swFoamLaw law = {.wind = wind, .threshold = def->threshold, .rest.bend = 1.0f};
    Axes axes = turnStrain(strain);
    double variance = (double)swGetStrainVariance(strain);
    if (variance < 1e-8) // no wave moves water sideways: nothing folds
    {
        return law;
    }
    double crossing = sqrt(strainRate / variance) / (2.0 * SW_PI);
    double fade = (double)def->fadeRate;
    double gain = (double)def->coverage;
    double cover = fmin(1.0 - swPow(1.0 - (double)swGetWhitecapCover(wind), gain), MOST_COVER);
    Points points;
    placePoints(&axes, &points);
    double threshold = LEAST_THRESHOLD;
    if (cover > 0.0)
    {
        double part = fade * cover / (1.0 - cover) / SHARE / crossing;
        double margin = sqrt(fmax(-2.0 * swLn(fmin(fmax(part, 1e-300), 1.0)), 0.0));
        threshold = findThreshold(&points, sqrt(variance), margin);
    }
    threshold = fmax(threshold, (double)def->threshold);
    Folds folds = findFolds(&points, crossing, threshold);
    double ratio = folds.mean > 1e-30 ? folds.rate / folds.mean : 0.0;
    double births = SHARE * folds.rate;
    law.rest = (swFoamRest){.deviation = (float)sqrt(variance)};
    law.rest.bend = findBend(law.rest.deviation, (float)threshold, folds.mean);
    law.cover = (float)(births / (births + fade));
    law.threshold = (float)threshold;
    law.growth = (float)fmin(GROWN * ratio, MOST_GROWTH);
    law.unknownGrowth = (float)fmin(SHARE * ratio, MOST_GROWTH);
    return law;
}

// Each system's waves go with a current of their own, but there is one water.
static void findCurrent(const swFrame* frame, swFoamLaw* law)
{
    float sum = 0.0f, x = 0.0f, z = 0.0f;
    for (int i = 0; i < frame->tileCount + frame->waveCount; ++i)
    {
        bool isTile = i < frame->tileCount;
        const swFreeWave* wave = isTile ? NULL : &frame->waves[i - frame->tileCount];
        swStrain strain = {.cccc = 0.0f};
        if (isTile)
        {
            strain = frame->tiles[i].strain;
        }
        else
        {
            swAddFreeWaveStrain(&strain, wave);
        }
        swVec2 velocity = swFindDriftVelocity(isTile ? &frame->tiles[i].drift : &wave->drift, frame->ticks);
        float weight = swGetStrainVariance(&strain);
        sum += weight;
        x += weight * velocity.x;
        z += weight * velocity.y;
    }
    law->currentX = sum > 0.0f ? x / sum : 0.0f;
    law->currentZ = sum > 0.0f ? z / sum : 0.0f;
}

void swFindFoamLaw(swWhitecaps* whitecaps, swFrame* frame)
{
    const swFoamDef* def = &frame->foam;
    double rate;
    swStrain strain = sumStrain(frame, def->minWavelength, INFINITY, &rate);
    float wind = def->windSpeed > 0.0f ? def->windSpeed : frame->wind;
    float inputs[16] = {def->fadeRate, def->coverage, def->threshold, def->minWavelength, wind,        strain.cccc,
                        strain.cccs,   strain.ccss,   strain.csss,    strain.ssss,        (float)rate, frame->gravity};
    if (!whitecaps->isKnown || memcmp(inputs, whitecaps->inputs, sizeof inputs) != 0)
    {
        memcpy(whitecaps->inputs, inputs, sizeof inputs);
        whitecaps->law = makeLaw(def, wind, &strain, rate);
        whitecaps->isKnown = true;
    }
    frame->foamLaw = whitecaps->law;
    findCurrent(frame, &frame->foamLaw);
}

// ---- slices ----

// The slice where `slice` finds folds: the finest from itself on without waves shorter than foam counts.
static int findFoldSlice(const swFrame* frame, const swStackFrame* stack, int slice)
{
    int found = slice;
    while (found < stack->sliceCount - 1 && stack->slices[found].minWavelength < frame->foam.minWavelength)
    {
        found += 1;
    }
    return found;
}

void swPlanFoam(const swLayerPlan* plan)
{
    const swFrame* frame = plan->frame;
    swStackFrame* stack = plan->stack;
    const swFoamLaw* law = &frame->foamLaw;
    stack->layers[SW_LAYER_FOAM].isCarried = swIsFoamCarried(frame);
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        int source = findFoldSlice(frame, stack, i);
        swPastSource fold[SW_PAST_SOURCES];
        swFindPastSources(&stack->slices[i], stack->resolution, 1, &stack->slices[source], fold);
        fold[0].slice = source;
        float shortest = stack->slices[source].minWavelength;
        swStrain strain = sumStrain(frame, frame->foam.minWavelength, shortest, NULL);
        float variance = swGetStrainVariance(&strain);
        swFoamBirth birth = {.fold = fold[0]};
        birth.rest = (swFoamRest){.deviation = sqrtf(variance), .bend = law->rest.bend};
        float all = law->rest.deviation * law->rest.deviation;
        float share = all > 0.0f ? fminf(variance / all, 1.0f) : 1.0f;
        // A fold that is not seen whole does not fill a place at once: measured over slices of waves from 2 m up.
        float known = (1.0f - share) * (1.0f - share);
        birth.growth = law->unknownGrowth + (law->growth - law->unknownGrowth) * known * known;
        memcpy(stack->layers[SW_LAYER_FOAM].params[i], &birth, sizeof birth);
    }
}
