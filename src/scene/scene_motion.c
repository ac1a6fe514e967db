// SPDX-License-Identifier: MIT
// Inputs of a scene that move: by a velocity, around a circle, along a path. Where they are is a function of time, made
// of sums, products and swGetTide(), so that it has the same bits on every machine.

#include <math.h>

#include "core/base/field.h"
#include "core/base/misuse.h"
#include "scene/scene_inputs.h"
#include "scene/scene_lists.h"
#include "seaway/math.h"

#define FULL_TURN (2.0 * SW_PI)
#define FARTHEST 1e9 // m

// ---- keys ----

#define SW_DEF swSceneMotion
static const swField motionFields[] = {
    SW_NUMBER(startTime, "s", SW_WITHIN(-SW_LARGEST_TIME, SW_LARGEST_TIME), 0.0, .key = "start_s", .label = "starts",
              .tip = "It stands before"),
    SW_NUMBERS(velocity, float, "m/s", SW_WITHIN(-1000.0, 1000.0), SW_EACH(0.0, 0.0, 0.0), .key = "velocity_mps",
               .label = "velocity", .tip = "Along the world's axes"),
    SW_NUMBERS(turnRate, float, "deg/s", SW_WITHIN(-FULL_TURN, FULL_TURN), SW_EACH(0.0, 0.0, 0.0),
               .key = "turn_rate_deg_per_s", .label = "turns by", .tip = "Yaw, pitch and roll",
               .form = SW_FORM_DEGREES),
    SW_NUMBER(orbitRadius, "m", SW_WITHIN(0.0, 1e6), 0.0, .key = "orbit_radius_m", .label = "radius of its orbit",
              .tip = "A circle around its place", .zero = "none"),
    SW_NUMBER(orbitPeriod, "s", SW_WITHIN(-1e9, 1e9), 0.0, .key = "orbit_period_s", .label = "period of its orbit",
              .tip = "From +x towards +z; below 0 the other way round"),
    SW_NUMBER(orbitPhase, "deg", SW_WITHIN(-FULL_TURN, FULL_TURN), 0.0, .key = "orbit_from_deg", .label = "sets out at",
              .tip = "Where on its orbit, from +x towards +z", .form = SW_FORM_DEGREES),
    SW_SWITCH(isSmooth, false, .key = "is_smooth", .label = "smooth",
              .tip = "It comes to rest at each point of its path"),
    SW_SWITCH(loops, false, .key = "loops", .label = "loops", .tip = "The path begins anew behind its last point"),
};
#undef SW_DEF

static const swFields motion = SW_PART_FIELDS(swSceneMotion, "motion", "motion", motionFields);

const swFields* swGetSceneMotionFields(void)
{
    return &motion;
}

#define SW_DEF swScenePathPoint
static const swField pathFields[] = {
    SW_NUMBER(time, "s", SW_WITHIN(0.0, SW_LARGEST_TIME), 0.0, .key = "time_s", .label = "time",
              .tip = "From start_s on"),
    SW_NUMBERS(moved, float, "m", SW_WITHIN(-1e6, 1e6), SW_EACH(0.0, 0.0, 0.0), .key = "moved_m", .label = "moved",
               .tip = "From its place"),
    SW_NUMBERS(turned, float, "deg", SW_WITHIN(-FULL_TURN, FULL_TURN), SW_EACH(0.0, 0.0, 0.0), .key = "turned_deg",
               .label = "turned", .tip = "Yaw, pitch and roll, beside its own turn", .form = SW_FORM_DEGREES),
};
#undef SW_DEF

static const swFields path = SW_PART_FIELDS(swScenePathPoint, "path", "point of a path", pathFields);

const swFields* swGetScenePathFields(void)
{
    return &path;
}

// ---- reading ----

static swResult readPoint(swYaml* yaml, yaml_node_t* node, swScenePathPoint* points, int index)
{
    swYamlMapping mapping;
    swFillDef(&path, &points[index]);
    swBeginYamlMapping(&mapping, "a point of a path");
    swAddYamlFields(&mapping, &path, 0, "path");
    swResult result = swReadYamlMapping(yaml, node, &mapping, &points[index]);
    bool isLate = index == 0 || points[index].time > points[index - 1].time;
    return result == SW_SUCCESS && !isLate
               ? swFailYaml(yaml, node, SW_MISTAKE_OUT_OF_RANGE,
                            "the path is at its point %d at %g s, not after the one before; times ascend.", index + 1,
                            points[index].time)
               : result;
}

