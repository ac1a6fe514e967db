// SPDX-License-Identifier: MIT
// Gusts are waves of the wind's speed along and across its mean, which the mean carries past a place as they are
// [Taylor 1938]. Twelve frequencies a constant ratio apart have the energy of the spectrum f S / sigma^2 ~ n / (1 +
// 6 n)^(5/3), n = f T [Kaimal 1972], scaled to the variance that was asked for. Each wave's front stands aslant by an
// angle of its own, so that gusts have an end sideways too. Phases are integers (see swMode): exact for ever, the same
// on every machine.

#include "core/input/wind.h"

#include <math.h>

#include "core/math/random.h"
#include "core/math/scalar.h"
#include "seaway/math.h"
#include "seaway/waves.h"

#define ACROSS 0.75f // the deviation across the mean, over that along it

// Cycles in a time scale: of the slowest gust, and from one to the next. The fastest has 2.
#define SLOWEST 0.02
#define RATIO 1.52
// Most tangent of the angle between a gust's front and the line across the wind.
#define MOST_SLANT 1.5
// Gusts of a breath of wind do not stand still: they are carried at least so fast, m/s.
#define LEAST_CARRY 0.5

#define LATEST ((int64_t)1 << 62) // ticks, more than those of SW_LARGEST_TIME

enum
{
    STREAM_ALONG = 201,
    STREAM_ACROSS,
    STREAM_SLANT
};

swWind swMakeWind(const swWindDef* def)
{
    return (swWind){.from = *def, .to = *def};
}

// How far the change has come, 0 to 1.
static float getShare(int64_t begin, int64_t length, int64_t ticks)
{
    int64_t passed = swGetTicksBetween(begin, ticks);
    if (length <= 0 || passed >= length)
    {
        return 1.0f;
    }
    return passed > 0 ? (float)((double)passed / (double)length) : 0.0f;
}

static swVec2 getMean(const swWindDef* def)
{
    double direction = (double)def->direction;
    return (swVec2){(float)((double)def->speed * swCos(direction)), (float)((double)def->speed * swSin(direction))};
}

static swVec2 mix(swVec2 from, swVec2 to, float share)
{
    return (swVec2){from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share};
}

void swChangeWind(swWind* wind, const swWindDef* def, int64_t ticks, double seconds)
{
    float share = getShare(wind->begin, wind->length, ticks);
    swWindDef reached = wind->to;
    if (share < 1.0f)
    {
        swVec2 mean = mix(getMean(&wind->from), getMean(&wind->to), share);
        reached.speed = fminf(sqrtf(mean.x * mean.x + mean.y * mean.y), 100.0f);
        reached.direction = reached.speed > 0.0f ? (float)swAtan2((double)mean.y, (double)mean.x) : def->direction;
    }
    wind->from = seconds > 0.0 ? reached : *def;
    wind->to = *def;
    wind->begin = ticks;
    wind->length = (int64_t)floor(seconds * SW_TICKS_PER_SECOND + 0.5);
}

static void makeGusts(const swWindDef* def, swGustyWind* wind)
{
    swVec2 mean = getMean(def);
    *wind = (swGustyWind){.meanX = mean.x, .meanZ = mean.y};
    if (!(def->speed > 0.0f) || def->gustStrength == 0.0f)
    {
        return;
    }
    double speed = (double)def->speed, unitX = (double)mean.x / speed, unitZ = (double)mean.y / speed;
    double shares[SW_GUSTS], sum = 0.0, cycles = SLOWEST;
    for (int i = 0; i < SW_GUSTS; ++i, cycles *= RATIO)
    {
        shares[i] = cycles * swPow(1.0 + 6.0 * cycles, -5.0 / 3.0);
        sum += shares[i];
    }
    wind->gustCount = SW_GUSTS;
    cycles = SLOWEST;
    for (int i = 0; i < SW_GUSTS; ++i, cycles *= RATIO)
    {
        double frequency = cycles / (double)def->gustSeconds;
        double slant = MOST_SLANT * (2.0 * swHashToUnit(swHashWave(def->gustSeed, i, 0, 0, STREAM_SLANT)) - 1.0);
        double turns = frequency / fmax(speed, LEAST_CARRY);
        float amplitude = (float)(sqrt(2.0 * shares[i] / sum) * speed) * def->gustStrength;
        wind->gusts[i] = (swGust){
            .turnsX = turns * (unitX - slant * unitZ),
            .turnsZ = turns * (unitZ + slant * unitX),
            .frequency = (uint64_t)(frequency / SW_TICKS_PER_SECOND * 0x1p64),
            .phaseAlong = (uint32_t)(swHashWave(def->gustSeed, i, 0, 0, STREAM_ALONG) >> 32),
            .phaseAcross = (uint32_t)(swHashWave(def->gustSeed, i, 0, 0, STREAM_ACROSS) >> 32),
            .alongX = amplitude * (float)unitX,
            .alongZ = amplitude * (float)unitZ,
        };
    }
}

