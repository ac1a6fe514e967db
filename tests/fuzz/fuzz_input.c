// SPDX-License-Identifier: MIT
// Inputs and bodies of water of any numbers: made, changed, moved and destroyed. What is refused is told and leaves the
// sea as it was; what is taken answers numbers everywhere, is saved, and comes back with the same bits.

#include "fuzz_inputs.h"

#define MOST_INPUTS 6
#define MOST_POINTS 12

typedef struct Sea
{
    swWorld* world;
    swWaveSystemId waves;
    Resources* resources;
    int* messages;
    swInputId inputs[MOST_INPUTS];
    int count;
    swWaterBodyId body;
} Sea;

static int TakePoints(Bytes* bytes, swInputPoint* points)
{
    int count = TakeChoice(bytes, MOST_POINTS + 1);
    for (int i = 0; i < count; ++i)
    {
        points[i] = (swInputPoint){.x = TakeNumber(bytes),
                                   .z = TakeNumber(bytes),
                                   .radius = TakeNumber(bytes),
                                   .weight = i % 2 == 0 ? 1.0f : TakeNumber(bytes),
                                   .value = {0.1f * TakeNumber(bytes)}};
    }
    return count;
}

static void TakeResource(Bytes* bytes, const Sea* sea, swInputDef* def)
{
    def->spline = def->shape == SW_SHAPE_SPLINE ? sea->resources->spline : NULL;
    def->mesh = def->shape == SW_SHAPE_MESH ? sea->resources->mesh : NULL;
    def->hull = def->shape == SW_SHAPE_HULL ? sea->resources->hull : NULL;
    if (def->shape == SW_SHAPE_RASTER)
    {
        def->raster = TakeChoice(bytes, 2) == 0 ? sea->resources->heights : sea->resources->pairs;
    }
}

static swInputDef TakeDef(Bytes* bytes, const Sea* sea, swInputPoint* points)
{
    swInputDef def = swDefaultInputDef();
    memcpy(def.name, "fuzz", 5);
    def.field = (swInputField)TakeChoice(bytes, SW_INPUT_FIELD_COUNT);
    def.shape = (swInputShape)TakeChoice(bytes, SW_SHAPE_COUNT + 1);
    def.blend = (swInputBlend)TakeChoice(bytes, SW_BLEND_COUNT + 1);
    int switches = TakeByte(bytes);
    def.followsWaves = (switches & 1) != 0;
    def.isBump = (switches & 2) != 0;
    def.removesWaves = (switches & 4) != 0;
    def.alongSpline = (switches & 8) != 0;
    def.windWeight.isUsed = (switches & 16) != 0;
    def.system = (switches & 32) != 0 ? sea->waves : def.system;
    def.loops = (switches & 64) == 0;
    def.order = TakeChoice(bytes, 5) - 2;
    def.weight = (switches & 128) != 0 ? TakeNumber(bytes) : 1.0f;
    def.feather = fabsf(TakeNumber(bytes));
    def.value[0] = TakeNumber(bytes);
    def.value[1] = TakeNumber(bytes);
    def.position = (swPos){(double)TakeNumber(bytes), (double)TakeNumber(bytes), (double)TakeNumber(bytes)};
    def.rotation.yaw = 0.1f * TakeNumber(bytes);
    def.size = (swVec3){fabsf(TakeNumber(bytes)), fabsf(TakeNumber(bytes)), fabsf(TakeNumber(bytes))};
    TakeResource(bytes, sea, &def);
    if ((switches & 128) != 0)
    {
        def.gain = TakeNumber(bytes);
        def.rotation.pitch = 0.1f * TakeNumber(bytes);
        def.rotation.roll = 0.1f * TakeNumber(bytes);
        def.value[2] = TakeNumber(bytes);
        def.value[3] = TakeNumber(bytes);
        def.rounding = TakeNumber(bytes);
        def.wavelength = TakeNumber(bytes);
        def.framesPerSecond = TakeNumber(bytes);
        def.startTime = (double)TakeNumber(bytes);
        def.heading = TakeNumber(bytes);
        def.scale.x = TakeNumber(bytes);
        def.windWeight.speed = TakeNumber(bytes);
        def.tide[0].amplitude = TakeNumber(bytes);
        def.tide[0].speed = TakeNumber(bytes);
    }
    bool hasPoints = def.shape == SW_SHAPE_POLYGON || def.shape == SW_SHAPE_POLYLINE || def.shape == SW_SHAPE_PARTICLES;
    def.raster = def.shape == SW_SHAPE_RASTER ? def.raster : (switches & 64) != 0 ? sea->resources->pairs : NULL;
    def.pointCount = hasPoints ? TakePoints(bytes, points) : TakeByte(bytes); // not looked at
    def.points = hasPoints ? points : NULL;
    return def;
}

static void CheckTold(const Sea* sea, swResult result, int before)
{
    FUZZ_CHECK(result == SW_SUCCESS || *sea->messages > before);
}