static swResult readPath(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    swSceneMotion* made = target;
    swResult result = swAllocateYamlItems(yaml, node, key->key, SW_MAX_SCENE_PATH, sizeof(swScenePathPoint),
                                          (void**)&made->path, &made->pathCount);
    if (made->pathCount == 0)
    {
        return swKeepFailure(
            result, swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "the path has no points; give it a list of them."));
    }
    for (int i = 0; i < made->pathCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readPoint(yaml, swGetYamlItem(yaml, node, i), made->path, i));
    }
    return result;
}

// Keys that say nothing without another.
static swResult checkKeys(swYaml* yaml, yaml_node_t* node, const swYamlMapping* mapping)
{
    static const struct
    {
        const char *key, *without;
    } pairs[] = {{"orbit_period_s", "orbit_radius_m"},
                 {"orbit_from_deg", "orbit_radius_m"},
                 {"is_smooth", "path"},
                 {"loops", "path"}};
    const swYamlKey* radius = swFindYamlKey((swYamlMapping*)mapping, "orbit_radius_m");
    swResult result = SW_SUCCESS;
    for (size_t i = 0; i < sizeof(pairs) / sizeof(pairs[0]); ++i)
    {
        const yaml_node_t* key = swGetYamlNode(mapping, pairs[i].key);
        if (key != NULL && swGetYamlNode(mapping, pairs[i].without) == NULL)
        {
            result = swFailYaml(yaml, key, SW_MISTAKE_NO_EFFECT, "%s has no effect without %s; remove it.",
                                pairs[i].key, pairs[i].without);
        }
    }
    return radius->node != NULL && swGetYamlNode(mapping, "orbit_period_s") == NULL
               ? swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "the orbit has no period; give it orbit_period_s.")
               : result;
}

swResult swReadMotion(swYaml* yaml, yaml_node_t* node, swSceneMotion* made)
{
    swYamlMapping mapping;
    swFillDef(&motion, made);
    swBeginYamlMapping(&mapping, "a motion");
    swAddYamlFields(&mapping, &motion, 0, "motion");
    swAddYamlKey(&mapping, "path", readPath);
    swResult result = swReadYamlMapping(yaml, node, &mapping, made);
    const yaml_node_t* period = swGetYamlNode(&mapping, "orbit_period_s");
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    if (period != NULL && !swIsYamlWrong(&mapping, "orbit_period_s") && !(fabsf(made->orbitPeriod) >= 1e-3f))
    {
        result = swKeepFailure(result, swFailYaml(yaml, period, SW_MISTAKE_OUT_OF_RANGE,
                                                  "orbit_period_s is %g; it is at least a thousandth of a second.",
                                                  (double)made->orbitPeriod));
    }
    return swKeepFailure(result, checkKeys(yaml, node, &mapping));
}

void swFreeMotion(const swHost* host, swSceneMotion* made)
{
    swFree(host, made->path, (size_t)made->pathCount * sizeof(swScenePathPoint));
    made->path = NULL;
    made->pathCount = 0;
}

// ---- at a time ----

// Angles that have grown for long would leave the range of inputs.
static double wrap(double angle)
{
    return angle - FULL_TURN * floor(angle / FULL_TURN + 0.5);
}

static void addOrbit(const swSceneMotion* made, double since, swPos* position)
{
    if (made->orbitRadius == 0.0f)
    {
        return;
    }
    double turns = since / (double)made->orbitPeriod;
    const swTideConstituent circle = {.speed = 1.0f,
                                      .amplitude = 1.0f,
                                      .phase = -made->orbitPhase,
                                      .amplitudeAcross = 1.0f,
                                      .phaseAcross = (float)(0.25 * FULL_TURN) - made->orbitPhase};
    float x = 0.0f, z = 0.0f;
    swGetTide(1, &circle, FULL_TURN * (turns - floor(turns)), &x, &z);
    position->x += (double)made->orbitRadius * (double)x;
    position->z += (double)made->orbitRadius * (double)z;
}

