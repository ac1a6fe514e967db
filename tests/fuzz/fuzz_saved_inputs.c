// SPDX-License-Identifier: MIT
// Saved worlds and moments with inputs, whose words are changed: three bytes of a place and four of a word each. Bytes
// of a saved world are made here, so that they never grow old; the hash at their end would keep a fuzzer out, so it is
// made right. What is let in answers, and is not read beyond its end.

#include "fuzz_hash.h"
#include "fuzz_inputs.h"

#define MOST_CHANGES 8

static void AddShape(swWorld* world, const Resources* resources, swWaveSystemId waves, int shape)
{
    static const swInputPoint points[4] = {{-50.0f, -40.0f, 6.0f, 1.0f, {0.2f, 0.0f, 0.0f, 0.0f}},
                                           {40.0f, -50.0f, 8.0f, 0.7f, {0.1f, 0.0f, 0.0f, 0.0f}},
                                           {60.0f, 30.0f, 5.0f, 0.9f, {0.3f, 0.0f, 0.0f, 0.0f}},
                                           {-30.0f, 50.0f, 7.0f, 1.0f, {0.0f, 0.0f, 0.0f, 0.0f}}};
    static const swInputField fields[] = {[SW_SHAPE_EVERYWHERE] = SW_INPUT_LEVEL, [SW_SHAPE_CIRCLE] = SW_INPUT_WAVES,
                                          [SW_SHAPE_POLYGON] = SW_INPUT_LEVEL,    [SW_SHAPE_POLYLINE] = SW_INPUT_FOAM,
                                          [SW_SHAPE_SPLINE] = SW_INPUT_WAVES,     [SW_SHAPE_MESH] = SW_INPUT_FLOOR,
                                          [SW_SHAPE_RASTER] = SW_INPUT_FLOW,      [SW_SHAPE_PARTICLES] = SW_INPUT_FOAM};
    swInputDef def = swDefaultInputDef();
    swInputId id;
    bool isSolid = shape >= SW_SHAPE_BOX;
    bool hasPoints = shape == SW_SHAPE_POLYGON || shape == SW_SHAPE_POLYLINE || shape == SW_SHAPE_PARTICLES;
    def.shape = (swInputShape)shape;
    def.field = isSolid ? SW_INPUT_CLIP : shape == SW_SHAPE_RECTANGLE ? SW_INPUT_ALBEDO : fields[shape];
    def.value[0] = 0.5f;
    def.feather = 4.0f;
    def.size = (swVec3){60.0f, 20.0f, 50.0f};
    def.points = hasPoints ? points : NULL;
    def.pointCount = hasPoints ? 4 : 0;
    def.raster = shape == SW_SHAPE_RASTER ? resources->pairs : NULL;
    def.spline = shape == SW_SHAPE_SPLINE ? resources->spline : NULL;
    def.alongSpline = shape == SW_SHAPE_SPLINE;
    def.mesh = shape == SW_SHAPE_MESH ? resources->mesh : NULL;
    def.hull = shape == SW_SHAPE_HULL ? resources->hull : NULL;
    def.system = def.field == SW_INPUT_WAVES ? waves : def.system;
    FUZZ_CHECK(swCreateInput(world, &def, &id) == SW_SUCCESS);
}

typedef struct Made
{
    Resources resources;
    uint8_t *saved, *moment;
    size_t savedSize, momentSize;
} Made;

