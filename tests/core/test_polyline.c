// SPDX-License-Identifier: MIT
// Lines through points: trails of foam and colour that a host moves.

#include "support/cmocka_setup.h"
#include "support/messages.h"
#include "support/scatter.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <seaway/seaway.h>

#include "core/input/polyline.h"

#define MOST_POINTS 60

// ---- support ----

typedef struct Line
{
    float words[MOST_POINTS * 9];
    swInputRecord record;
} Line;

static void MakeLine(Line* line, int count, const swInputPoint* points, float width, float feather)
{
    assert_true(swWritePolyline(count, points, width, line->words) <= (int)(sizeof line->words / sizeof(float)));
    line->record = (swInputRecord){.cosine = 1.0f, .weight = 1.0f, .gain = 1.0f, .feather = feather};
    line->record.extra0 = (sw_uint)count;
}

static swInputSample SampleAt(const Line* line, double x, double z)
{
    return swSamplePolyline(line->words, line->record, (float)x, (float)z);
}

// A trail that winds and crosses itself, wider and weaker the older it is.
static void MakeTrail(swInputPoint* points, int count)
{
    for (int i = 0; i < count; ++i)
    {
        double age = (double)i / (count - 1), angle = 9.0 * age;
        points[i] = (swInputPoint){.x = (float)(60.0 * cos(angle) + 30.0 * age),
                                   .z = (float)(60.0 * sin(angle)),
                                   .radius = (float)(2.0 + 6.0 * age),
                                   .weight = (float)(1.0 - 0.9 * age),
                                   .value = {(float)(1.0 + age), (float)age, 0.5f, 1.0f}};
    }
}

// ---- what it says ----

static void BetweenPointsAllRunsEvenly(void** state)
{
    (void)state;
    const swInputPoint points[3] = {{.x = 0.0f, .radius = 4.0f, .weight = 1.0f, .value = {2.0f}},
                                    {.x = 100.0f, .radius = 8.0f, .weight = 0.5f, .value = {4.0f}},
                                    {.x = 100.0f, .z = 100.0f, .weight = 0.5f}};
    Line line;
    MakeLine(&line, 3, points, 6.0f, 0.0f);
    swInputSample s = SampleAt(&line, 50.0, 5.9);
    assert_float_equal(s.share, 0.75f, 1e-6f);
    assert_float_equal(s.value.x, 3.0f, 1e-6f);
    assert_float_equal(s.valueX.x, 0.02f, 1e-6f);
    assert_float_equal(s.shareX, -0.005f, 1e-6f);
    assert_true(SampleAt(&line, 50.0, 6.1).share == 0.0f);
    assert_true(SampleAt(&line, -3.9, 0.0).share == 1.0f && SampleAt(&line, -4.1, 0.0).share == 0.0f);
    // A point without a radius has half of the input's width.
    assert_true(SampleAt(&line, 102.9, 100.0).share == 0.5f && SampleAt(&line, 103.1, 100.0).share == 0.0f);
}

static void ManyPiecesSayTheSameAsEachByItself(void** state)
{
    (void)state;
    static swInputPoint points[MOST_POINTS];
    MakeTrail(points, MOST_POINTS);
    Line line, piece;
    MakeLine(&line, MOST_POINTS, points, 1.0f, 1.5f);
    uint32_t seed = 4;
    int covered = 0;
    for (int i = 0; i < 4000; ++i)
    {
        double x = 200.0 * NextPart(&seed) - 80.0, z = 160.0 * NextPart(&seed) - 80.0;
        float most = 0.0f;
        for (int k = 0; k + 1 < MOST_POINTS; ++k)
        {
            MakeLine(&piece, 2, points + k, 1.0f, 1.5f);
            most = fmaxf(most, SampleAt(&piece, x, z).share);
        }
        float share = SampleAt(&line, x, z).share;
        assert_true(share == most);
        covered += share > 0.0f ? 1 : 0;
    }
    assert_true(covered > 500);
}