static float mix(float a, float b, double share)
{
    return (float)((1.0 - share) * (double)a + share * (double)b);
}

static swScenePathPoint findOnPath(const swSceneMotion* made, double since)
{
    const swScenePathPoint *points = made->path, *last = &points[made->pathCount - 1];
    double length = last->time - points->time, at = since - points->time;
    at = made->loops && length > 0.0 && at > 0.0 ? at - length * floor(at / length) : at;
    double time = points->time + at;
    int next = 0;
    while (next < made->pathCount && points[next].time <= time)
    {
        ++next;
    }
    if (next == 0 || next == made->pathCount)
    {
        return next == 0 ? *points : *last;
    }
    const swScenePathPoint *a = &points[next - 1], *b = &points[next];
    double share = (time - a->time) / (b->time - a->time);
    share = made->isSmooth ? share * share * (3.0 - 2.0 * share) : share;
    return (swScenePathPoint){.time = time,
                              .moved = {mix(a->moved.x, b->moved.x, share), mix(a->moved.y, b->moved.y, share),
                                        mix(a->moved.z, b->moved.z, share)},
                              .turned = {mix(a->turned.yaw, b->turned.yaw, share),
                                         mix(a->turned.pitch, b->turned.pitch, share),
                                         mix(a->turned.roll, b->turned.roll, share)}};
}

bool swSceneInput_GetPlace(const swSceneInput* input, double time, swPos* position, swAngles* rotation)
{
    SW_REQUIRE(input != NULL && position != NULL && rotation != NULL, false, NULL,
               "swSceneInput_GetPlace() needs an input and places for where it is");
    const swSceneMotion* made = &input->motion;
    double since = time > made->startTime ? time - made->startTime : 0.0;
    swScenePathPoint point = made->pathCount > 0 ? findOnPath(made, since) : (swScenePathPoint){0};
    *position = input->def.position;
    position->x += (double)made->velocity.x * since + (double)point.moved.x;
    position->y += (double)made->velocity.y * since + (double)point.moved.y;
    position->z += (double)made->velocity.z * since + (double)point.moved.z;
    addOrbit(made, since, position);
    *rotation = input->def.rotation;
    rotation->yaw += (float)wrap((double)made->turnRate.yaw * since) + point.turned.yaw;
    rotation->pitch += (float)wrap((double)made->turnRate.pitch * since) + point.turned.pitch;
    rotation->roll += (float)wrap((double)made->turnRate.roll * since) + point.turned.roll;
    return fabs(position->x) <= FARTHEST && fabs(position->y) <= FARTHEST && fabs(position->z) <= FARTHEST;
}

bool swSceneInput_IsMoving(const swSceneInput* input)
{
    SW_REQUIRE(input != NULL, false, NULL, "swSceneInput_IsMoving() needs an input");
    const swVec3* velocity = &input->motion.velocity;
    const swAngles* rate = &input->motion.turnRate;
    return input->motion.pathCount > 0 || input->motion.orbitRadius > 0.0f || velocity->x != 0.0f ||
           velocity->y != 0.0f || velocity->z != 0.0f || rate->yaw != 0.0f || rate->pitch != 0.0f || rate->roll != 0.0f;
}

static float getLength(swVec3 v)
{
    return sqrtf(v.x * v.x + v.y * v.y + v.z * v.z);
}

float swSceneMotion_GetSpeed(const swSceneMotion* made)
{
    SW_REQUIRE(made != NULL, 0.0f, NULL, "swSceneMotion_GetSpeed() needs a motion");
    float most = 0.0f;
    for (int i = 1; i < made->pathCount; ++i)
    {
        const swScenePathPoint *a = &made->path[i - 1], *b = &made->path[i];
        const swVec3 way = {b->moved.x - a->moved.x, b->moved.y - a->moved.y, b->moved.z - a->moved.z};
        float mean = getLength(way) / (float)(b->time - a->time);
        most = fmaxf(most, made->isSmooth ? 1.5f * mean : mean);
    }
    float orbit = made->orbitRadius > 0.0f ? (float)FULL_TURN * made->orbitRadius / fabsf(made->orbitPeriod) : 0.0f;
    return getLength(made->velocity) + orbit + most;
}