static void MakeInput(Bytes* bytes, Sea* sea)
{
    swInputPoint points[MOST_POINTS];
    swInputDef def = TakeDef(bytes, sea, points);
    int before = *sea->messages;
    uint64_t count = (uint64_t)swWorld_GetInputCount(sea->world);
    swInputId id = {0};
    swResult result = swCreateInput(sea->world, &def, &id);
    CheckTold(sea, result, before);
    FUZZ_CHECK((uint64_t)swWorld_GetInputCount(sea->world) == count + (result == SW_SUCCESS ? 1 : 0));
    FUZZ_CHECK(swInput_IsValid(sea->world, id) == (result == SW_SUCCESS));
    if (result == SW_SUCCESS)
    {
        sea->inputs[sea->count++] = id;
    }
}

static void ChangeInput(Bytes* bytes, Sea* sea)
{
    swInputPoint points[MOST_POINTS];
    int before = *sea->messages, index = TakeChoice(bytes, sea->count);
    swInputId id = sea->inputs[index];
    swInputDef def;
    switch (TakeChoice(bytes, 5))
    {
    case 0:
        def = TakeDef(bytes, sea, points);
        CheckTold(sea, swInput_Set(sea->world, id, &def), before);
        break;
    case 1:
        swInput_Move(sea->world, id, (swPos){(double)TakeByte(bytes), 0.0, -3.0}, (swAngles){0.5f, 0.1f, 0.0f});
        break;
    case 2:
        swInput_Enable(sea->world, id, TakeByte(bytes) % 2 == 0);
        break;
    case 3:
        def = swInput_Get(sea->world, id);
        if (def.pointCount > 0)
        {
            int count = TakePoints(bytes, points);
            CheckTold(sea, swInput_SetPoints(sea->world, id, count, points), before);
        }
        break;
    default:
        swDestroyInput(sea->world, id);
        sea->inputs[index] = sea->inputs[--sea->count];
        break;
    }
}

static void MakeBody(Bytes* bytes, Sea* sea)
{
    swVec2 shore[MOST_POINTS];
    swWaterBodyDef def = swDefaultWaterBodyDef();
    def.pointCount = TakeChoice(bytes, MOST_POINTS + 1);
    for (int i = 0; i < def.pointCount; ++i)
    {
        shore[i] = (swVec2){TakeNumber(bytes), TakeNumber(bytes)};
    }
    int switches = TakeByte(bytes);
    def.points = shore;
    def.position = (swPos){(double)TakeNumber(bytes), (double)TakeNumber(bytes), (double)TakeNumber(bytes)};
    def.isCalm = (switches & 1) != 0;
    def.setsLevel = (switches & 2) == 0;
    def.leavesWater = (switches & 4) == 0;
    def.waves = (switches & 8) != 0 ? sea->waves : def.waves;
    def.wavesFeather = fabsf(TakeNumber(bytes));
    int before = *sea->messages;
    swResult result = swWaterBody_IsValid(sea->world, sea->body) ? swWaterBody_Set(sea->world, sea->body, &def)
                                                                 : swCreateWaterBody(sea->world, &def, &sea->body);
    CheckTold(sea, result, before);
}

static void CheckSaved(const Sea* sea, const Answers* expected)
{
    static Answers found;
    size_t size = 0;
    swWorld_Save(sea->world, NULL, &size);
    void* data = malloc(size);
    FUZZ_CHECK(data != NULL && swWorld_Save(sea->world, data, &size) == SW_SUCCESS);
    swRestoreDef def = swDefaultRestoreDef();
    def.findResource = FindFuzzResource;
    def.resourceContext = sea->resources;
    swHost host = swDefaultHost();
    swWorld* restored = NULL;
    FUZZ_CHECK(swRestoreWorld(&host, data, size, &def, &restored) == SW_SUCCESS);
    AskFuzzWorld(swWorld_GetMoment(restored), &found);
    FUZZ_CHECK(memcmp(&found, expected, sizeof found) == 0);
    FUZZ_CHECK(swWorld_GetDigest(restored) == swWorld_GetDigest(sea->world));
    swDestroyWorld(restored);
    free(data);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static Answers answers;
    static Resources resources;
    Bytes bytes = {data, size, 0};
    int messages = 0;
    swHost host = FuzzHost(&messages);
    if (resources.mesh == NULL)
    {
        swHost quiet = swDefaultHost(); // they outlive this call
        resources = MakeResources(&quiet);
    }
    Sea sea = {.resources = &resources, .messages = &messages};
    sea.world = MakeFuzzWorld(&host, &sea.waves);
    while (bytes.at < size)
    {
        int action = TakeChoice(&bytes, 8);
        if (action == 0)
        {
            MakeBody(&bytes, &sea);
        }
        else if (action < 3 && sea.count > 0)
        {
            ChangeInput(&bytes, &sea);
        }
        else if (action == 3)
        {
            FUZZ_CHECK(swWorld_Step(sea.world, 0.5) == SW_SUCCESS);
        }
        else if (sea.count < MOST_INPUTS)
        {
            MakeInput(&bytes, &sea);
        }
    }
    FUZZ_CHECK(swWorld_Step(sea.world, 0.5) == SW_SUCCESS);
    AskFuzzWorld(swWorld_GetMoment(sea.world), &answers);
    CheckFuzzAnswers(&answers);
    CheckSaved(&sea, &answers);
    swDestroyWorld(sea.world);
    return 0;
}
