// SPDX-License-Identifier: MIT
// What a host puts into the sea while it runs: markers of a volley, a boat that no water gets into, a lock that fills.
// Links the core alone.
#include <seaway/seaway.h>

#include <math.h>
#include <stdio.h>

// [volley]
// Made once, with room for as many points as a volley has.
static swResult CreateVolley(swWorld* world, swInputId* id)
{
    const swInputPoint first = {.radius = 6.0f, .weight = 0.0f};
    swInputDef dye = swDefaultInputDef();
    dye.field = SW_INPUT_ALBEDO;
    dye.shape = SW_SHAPE_PARTICLES;
    dye.value[0] = 0.8f; // red, green, blue, cover
    dye.value[3] = 0.9f;
    dye.feather = 2.0f;
    dye.followsWaves = true;
    dye.points = &first;
    dye.pointCount = 1;
    dye.pointCapacity = 200;
    return swCreateInput(world, &dye, id);
}

// Before a step: where shells fell, fading over a minute.
static swResult MarkVolley(swWorld* world, swInputId id, int count, const swPosXZ* places, double age)
{
    swInputPoint points[200];
    for (int i = 0; i < count; ++i)
    {
        points[i] =
            (swInputPoint){(float)places[i].x, (float)places[i].z, 6.0f, (float)fmax(1.0 - age / 60.0, 0.0), {0}};
    }
    return swInput_SetPoints(world, id, count, points);
}
// [/volley]

// [boat]
// Made once: a box of 14 x 5 x 4 m with round edges that takes the water away.
static swResult CreateHole(swWorld* world, swInputId* id)
{
    swInputDef hole = swDefaultInputDef();
    hole.field = SW_INPUT_CLIP;
    hole.shape = SW_SHAPE_BOX;
    hole.value[0] = 1.0f;
    hole.size = (swVec3){14.0f, 5.0f, 4.0f};
    hole.rounding = 1.5f;
    return swCreateInput(world, &hole, id);
}

// Before each step, as the boat moves and rolls.
static void MoveHole(swWorld* world, swInputId id, swPos place, float yaw, float pitch, float roll)
{
    swInput_Move(world, id, place, (swAngles){.yaw = yaw, .pitch = pitch, .roll = roll});
}
// [/boat]

// [lock]
// Made once: the chamber of a lock, whose water begins at sea level.
static swResult CreateLock(swWorld* world, swWaterBodyId* id)
{
    static const swVec2 walls[] = {{-40.0f, -7.0f}, {40.0f, -7.0f}, {40.0f, 7.0f}, {-40.0f, 7.0f}};
    swWaterBodyDef lock = swDefaultWaterBodyDef();
    lock.position = (swPos){200.0, 0.0, 0.0};
    lock.points = walls;
    lock.pointCount = 4;
    lock.isCalm = true;
    return swCreateWaterBody(world, &lock, id);
}

// Before each step: three metres in five minutes.
static void FillLock(swWorld* world, swWaterBodyId id, double seconds)
{
    swWaterBody_SetLevel(world, id, fmin(3.0 * seconds / 300.0, 3.0));
}
// [/lock]

static bool IsNear(const char* what, double found, double wanted, double tolerance)
{
    printf("%-28s %.3f\n", what, found);
    return fabs(found - wanted) <= tolerance;
}

int main(void)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    if (swCreateWorld(&host, &worldDef, &world) != SW_SUCCESS)
    {
        return 1; // the host's log has said why
    }
    swInputId volley, hole;
    swWaterBodyId lock;
    const swPosXZ shells[3] = {{10.0, 0.0}, {60.0, 20.0}, {120.0, -15.0}};
    if (CreateVolley(world, &volley) != SW_SUCCESS || CreateHole(world, &hole) != SW_SUCCESS ||
        CreateLock(world, &lock) != SW_SUCCESS)
    {
        return 1;
    }

    bool isFine = MarkVolley(world, volley, 3, shells, 30.0) == SW_SUCCESS;
    MoveHole(world, hole, (swPos){-50.0, 0.3, 8.0}, 0.4f, 0.02f, -0.05f);
    FillLock(world, lock, 150.0);
    isFine = isFine && swWorld_Step(world, 1.0 / 60.0) == SW_SUCCESS;

    const swPosXZ places[3] = {shells[1], {-50.0, 8.0}, {200.0, 0.0}};
    swVec4 albedo[3];
    float clip[3], level[3];
    const swFieldSamples samples = {.albedo = albedo, .clip = clip, .level = level};
    swMoment_QueryFields(swWorld_GetMoment(world), 3, places, &samples);
    isFine = isFine && IsNear("cover of a marker", (double)albedo[0].w, 0.45, 1e-4) &&
             IsNear("hole under the boat", (double)clip[1], 1.0, 1e-6) &&
             IsNear("level in the lock, m", (double)level[2], 1.5, 1e-4);
    swDestroyWorld(world);
    return isFine ? 0 : 1;
}
