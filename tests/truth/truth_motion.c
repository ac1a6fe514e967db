// SPDX-License-Identifier: MIT
// V12, V13: how the water moves below and at the surface: the published orbit of one wave, the velocity of a whole sea
// against its spectrum's integral, no water made or lost, velocity and acceleration as derivatives of where particles
// are, and the drift that is left when the orbits are averaged.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#define POINT_COUNT 2048

// Of a wave of 1 m amplitude and 8 s over 20 m of water [Dean and Dalrymple 1991].
typedef struct Orbit
{
    double y, along, upward, pressure;
} Orbit;

static swWorld* CreateWave(double wavelength, double depth)
{
    swWaveComponent wave = {.wavelength = (float)wavelength, .amplitude = 1.0f};
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.components = &wave;
    def.componentCount = 1;
    def.chop = 0.0f;
    def.spectrum.depth = (float)depth;
    return CreateTruthSea(&def);
}

// The largest of each over one wavelength at a height.
static Orbit FindOrbit(const swWorld* world, double wavelength, double y)
{
    swQueryDef query = swDefaultQueryDef();
    query.stretching = SW_STRETCHING_LINEAR;
    swPos points[POINT_COUNT];
    swVec3 velocity[POINT_COUNT];
    float pressure[POINT_COUNT];
    Orbit orbit = {.y = y};
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        points[i] = (swPos){wavelength * i / POINT_COUNT, y, 0.0};
    }
    swMoment_QueryVolume(swWorld_GetMoment(world), &query, POINT_COUNT, points,
                         &(swVolumeSamples){.velocity = velocity, .pressureHead = pressure}, NULL);
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        orbit.along = fmax(orbit.along, (double)velocity[i].x);
        orbit.upward = fmax(orbit.upward, fabs((double)velocity[i].y));
        orbit.pressure = fmax(orbit.pressure, (double)pressure[i]);
    }
    return orbit;
}

static void AWaveMovesTheWaterAsAirySays(void** state)
{
    (void)state;
    static const Orbit table[] = {{0.0, 0.8839, 0.7854, 1.0},
                                  {-5.0, 0.6560, 0.5158, 0.7422},
                                  {-10.0, 0.5112, 0.3114, 0.5784},
                                  {-20.0, 0.4054, 0.0, 0.4587}};
    swWorld* world = CreateWave(88.793, 20.0);
    for (int i = 0; i < 4; ++i)
    {
        Orbit orbit = FindOrbit(world, 88.793, table[i].y);
        char what[128];
        snprintf(what, sizeof(what), "Velocity along a wave of 1 m, 8 s over 20 m, %.0f m below", 0.0 - table[i].y);
        FindWithin(&(Finding){"V12", what, "a\xcf\x89 cosh k(y+d) / sinh kd", "m/s", 4}, table[i].along, orbit.along,
                   0.002);
        snprintf(what, sizeof(what), "Velocity upwards, %.0f m below", 0.0 - table[i].y);
        FindNear(&(Finding){"V12", what, "a\xcf\x89 sinh k(y+d) / sinh kd", "m/s", 4}, table[i].upward, orbit.upward,
                 0.001);
        snprintf(what, sizeof(what), "Dynamic pressure, %.0f m below", 0.0 - table[i].y);
        FindWithin(&(Finding){"V12", what, "\xcf\x81 g a cosh k(y+d) / cosh kd", "m of water", 4}, table[i].pressure,
                   orbit.pressure, 0.002);
    }
    swDestroyWorld(world);
}

static swWaveSystemDef MakeSea(swWaveMethod method)
{
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.4, 8.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 8.0, 4096.0, 1);
    def.method = method;
    return def;
}

// Integral over the def's waves of 2 S times omega^n k^m exp(-2 k depth).
static double IntegrateMotion(const swWaveSystemDef* def, int n, int m, double depth)
{
    double low = swGetWaveFrequency((double)def->maxWavelength, (double)INFINITY, 9.81);
    double high = swGetWaveFrequency((double)def->minWavelength, (double)INFINITY, 9.81), sum = 0.0;
    const int count = 4000;
    for (int i = 0; i < count; ++i)
    {
        double f = low + (high - low) * (i + 0.5) / count, k = TURN / swGetWavelength(f, (double)INFINITY, 9.81);
        double energy = (double)swSpectrum_GetDensity(&def->spectrum, (float)f) * (high - low) / count;
        sum += 2.0 * energy * pow(TURN * f, n) * pow(k, m) * exp(-2.0 * k * depth);
    }
    return sum;
}

#define DEPTH 5.0

typedef struct MotionCase
{
    swWaveSystemDef def;
    double squares[8];
} MotionCase;

