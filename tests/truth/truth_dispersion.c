// SPDX-License-Identifier: MIT
// V6: every wave travels as its length and the depth say, for as long as one likes.
//
// A band's waves stand on the lattice of its tile, so a transform of particles' heave over exactly one tile tells the
// waves apart without a window. At three times a step apart a wave number k holds waves that go along k and against it,
// but h(t - dt) + h(t + dt) = 2 cos(omega dt) h(t) for both. Where all go one way, the phase itself can be followed,
// from seconds to thirty days, each step foretold by the one before.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#include "measure/measure_transform.h"

#define SIDE 128 // samples along a tile
#define DAY 86400.0

typedef struct Tile
{
    swWorld* world;
    double side; // m
    swPosXZ* points;
    swVec3* displacement;
    swMeasureComplex *roots, *line;
    swMeasureComplex* times[3]; // spectra of heave
} Tile;

static Tile* CreateTile(const swWaveSystemDef* def)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWaveSystemId id;
    swBandInfo bands[SW_MAX_BANDS];
    Tile* tile = calloc(1, sizeof(Tile));
    assert_non_null(tile);
    assert_int_equal(swCreateWorld(&host, &worldDef, &tile->world), SW_SUCCESS);
    assert_int_equal(swCreateWaveSystem(tile->world, def, &id), SW_SUCCESS);
    assert_int_equal(swWorld_Step(tile->world, 0.0), SW_SUCCESS);
    assert_int_equal(swWaveSystem_GetBands(tile->world, id, bands), 1);
    assert_int_equal(bands[0].tileCount, 1);
    tile->side = (double)bands[0].tileSide;
    tile->points = malloc(SIDE * SIDE * sizeof(swPosXZ));
    tile->displacement = malloc(SIDE * SIDE * sizeof(swVec3));
    tile->roots = malloc(SIDE * sizeof(swMeasureComplex));
    tile->line = malloc(SIDE * sizeof(swMeasureComplex));
    assert_true(tile->points != NULL && tile->displacement != NULL && tile->roots != NULL && tile->line != NULL);
    for (int i = 0; i < 3; ++i)
    {
        tile->times[i] = malloc(SIDE * SIDE * sizeof(swMeasureComplex));
        assert_non_null(tile->times[i]);
    }
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        tile->points[i] = (swPosXZ){tile->side * (i % SIDE) / SIDE, tile->side * (i / SIDE) / SIDE};
    }
    swFillRoots(SIDE, tile->roots);
    return tile;
}

static void DestroyTile(Tile* tile)
{
    swDestroyWorld(tile->world);
    free(tile->points);
    free(tile->displacement);
    free(tile->roots);
    free(tile->line);
    for (int i = 0; i < 3; ++i)
    {
        free(tile->times[i]);
    }
    free(tile);
}

static void MeasureTile(Tile* tile, double time, swMeasureComplex* spectrum)
{
    swQueryDef query = swDefaultQueryDef();
    swWorld_SetTime(tile->world, time);
    assert_int_equal(swWorld_Step(tile->world, 0.0), SW_SUCCESS);
    swMoment_QueryParticles(swWorld_GetMoment(tile->world), &query, SIDE * SIDE, tile->points,
                            &(swSurfaceSamples){.displacement = tile->displacement}, NULL, NULL);
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        spectrum[i] = (swMeasureComplex){(double)tile->displacement[i].y, 0.0};
    }
    swTransformSquare(spectrum, SIDE, tile->roots, tile->line);
}

static double GetWaveNumber(const Tile* tile, int index)
{
    int x = index % SIDE, z = index / SIDE;
    x = x < SIDE / 2 ? x : x - SIDE;
    z = z < SIDE / 2 ? z : z - SIDE;
    return TURN / tile->side * sqrt((double)(x * x + z * z));
}

static double GetPower(swMeasureComplex a)
{
    return a.re * a.re + a.im * a.im;
}

static double FindStrongest(const swMeasureComplex* spectrum)
{
    double strongest = 0.0;
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        strongest = fmax(strongest, GetPower(spectrum[i]));
    }
    return strongest;
}

// Largest error of the phase speed of all waves within 60 dB of the strongest.
static double FindSpeedError(const Tile* tile, double dt, double depth, int* count)
{
    double strongest = FindStrongest(tile->times[1]), worst = 0.0;
    *count = 0;
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        swMeasureComplex before = tile->times[0][i], now = tile->times[1][i], after = tile->times[2][i];
        if (GetPower(now) < 1e-6 * strongest)
        {
            continue;
        }
        double along = (before.re + after.re) * now.re + (before.im + after.im) * now.im;
        double measured = acos(fmin(fmax(0.5 * along / GetPower(now), -1.0), 1.0)) / dt;
        double k = GetWaveNumber(tile, i);
        double asked = TURN * swGetWaveFrequency(TURN / k, depth, 9.81);
        worst = fmax(worst, fabs(measured / asked - 1.0));
        *count += 1;
    }
    return worst;
}