static void HowMuchItCountsHasNoSeam(void** state)
{
    (void)state;
    static swInputPoint points[MOST_POINTS];
    MakeTrail(points, MOST_POINTS);
    Line line;
    MakeLine(&line, MOST_POINTS, points, 1.0f, 1.5f);
    const double h = 0.01;
    double worst = 0.0, worstSlope = 0.0;
    uint32_t seed = 8;
    for (int i = 0; i < 20000; ++i)
    {
        double x = 200.0 * NextPart(&seed) - 80.0, z = 160.0 * NextPart(&seed) - 80.0;
        swInputSample s = SampleAt(&line, x, z), e = SampleAt(&line, x + h, z), w = SampleAt(&line, x - h, z);
        worst = fmax(worst, fabs((double)(e.share - w.share)));
        // Derivatives are exact but where one piece takes over from another.
        double slope = (double)(e.share - w.share) / (2.0 * h), before = (double)(s.share - w.share) / h;
        if (s.share > 0.0f && fabs(slope - before) < 0.02)
        {
            worstSlope = fmax(worstSlope, fabs(slope - (double)s.shareX));
        }
    }
    print_message("shares differ by %.3g within 2 cm, derivatives by %.2g from differences\n", worst, worstSlope);
    assert_true(worst < 0.025 && worstSlope < 0.02);
}

// ---- by the public API ----

static void AHostMovesATrail(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swInputPoint points[2] = {{.x = 0.0f, .weight = 1.0f}, {.x = 10.0f, .weight = 1.0f}};
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_FOAM;
    def.shape = SW_SHAPE_POLYLINE;
    def.blend = SW_BLEND_ADD;
    def.size.x = 4.0f;
    def.value[0] = 0.5f;
    def.position = (swPos){1e6, 0.0, 0.0};
    def.points = points;
    def.pointCount = 2;
    def.pointCapacity = 16;
    swInputId id;
    assert_int_equal(swCreateInput(world, &def, &id), SW_SUCCESS);
    for (int step = 0; step < 10; ++step)
    {
        swWorld_Step(world, 0.1 * step);
        float foam[2];
        const swPosXZ at[2] = {{1e6 + 5.0 + 20.0 * step, 1.9}, {1e6 + 5.0 + 20.0 * (step - 1), 1.9}};
        const swFieldSamples samples = {.foam = foam};
        assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 2, at, &samples), 0);
        assert_float_equal(foam[0], 0.5f, 1e-6f);
        assert_true(foam[1] == 0.0f);
        for (int i = 0; i < 2; ++i)
        {
            points[i].x += 20.0f;
        }
        assert_int_equal(swInput_SetPoints(world, id, 2, points), SW_SUCCESS);
    }
    swDestroyWorld(world);
}

static void BadLinesAreRefusedWithASentence(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swInputPoint points[3] = {{.x = 0.0f}, {.x = 1.0f}, {.x = 2.0f}};
    swInputDef def = swDefaultInputDef();
    strcpy(def.name, "trail");
    def.field = SW_INPUT_FOAM;
    def.shape = SW_SHAPE_POLYLINE;
    def.points = points;
    def.pointCount = 1;
    swInputId id;
    assert_int_equal(swCreateInput(world, &def, &id), SW_ERROR_INVALID);
    assert_non_null(
        strstr(s_messages, "the input 'trail' (polyline of the foam) is a line through fewer than two points"));
    s_messages[0] = '\0';
    def.pointCount = 3;
    points[1].z = NAN;
    assert_int_equal(swCreateInput(world, &def, &id), SW_ERROR_INVALID);
    assert_non_null(strstr(s_messages, "point 1 of the input 'trail' is out of range"));
    points[1].z = 0.0f;
    points[2].value[3] = INFINITY;
    assert_int_equal(swCreateInput(world, &def, &id), SW_ERROR_INVALID);
    // One place twice is a ship at rest.
    points[2] = points[1];
    assert_int_equal(swCreateInput(world, &def, &id), SW_SUCCESS);
    assert_int_equal(swInput_SetPoints(world, id, 1, points), SW_ERROR_INVALID);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(BetweenPointsAllRunsEvenly),      cmocka_unit_test(ManyPiecesSayTheSameAsEachByItself),
        cmocka_unit_test(HowMuchItCountsHasNoSeam),        cmocka_unit_test(AHostMovesATrail),
        cmocka_unit_test(BadLinesAreRefusedWithASentence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