static void MeasureMotion(void* context, int seed)
{
    MotionCase* motion = context;
    swWaveSystemDef def = motion->def;
    def.seed = 1u + (uint32_t)seed;
    swWorld* world = CreateTruthSea(&def);
    swQueryDef query = swDefaultQueryDef();
    query.stretching = SW_STRETCHING_LINEAR;
    swPosXZ places[POINT_COUNT];
    swPos points[POINT_COUNT];
    swVec3 velocity[POINT_COUNT];
    ScatterPoints(23000.0, seed, POINT_COUNT, places);
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        points[i] = (swPos){places[i].x, -DEPTH, places[i].z};
    }
    swMoment_QueryVolume(swWorld_GetMoment(world), &query, POINT_COUNT, points,
                         &(swVolumeSamples){.velocity = velocity}, NULL);
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        double x = (double)velocity[i].x, y = (double)velocity[i].y, z = (double)velocity[i].z;
        motion->squares[seed] += (x * x + y * y + z * z) / POINT_COUNT;
    }
    swDestroyWorld(world);
}

static void ASeaHasTheVelocityOfItsSpectrum(void** state)
{
    (void)state;
    static const char* const names[2] = {"", " of Gerstner waves"};
    for (int method = 0; method < 2; ++method)
    {
        MotionCase motion = {.def = MakeSea((swWaveMethod)method)};
        int count = Seeds(8);
        double square = 0.0;
        RunJobs(MeasureMotion, &motion, count);
        for (int i = 0; i < count; ++i)
        {
            square += motion.squares[i] / count;
        }
        char what[128];
        snprintf(what, sizeof(what), "RMS velocity 5 m below a JONSWAP sea%s, Hs 2 m, Tp 8 s", names[method]);
        FindWithin(&(Finding){"V12", what, "2 \xe2\x88\xab \xcf\x89\xc2\xb2 exp(2 k y) S", "m/s", 4},
                   sqrt(IntegrateMotion(&motion.def, 2, 0, DEPTH)), sqrt(square), Loosen(0.015));
    }
}

// The derivative of a component along its own axis, by differences of the fourth order.
static double Differentiate(const swVec3 at[4], int axis, double step)
{
    double value[4];
    for (int i = 0; i < 4; ++i)
    {
        value[i] = (double)(axis == 0 ? at[i].x : axis == 1 ? at[i].y : at[i].z);
    }
    return (8.0 * (value[2] - value[1]) - (value[3] - value[0])) / (12.0 * step);
}

static void NoWaterIsMadeOrLost(void** state)
{
    (void)state;
    enum
    {
        PLACES = 200
    };
    swWaveSystemDef def = MakeSea(SW_WAVES_FFT);
    swWorld* world = CreateTruthSea(&def);
    swQueryDef query = swDefaultQueryDef();
    query.stretching = SW_STRETCHING_LINEAR;
    static const double steps[4] = {-2.0, -1.0, 1.0, 2.0};
    const double step = 0.1;
    swPosXZ places[PLACES];
    double divergence = 0.0, gradient = 0.0;
    ScatterPoints(5000.0, 0, PLACES, places);
    for (int i = 0; i < PLACES; ++i)
    {
        swPos points[12];
        swVec3 velocity[12];
        for (int j = 0; j < 12; ++j)
        {
            double offset = step * steps[j % 4];
            points[j] = (swPos){places[i].x + (j / 4 == 0 ? offset : 0.0), -4.0 + (j / 4 == 1 ? offset : 0.0),
                                places[i].z + (j / 4 == 2 ? offset : 0.0)};
        }
        swMoment_QueryVolume(swWorld_GetMoment(world), &query, 12, points, &(swVolumeSamples){.velocity = velocity},
                             NULL);
        double x = Differentiate(velocity, 0, step), y = Differentiate(velocity + 4, 1, step),
               z = Differentiate(velocity + 8, 2, step);
        divergence += (x + y + z) * (x + y + z);
        gradient += x * x + y * y + z * z;
    }
    FindBelow(
        &(Finding){"V12", "Divergence over gradient of velocity 4 m below a JONSWAP sea, RMS", "div u = 0", "", 5},
        1e-4, sqrt(divergence / gradient));
    swDestroyWorld(world);
}

// Particles at three times a step apart.
static void QueryAt(swWorld* world, double time, const swPosXZ* points, const swSurfaceSamples* samples)
{
    swQueryDef query = swDefaultQueryDef();
    swWorld_SetTime(world, time);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    swMoment_QueryParticles(swWorld_GetMoment(world), &query, POINT_COUNT, points, samples, NULL, NULL);
}

static double Subtract(swVec3 a, swVec3 b)
{
    double x = (double)a.x - (double)b.x, y = (double)a.y - (double)b.y, z = (double)a.z - (double)b.z;
    return x * x + y * y + z * z;
}

