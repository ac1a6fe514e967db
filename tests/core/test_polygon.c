// SPDX-License-Identifier: MIT
#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <math.h>

#include "core/input/polygon.h"
#include "seaway/math.h"

static void Refuses(int count, const swVec2* points, const char* sentence)
{
    swHost host = MakeHost();
    assert_int_equal(swCheckPolygon(&host, "lake", count, &points->x, 2), SW_ERROR_INVALID);
    printf("%s", s_messages);
    assert_non_null(strstr(s_messages, sentence));
}

static void Accepts(int count, const swVec2* points)
{
    swHost host = MakeHost();
    assert_int_equal(swCheckPolygon(&host, "lake", count, &points->x, 2), SW_SUCCESS);
}

static void ConcavePolygonsAreTakenEitherWayRound(void** state)
{
    (void)state;
    const swVec2 arrow[] = {{0.0f, 0.0f}, {10.0f, 0.0f}, {10.0f, 10.0f}, {5.0f, 3.0f}};
    const swVec2 back[] = {{5.0f, 3.0f}, {10.0f, 10.0f}, {10.0f, 0.0f}, {0.0f, 0.0f}};
    Accepts(4, arrow);
    Accepts(4, back);
    const swVec2 straight[] = {{0.0f, 0.0f}, {5.0f, 0.0f}, {10.0f, 0.0f}, {10.0f, 10.0f}}; // a point on an edge
    Accepts(4, straight);
    static swVec2 circle[SW_MAX_POLYGON_POINTS];
    for (int i = 0; i < SW_MAX_POLYGON_POINTS; ++i)
    {
        float angle = 6.2831853f * (float)i / (float)SW_MAX_POLYGON_POINTS;
        circle[i] = (swVec2){1000.0f * cosf(angle), 1000.0f * sinf(angle)};
    }
    Accepts(SW_MAX_POLYGON_POINTS, circle);
}

static void APolygonThatCrossesItselfIsRefused(void** state)
{
    (void)state;
    const swVec2 bow[] = {{0.0f, 0.0f}, {10.0f, 10.0f}, {10.0f, 0.0f}, {0.0f, 10.0f}};
    Refuses(4, bow, "lake crosses itself: its edge from point 0, (0, 0), meets the one from point 2, (10, 0)");
    const swVec2 touching[] = {{0.0f, 0.0f}, {10.0f, 0.0f}, {10.0f, 10.0f}, {5.0f, 0.0f}, {0.0f, 10.0f}};
    Refuses(5, touching, "lake crosses itself");
    const swVec2 spike[] = {{0.0f, 0.0f}, {10.0f, 0.0f}, {20.0f, 0.0f}, {10.0f, 0.0f}, {5.0f, 5.0f}};
    Refuses(5, spike, "lake");
    const swVec2 flat[] = {{0.0f, 0.0f}, {10.0f, 0.0f}, {20.0f, 0.0f}};
    Refuses(3, flat, "lake turns back on itself");
}

static void BadPointsAreNamed(void** state)
{
    (void)state;
    const swVec2 nan[] = {{0.0f, 0.0f}, {10.0f, (float)NAN}, {20.0f, 0.0f}};
    Refuses(3, nan, "lake has point 1, counted from 0, at (10, nan)");
    const swVec2 same[] = {{0.0f, 0.0f}, {10.0f, 10.0f}, {10.0f, 10.0f}, {20.0f, 0.0f}};
    Refuses(4, same, "lake has points 1 and 2 at the same place");
    const swVec2 closed[] = {{0.0f, 0.0f}, {10.0f, 10.0f}, {20.0f, 0.0f}, {0.0f, 0.0f}};
    Refuses(4, closed, "lake has points 3 and 0 at the same place");
    Refuses(2, closed, "lake has 2 points; a polygon has 3 to 4096");
    const swVec2 far[] = {{0.0f, 0.0f}, {1e9f, 10.0f}, {20.0f, 0.0f}};
    Refuses(3, far, "within 1000 km");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ConcavePolygonsAreTakenEitherWayRound),
        cmocka_unit_test(APolygonThatCrossesItselfIsRefused),
        cmocka_unit_test(BadPointsAreNamed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
