// SPDX-License-Identifier: MIT
// Splines of any points: what is taken has a length, finds places on itself, and makes a river whose answers are
// numbers; what is refused is told.

#include "fuzz_inputs.h"

#define MOST_POINTS 24

static void TakePoints(Bytes* bytes, swSplinePoint* points, int count)
{
    for (int i = 0; i < count; ++i)
    {
        points[i] =
            swDefaultSplinePoint((double)TakeNumber(bytes), (double)TakeNumber(bytes), (double)TakeNumber(bytes));
        if (TakeByte(bytes) % 4 == 3)
        {
            points[i].width = TakeNumber(bytes);
            points[i].weight = TakeNumber(bytes);
            points[i].flow = TakeNumber(bytes);
            points[i].level = TakeNumber(bytes);
            points[i].depth = TakeNumber(bytes);
        }
    }
}

static void CheckPlaces(const swSpline* spline)
{
    swSplineInfo info = swSpline_GetInfo(spline);
    FUZZ_CHECK(isfinite(info.length) && info.length > 0.0 && info.leastX <= info.mostX && info.leastZ <= info.mostZ);
    for (int i = -1; i <= 5; ++i)
    {
        swSplinePlace place = swSpline_FindPlace(spline, 0.25 * i * info.length);
        float length = hypotf(place.tangent.x, place.tangent.y);
        FUZZ_CHECK(isfinite(place.point.x) && isfinite(place.point.z) && isfinite(place.point.y));
        FUZZ_CHECK(length > 0.999f && length < 1.001f);
        swSplinePlace nearest = swSpline_FindNearest(spline, (swPosXZ){place.point.x, place.point.z});
        // A place on the line is the nearest to itself, to what doubles hold of its coordinates.
        double slack = 1e-3 + 1e-6 * info.length + 1e-9 * (fabs(place.point.x) + fabs(place.point.z));
        FUZZ_CHECK(fabs(nearest.aside) <= slack);
    }
}

static void MakeRiver(Bytes* bytes, const swHost* host, const swSpline* spline)
{
    static Answers answers;
    static const swInputField fields[] = {SW_INPUT_LEVEL, SW_INPUT_FLOW, SW_INPUT_FLOOR, SW_INPUT_FOAM, SW_INPUT_WAVES};
    swWaveSystemId waves;
    swWorld* world = MakeFuzzWorld(host, &waves);
    swPos first = {swSpline_GetDef(spline).points[0].x, 0.0, swSpline_GetDef(spline).points[0].z};
    for (int i = 0; i < 5; ++i)
    {
        swInputDef def = swDefaultInputDef();
        swInputId id;
        def.field = fields[i];
        def.shape = SW_SHAPE_SPLINE;
        def.spline = spline;
        def.feather = fabsf(TakeNumber(bytes));
        def.position = (swPos){-first.x, 0.0, -first.z};
        def.alongSpline = fields[i] == SW_INPUT_WAVES;
        def.system = fields[i] == SW_INPUT_WAVES ? waves : def.system;
        swCreateInput(world, &def, &id); // may be refused, for its feather
    }
    FUZZ_CHECK(swWorld_Step(world, 0.5) == SW_SUCCESS);
    AskFuzzWorld(swWorld_GetMoment(world), &answers);
    CheckFuzzAnswers(&answers);
    swDestroyWorld(world);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    swSplinePoint points[MOST_POINTS];
    Bytes bytes = {data, size, 0};
    int messages = 0;
    swHost host = FuzzHost(&messages);
    swSplineDef def = swDefaultSplineDef();
    def.pointCount = TakeChoice(&bytes, MOST_POINTS + 1);
    def.isClosed = TakeByte(&bytes) % 2 == 1;
    def.offset = (swSplineOffset)TakeChoice(&bytes, SW_SPLINE_OFFSET_COUNT + 1);
    def.width = TakeNumber(&bytes);
    def.startRamp = fabsf(TakeNumber(&bytes));
    def.endRamp = fabsf(TakeNumber(&bytes));
    def.points = points;
    TakePoints(&bytes, points, def.pointCount);
    swSpline* spline = NULL;
    swResult result = swCreateSpline(&host, &def, &spline);
    FUZZ_CHECK((result == SW_SUCCESS) == (spline != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (spline != NULL)
    {
        CheckPlaces(spline);
        MakeRiver(&bytes, &host, spline);
    }
    swDestroySpline(spline);
    return 0;
}