static void VelocityAndAccelerationAreDerivatives(void** state)
{
    (void)state;
    static const char* const names[2] = {"", " of Gerstner waves"};
    for (int method = 0; method < 2; ++method)
    {
        swWaveSystemDef def = MakeSea((swWaveMethod)method);
        swWorld* world = CreateTruthSea(&def);
        static swPosXZ points[POINT_COUNT];
        static swVec3 places[3][POINT_COUNT], velocity[POINT_COUNT], acceleration[POINT_COUNT];
        const double dt = 0.02;
        ScatterPoints(5000.0, 0, POINT_COUNT, points);
        QueryAt(world, 100.0 - dt, points, &(swSurfaceSamples){.displacement = places[0]});
        QueryAt(world, 100.0 + dt, points, &(swSurfaceSamples){.displacement = places[2]});
        QueryAt(world, 100.0, points,
                &(swSurfaceSamples){.displacement = places[1], .velocity = velocity, .acceleration = acceleration});
        double sums[4] = {0.0};
        for (int i = 0; i < POINT_COUNT; ++i)
        {
            const swVec3 *a = &places[0][i], *b = &places[1][i], *c = &places[2][i], zero = {0};
            float half = (float)(0.5 / dt), square = (float)(1.0 / (dt * dt));
            swVec3 speed = {half * (c->x - a->x), half * (c->y - a->y), half * (c->z - a->z)};
            swVec3 change = {square * (a->x - 2.0f * b->x + c->x), square * (a->y - 2.0f * b->y + c->y),
                             square * (a->z - 2.0f * b->z + c->z)};
            sums[0] += Subtract(speed, velocity[i]);
            sums[1] += Subtract(speed, zero);
            sums[2] += Subtract(change, acceleration[i]);
            sums[3] += Subtract(change, zero);
        }
        char what[128];
        snprintf(what, sizeof(what), "Velocity of particles less the change of their place, sea%s, RMS", names[method]);
        FindBelow(&(Finding){"V12", what, "d/dt", "%", 2}, 1.0, 100.0 * sqrt(sums[0] / sums[1]));
        snprintf(what, sizeof(what), "Acceleration of particles less the change of their velocity, sea%s, RMS",
                 names[method]);
        FindBelow(&(Finding){"V12", what, "d\xc2\xb2/dt\xc2\xb2", "%", 1}, 2.0, 100.0 * sqrt(sums[2] / sums[3]));
        swDestroyWorld(world);
    }
}

static void OneWaveDriftsAsStokesSays(void** state)
{
    (void)state;
    swWorld* world = CreateWave(99.924, (double)INFINITY);
    FindWithin(&(Finding){"V13", "Drift of a wave of 1 m, 8 s, at the surface", "a\xc2\xb2 \xcf\x89 k", "m/s", 5},
               0.04939, (double)swMoment_GetStokesDrift(swWorld_GetMoment(world), 0.0).x, 0.002);
    FindWithin(&(Finding){"V13", "Drift of a wave of 1 m, 8 s, 5 m below", "a\xc2\xb2 \xcf\x89 k exp(2 k y)", "m/s", 5},
               0.02633, (double)swMoment_GetStokesDrift(swWorld_GetMoment(world), 5.0).x, 0.002);
    swDestroyWorld(world);
}

static void ASeaDriftsAsItsSpectrumSays(void** state)
{
    (void)state;
    static const double depths[3] = {0.0, 1.0, 5.0};
    swWaveSystemDef def = MakeSea(SW_WAVES_FFT);
    swWorld* world = CreateTruthSea(&def);
    for (int i = 0; i < 3; ++i)
    {
        swVec2 drift = swMoment_GetStokesDrift(swWorld_GetMoment(world), depths[i]);
        double along = sqrt((double)drift.x * (double)drift.x + (double)drift.y * (double)drift.y);
        char what[128];
        snprintf(what, sizeof(what),
                 "Drift of a JONSWAP sea, Hs 2 m, Tp 8 s, cos\xc2\xb2\xcb\xa2 with s = 8, %.0f m below", depths[i]);
        // Along the mean direction each frequency's waves drift by r1 = s / (s + 1).
        FindWithin(&(Finding){"V13", what, "2 \xe2\x88\xab \xcf\x89 k exp(2 k y) S r\xe2\x82\x81", "m/s", 5},
                   IntegrateMotion(&def, 1, 1, depths[i]) * 8.0 / 9.0, along, 0.01);
        assert_true(fabs(atan2((double)drift.y, (double)drift.x) - 0.4) < 0.01);
    }
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AWaveMovesTheWaterAsAirySays), cmocka_unit_test(ASeaHasTheVelocityOfItsSpectrum),
        cmocka_unit_test(NoWaterIsMadeOrLost),          cmocka_unit_test(VelocityAndAccelerationAreDerivatives),
        cmocka_unit_test(OneWaveDriftsAsStokesSays),    cmocka_unit_test(ASeaDriftsAsItsSpectrumSays),
    };
    BeginTruth("truth_motion");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