static void CheckSpeeds(double shortest, double depth)
{
    double period = 1.0 / swGetWaveFrequency(1.4 * shortest, depth, 9.81);
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 0.02 * shortest, period, 0.3, 1.0);
    swWaveSystemDef def = MakeWaves(&spectrum, shortest, 2.0 * shortest, 5);
    def.spectrum.depth = (float)depth;
    Tile* tile = CreateTile(&def);
    double dt = 0.25 * period;
    for (int i = 0; i < 3; ++i)
    {
        MeasureTile(tile, 1000.0 + dt * i, tile->times[i]);
    }
    int count = 0;
    double worst = FindSpeedError(tile, dt, depth, &count);
    assert_true(count > 1000);
    char what[128], over[32] = "deep water";
    if (isfinite(depth))
    {
        snprintf(over, sizeof(over), "%g m of water", depth);
    }
    snprintf(what, sizeof(what), "Phase speed of %d waves of %g to %g m over %s, worst", count, shortest,
             2.0 * shortest, over);
    FindBelow(&(Finding){"V6", what, "\xcf\x89\xc2\xb2 = (g k + \xcf\x84/\xcf\x81 k\xc2\xb3) tanh(k d)", "%", 4}, 0.1,
              100.0 * worst);
    DestroyTile(tile);
}

static void EveryWaveTravelsAtItsSpeed(void** state)
{
    (void)state;
    CheckSpeeds(0.0625, (double)INFINITY);
    CheckSpeeds(0.5, (double)INFINITY);
    CheckSpeeds(8.0, (double)INFINITY);
    CheckSpeeds(64.0, (double)INFINITY);
    CheckSpeeds(16.0, 2.0);
    CheckSpeeds(64.0, 10.0);
    CheckSpeeds(256.0, 20.0);
}

typedef struct Follower
{
    int index;    // of the wave number
    double phase; // at the start
    double omega; // as known so far

} Follower;

static double GetPhase(swMeasureComplex a)
{
    return atan2(a.im, a.re);
}

// Let each follower take a longer look: what it foretold is off by less than half a turn, and that corrects it.
// Returns the largest surprise, turns.
static double LookAhead(Tile* tile, double begin, double ahead, int count, Follower* followers)
{
    double worst = 0.0;
    MeasureTile(tile, begin + ahead, tile->times[1]);
    for (int i = 0; i < count; ++i)
    {
        Follower* follower = followers + i;
        double passed = follower->phase - GetPhase(tile->times[1][follower->index]); // the phase falls with time
        double surprise = remainder(passed - follower->omega * ahead, TURN);
        follower->omega += surprise / ahead;
        worst = fmax(worst, fabs(surprise) / TURN);
    }
    return worst;
}

static void NoWaveDriftsInThirtyDays(void** state)
{
    (void)state;
    enum
    {
        MOST = 4096
    };
    // So narrow that nothing goes against the strongest waves, and not so narrow that they get parallel tiles.
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 7.6, 0.3, 26.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 82.0, 100.0, 5);
    Tile* tile = CreateTile(&def);
    Follower* followers = calloc(MOST, sizeof(Follower));
    assert_non_null(followers);
    const double begin = 1000.0;
    MeasureTile(tile, begin, tile->times[0]);
    double strongest = FindStrongest(tile->times[0]);
    int count = 0;
    for (int i = 0; i < SIDE * SIDE && count < MOST; ++i)
    {
        bool isForward = i % SIDE > 0 && i % SIDE < SIDE / 2; // of a real field, k and -k say the same
        if (isForward && GetPower(tile->times[0][i]) > 1e-3 * strongest)
        {
            followers[count++] = (Follower){.index = i, .phase = GetPhase(tile->times[0][i]), .omega = TURN / 7.6};
        }
    }
    static const double steps[] = {0.5, 10.0, 200.0, 3600.0};
    for (int i = 0; i < 4; ++i)
    {
        LookAhead(tile, begin, steps[i], count, followers);
    }
    double day = LookAhead(tile, begin, DAY, count, followers);
    double month = LookAhead(tile, begin, 30.0 * DAY, count, followers);
    double worst = 0.0;
    for (int i = 0; i < count; ++i)
    {
        double length = TURN / GetWaveNumber(tile, followers[i].index);
        double asked = TURN * swGetWaveFrequency(length, (double)INFINITY, 9.81);
        worst = fmax(worst, fabs(followers[i].omega / asked - 1.0));
    }
    char what[128];
    snprintf(what, sizeof(what), "Phase of %d waves after 24 h, foretold from the first hour, worst", count);
    FindBelow(&(Finding){"V6", what, "no drift", "turns", 5}, 0.002, day);
    snprintf(what, sizeof(what), "Phase of %d waves after 30 days, foretold from the first, worst", count);
    FindBelow(&(Finding){"V6", what, "no drift", "turns", 5}, 0.002, month);
    snprintf(what, sizeof(what), "Phase speed of %d waves over 30 days, worst", count);
    FindBelow(&(Finding){"V6", what, "\xcf\x89\xc2\xb2 = g k", "10\xe2\x81\xbb\xe2\x81\xb6", 2}, 1.0, 1e6 * worst);
    free(followers);
    DestroyTile(tile);
}

static void ALoopComesBackExactly(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 7.6, 0.3, 8.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 64.0, 128.0, 5);
    def.loopPeriod = 60.0f;
    Tile* tile = CreateTile(&def);
    MeasureTile(tile, 17.25, tile->times[0]);
    MeasureTile(tile, 17.25 + 30.0 * DAY, tile->times[1]);
    double worst = 0.0;
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        worst = fmax(worst, fabs(tile->times[1][i].re - tile->times[0][i].re));
    }
    FindBelow(&(Finding){"V6", "A loop of 60 s after 43,200 times, largest change of any wave", "exact", "m", 6}, 0.0,
              worst);
    DestroyTile(tile);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryWaveTravelsAtItsSpeed),
        cmocka_unit_test(NoWaveDriftsInThirtyDays),
        cmocka_unit_test(ALoopComesBackExactly),
    };
    BeginTruth("truth_dispersion");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