void swDeriveWind(const swWind* wind, int64_t ticks, swWindFrame* frame)
{
    bool isSteady = getShare(wind->begin, wind->length, ticks) >= 1.0f;
    frame->isNamed = wind->to.speed > 0.0f || (!isSteady && wind->from.speed > 0.0f);
    frame->begin = wind->begin;
    frame->length = wind->length;
    frame->fromDef = wind->from;
    frame->toDef = wind->to;
    makeGusts(&wind->from, &frame->from);
    makeGusts(&wind->to, &frame->to);
}

swVec2 swFindMeanWind(const swWindFrame* wind, int64_t ticks)
{
    const swVec2 from = {wind->from.meanX, wind->from.meanZ}, to = {wind->to.meanX, wind->to.meanZ};
    return mix(from, to, getShare(wind->begin, wind->length, ticks));
}

// A fraction of a turn as one of 2^32.
static uint32_t getTurns(double turns)
{
    return (uint32_t)(int64_t)floor((turns - floor(turns)) * 0x1p32);
}

static swVec2 findWind(const swGustyWind* wind, int64_t ticks, swPosXZ point)
{
    swVec2 sum = {wind->meanX, wind->meanZ};
    for (int i = 0; i < wind->gustCount; ++i)
    {
        const swGust* gust = &wind->gusts[i];
        uint32_t turns = getTurns(gust->turnsX * point.x) + getTurns(gust->turnsZ * point.z) -
                         (uint32_t)((gust->frequency * (uint64_t)ticks) >> 32);
        float along, across, sine;
        swSinCosTurns(turns + gust->phaseAlong, &sine, &along);
        swSinCosTurns(turns + gust->phaseAcross, &sine, &across);
        across *= ACROSS;
        sum.x += along * gust->alongX - across * gust->alongZ;
        sum.y += along * gust->alongZ + across * gust->alongX;
    }
    return sum;
}

void swFindWinds(const swWindFrame* wind, int64_t ticks, int count, const swPosXZ* points, swVec2* winds)
{
    float share = getShare(wind->begin, wind->length, ticks);
    for (int i = 0; i < count; ++i)
    {
        winds[i] = findWind(&wind->to, ticks, points[i]);
        winds[i] = share < 1.0f ? mix(findWind(&wind->from, ticks, points[i]), winds[i], share) : winds[i];
    }
}

bool swIsWindGood(const swWind* wind)
{
    return wind->begin <= LATEST && wind->begin >= -LATEST && wind->length >= 0 &&
           wind->length <= (int64_t)(SW_MAX_TRANSITION * SW_TICKS_PER_SECOND) &&
           swFields_Check(&swWindFields, &wind->from, NULL, 0) && swFields_Check(&swWindFields, &wind->to, NULL, 0);
}

void swStreamWind(swStream* stream, const swWindDef* to, swWind* wind)
{
    wind->from = swIsReading(stream) ? swDefaultWindDef() : wind->from;
    swStreamDef(stream, &swWindFields, &wind->from);
    swStreamI64(stream, &wind->begin);
    swStreamI64(stream, &wind->length);
    if (swIsReading(stream))
    {
        wind->to = *to;
        stream->isBroken = stream->isBroken || !swIsWindGood(wind);
    }
}

// A world that names no wind has the digest of one that never knew of any.
void swAddHashWind(swHash* hash, const swWind* wind, int64_t ticks)
{
    bool isSteady = getShare(wind->begin, wind->length, ticks) >= 1.0f;
    if (wind->to.speed == 0.0f && (isSteady || wind->from.speed == 0.0f))
    {
        return;
    }
    swHashDef(hash, &swWindFields, &wind->to);
    swHashDef(hash, &swWindFields, isSteady ? &wind->to : &wind->from);
    swAddHash(hash, isSteady ? 0 : (uint64_t)wind->begin);
    swAddHash(hash, isSteady ? 0 : (uint64_t)wind->length);
}