static void Make(Made* made)
{
    static const swVec2 shore[4] = {{-20.0f, -20.0f}, {25.0f, -20.0f}, {20.0f, 30.0f}, {-20.0f, 20.0f}};
    swHost host = swDefaultHost(); // they outlive the call
    swWaveSystemId waves;
    swWaterBodyId body;
    made->resources = MakeResources(&host);
    swWorld* world = MakeFuzzWorld(&host, &waves);
    for (int shape = 0; shape < SW_SHAPE_COUNT; ++shape)
    {
        if (shape != SW_SHAPE_FUNCTION)
        {
            AddShape(world, &made->resources, waves, shape);
        }
    }
    swWaterBodyDef lake = swDefaultWaterBodyDef();
    lake.points = shore;
    lake.pointCount = 4;
    lake.position = (swPos){70.0, 3.0, 70.0};
    FUZZ_CHECK(swCreateWaterBody(world, &lake, &body) == SW_SUCCESS);
    FUZZ_CHECK(swWorld_Step(world, 1.0) == SW_SUCCESS);
    swWorld_Save(world, NULL, &made->savedSize);
    made->saved = malloc(made->savedSize);
    FUZZ_CHECK(made->saved != NULL && swWorld_Save(world, made->saved, &made->savedSize) == SW_SUCCESS);
    swMomentDef def = swDefaultMomentDef();
    swMoment* moment = NULL;
    FUZZ_CHECK(swCreateMoment(world, &def, &moment) == SW_SUCCESS);
    const void* memory = swMoment_GetMemory(moment, &made->momentSize);
    made->moment = malloc(made->momentSize);
    FUZZ_CHECK(made->moment != NULL);
    memcpy(made->moment, memory, made->momentSize);
    swDestroyMoment(moment);
    swDestroyWorld(world);
}

static void Change(Bytes* bytes, uint8_t* data, size_t size)
{
    for (int i = 0; i < MOST_CHANGES && bytes->at < bytes->size; ++i)
    {
        // Places count from the end, where the inputs are.
        size_t at = (size_t)TakeByte(bytes) << 16 | (size_t)TakeByte(bytes) << 8 | (size_t)TakeByte(bytes);
        size_t back = at % (size / 4) + 1;
        for (size_t k = 0; k < 4 && 4 * back - k <= size; ++k)
        {
            data[size - 4 * back + k] = (uint8_t)TakeByte(bytes);
        }
    }
}

static void TrySaved(const Made* made, Bytes* bytes)
{
    static Answers answers;
    int messages = 0;
    swHost host = FuzzHost(&messages);
    uint8_t* data = malloc(made->savedSize);
    FUZZ_CHECK(data != NULL);
    memcpy(data, made->saved, made->savedSize);
    Change(bytes, data, made->savedSize - 8);
    FixHash(data, made->savedSize - 8);
    swRestoreDef def = swDefaultRestoreDef();
    def.memoryBudget = (size_t)64 << 20;
    def.findResource = FindFuzzResource;
    def.resourceContext = (void*)(uintptr_t)&made->resources;
    swWorld* world = NULL;
    swResult result = swRestoreWorld(&host, data, made->savedSize, &def, &world);
    FUZZ_CHECK((result == SW_SUCCESS) == (world != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (world != NULL)
    {
        FUZZ_CHECK(swWorld_Step(world, 0.1) == SW_SUCCESS);
        AskFuzzWorld(swWorld_GetMoment(world), &answers);
        CheckFuzzAnswers(&answers);
        // It cannot go back over the end of a change of waves, which such bytes may hold.
        messages = 0;
        FUZZ_CHECK(swWorld_Rewind(world, data, made->savedSize) == SW_SUCCESS || messages > 0);
        swDestroyWorld(world);
    }
    free(data);
}

static void TryMoment(const Made* made, Bytes* bytes)
{
    static Answers answers;
    int messages = 0;
    swHost host = FuzzHost(&messages);
    uint8_t* data = aligned_alloc(64, (made->momentSize + 63) / 64 * 64);
    FUZZ_CHECK(data != NULL);
    memcpy(data, made->moment, made->momentSize);
    Change(bytes, data, made->momentSize);
    swMoment* moment = NULL;
    swResult result = swMapMoment(&host, data, made->momentSize, &moment);
    FUZZ_CHECK((result == SW_SUCCESS) == (moment != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (moment != NULL)
    {
        AskFuzzWorld(moment, &answers); // whatever they are
    }
    swDestroyMoment(moment);
    free(data);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static Made made;
    Bytes bytes = {data, size, 0};
    if (made.saved == NULL)
    {
        Make(&made);
    }
    if (size > 0 && TakeByte(&bytes) % 2 == 0)
    {
        TrySaved(&made, &bytes);
    }
    else
    {
        TryMoment(&made, &bytes);
    }
    return 0;
}
