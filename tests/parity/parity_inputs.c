// SPDX-License-Identifier: MIT
// Every flat shape says the same of every field on both halves, with the same derivatives, here and 100 km away.

#include "parity/parity.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/input/sample_inputs.h"
#include "gpu/pass/gpu_inputs.h"
#include "gpu/vk/vk_submit.h"

static const uint32_t askCode[] =
#include "ask_inputs.comp.inc"
    ;

#define POINTS 2048
#define BUFFERS 6
#define SIDE 21

typedef struct Asked
{
    int32_t cell[2];
    float rest[2];
} Asked;

// ---- a shader that asks ----

typedef struct Asker
{
    swGpu* gpu;
    VkDescriptorSetLayout setLayout;
    VkPipelineLayout layout;
    VkPipeline pipeline;
    swBuffer places, answers;
} Asker;

static void MakePipeline(Asker* asker)
{
    swGpu* gpu = asker->gpu;
    VkDescriptorSetLayoutBinding bindings[BUFFERS] = {0};
    for (uint32_t i = 0; i < BUFFERS; ++i)
    {
        bindings[i] = (VkDescriptorSetLayoutBinding){.binding = i,
                                                     .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                                     .descriptorCount = 1,
                                                     .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT};
    }
    const VkDescriptorSetLayoutCreateInfo setInfo = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                                     .flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR,
                                                     .bindingCount = BUFFERS,
                                                     .pBindings = bindings};
    assert_int_equal(gpu->vk.CreateDescriptorSetLayout(gpu->device, &setInfo, NULL, &asker->setLayout), VK_SUCCESS);
    const VkPushConstantRange range = {VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(uint32_t)};
    const VkPipelineLayoutCreateInfo layoutInfo = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                                   .setLayoutCount = 1,
                                                   .pSetLayouts = &asker->setLayout,
                                                   .pushConstantRangeCount = 1,
                                                   .pPushConstantRanges = &range};
    assert_int_equal(gpu->vk.CreatePipelineLayout(gpu->device, &layoutInfo, NULL, &asker->layout), VK_SUCCESS);
    const VkShaderModuleCreateInfo moduleInfo = {
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = sizeof(askCode), .pCode = askCode};
    VkShaderModule module;
    assert_int_equal(gpu->vk.CreateShaderModule(gpu->device, &moduleInfo, NULL, &module), VK_SUCCESS);
    const VkComputePipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                              .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                        .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                                                        .module = module,
                                                        .pName = "main"},
                                              .layout = asker->layout};
    assert_int_equal(gpu->vk.CreateComputePipelines(gpu->device, VK_NULL_HANDLE, 1, &info, NULL, &asker->pipeline),
                     VK_SUCCESS);
    gpu->vk.DestroyShaderModule(gpu->device, module, NULL);
}

static Asker MakeAsker(swGpu* gpu)
{
    Asker asker = {.gpu = gpu};
    MakePipeline(&asker);
    const VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    VkDeviceSize answers = SW_INPUT_FIELD_COUNT * POINTS * sizeof(swInputValue);
    assert_int_equal(swCreateBuffer(gpu, POINTS * sizeof(Asked), storage, SW_MEMORY_UPLOAD, "places", &asker.places),
                     SW_SUCCESS);
    assert_int_equal(swCreateBuffer(gpu, answers, storage, SW_MEMORY_READBACK, "answers", &asker.answers), SW_SUCCESS);
    return asker;
}

static void FreeAsker(Asker* asker)
{
    swDestroyBuffer(asker->gpu, &asker->places);
    swDestroyBuffer(asker->gpu, &asker->answers);
    asker->gpu->vk.DestroyPipeline(asker->gpu->device, asker->pipeline, NULL);
    asker->gpu->vk.DestroyPipelineLayout(asker->gpu->device, asker->layout, NULL);
    asker->gpu->vk.DestroyDescriptorSetLayout(asker->gpu->device, asker->setLayout, NULL);
}

// The answers of all fields at places of the sea, [field][POINTS].
static const swInputValue* Ask(Asker* asker, const swGpuInputs* inputs, const swPosXZ* points)
{
    swGpu* gpu = asker->gpu;
    Asked* places = asker->places.mapped;
    for (int i = 0; i < POINTS; ++i)
    {
        swSplitSeaPlace(points[i].x, &places[i].cell[0], &places[i].rest[0]);
        swSplitSeaPlace(points[i].z, &places[i].cell[1], &places[i].rest[1]);
    }
    const swBuffer* bound[BUFFERS] = {&inputs->head,  &inputs->records, &inputs->nodes,
                                      &inputs->words, &asker->places,   &asker->answers};
    VkDescriptorBufferInfo buffers[BUFFERS];
    VkWriteDescriptorSet writes[BUFFERS];
    for (uint32_t i = 0; i < BUFFERS; ++i)
    {
        buffers[i] = (VkDescriptorBufferInfo){bound[i]->handle, 0, VK_WHOLE_SIZE};
        writes[i] = (VkWriteDescriptorSet){.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                           .dstBinding = i,
                                           .descriptorCount = 1,
                                           .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                           .pBufferInfo = &buffers[i]};
    }
    VkCommandBuffer commands;
    assert_int_equal(swBeginSubmit(gpu, &commands), SW_SUCCESS);
    gpu->vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, asker->pipeline);
    gpu->vk.CmdPushDescriptorSetKHR(commands, VK_PIPELINE_BIND_POINT_COMPUTE, asker->layout, 0, BUFFERS, writes);
    const uint32_t count = POINTS;
    gpu->vk.CmdPushConstants(commands, asker->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(count), &count);
    gpu->vk.CmdDispatch(commands, POINTS / 64, SW_INPUT_FIELD_COUNT, 1);
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
              VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
    assert_int_equal(swEndSubmit(gpu), SW_SUCCESS);
    return asker->answers.mapped;
}

// ---- shapes ----

static int CountNumbers(swInputField field)
{
    return (int)swCountInputNumbers((sw_uint)field);
}

static swSpline* MakeSpline(const swHost* host)
{
    swSplinePoint points[6];
    for (int i = 0; i < 6; ++i)
    {
        double angle = 2.0 * SW_PI * i / 6.0;
        points[i] = swDefaultSplinePoint(80.0 * cos(angle), 1.5 - 0.2 * i, 60.0 * sin(angle));
        points[i].weight = 0.7f + 0.05f * (float)i;
        points[i].depth = 4.0f + 0.3f * (float)i;
        points[i].level = 0.1f * (float)i;
        points[i].width = 1.0f + 0.2f * (float)(i % 3);
        points[i].flow = 0.8f + 0.1f * (float)i;
        points[i].foam = 0.3f * (float)i;
    }
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = 6;
    def.isClosed = true;
    def.width = 70.0f;
    swSpline* spline = NULL;
    assert_int_equal(swCreateSpline(host, &def, &spline), SW_SUCCESS);
    return spline;
}

static swRaster* MakeRaster(const swHost* host, int channels)
{
    static float values[SIDE * SIDE * 4];
    for (int i = 0; i < SIDE * SIDE * channels; ++i)
    {
        values[i] = 0.8f * (float)sin(0.37 * (i / channels % SIDE) + 0.23 * (i / channels / SIDE) + i % channels);
    }
    values[channels * (10 * SIDE + 7)] = NAN;
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = SIDE;
    def.channels = channels;
    def.spacingX = 11.0;
    def.spacingZ = 9.0;
    def.x = -0.5 * def.spacingX * (SIDE - 1);
    def.z = -0.5 * def.spacingZ * (SIDE - 1);
    def.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(host, &def, &raster), SW_SUCCESS);
    return raster;
}

static swMesh* MakeMesh(const swHost* host, int channels)
{
    static const swVec3 vertices[] = {{-120.0f, 0.0f, -90.0f}, {120.0f, 0.0f, -90.0f}, {-120.0f, 0.0f, 90.0f},
                                      {120.0f, 0.0f, 90.0f},   {-70.0f, 7.0f, 5.0f},   {60.0f, 4.0f, -10.0f}};
    static const uint32_t faces[] = {0, 1, 5, 0, 5, 4, 0, 4, 2, 2, 4, 3, 4, 5, 3, 5, 1, 3};
    static float values[6 * 4];
    for (int i = 0; i < 6 * channels; ++i)
    {
        values[i] = 0.5f + 0.4f * (float)sin(1.7 * i);
    }
    swMeshDef def = swDefaultMeshDef();
    def.vertices = vertices;
    def.vertexCount = 6;
    def.indices = faces;
    def.triangleCount = 6;
    def.values = values;
    def.channelCount = channels;
    swMesh* mesh = NULL;
    assert_int_equal(swCreateMesh(host, &def, &mesh), SW_SUCCESS);
    return mesh;
}

// One input of a shape for a field; false where the two make no sense together.
static bool AddShape(Parity* parity, swInputShape shape, swInputField field, swInputBlend blend, swPosXZ middle)
{
    static const swInputPoint points[] = {{-90.0f, -60.0f, 30.0f, 1.0f, {0.1f, 0.3f, 0.2f, 0.0f}},
                                          {80.0f, -75.0f, 50.0f, 0.7f, {-0.5f, 0.2f, 0.1f, 0.2f}},
                                          {95.0f, 85.0f, 60.0f, 0.5f, {-0.7f, 0.1f, 0.5f, 0.1f}},
                                          {40.0f, 10.0f, 40.0f, 0.9f, {0.6f, -0.4f, 0.2f, 0.3f}},
                                          {-70.0f, 60.0f, 35.0f, 1.0f, {0.5f, 0.6f, 0.3f, 0.1f}}};
    swHost host = swDefaultHost();
    int channels = CountNumbers(field);
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = shape;
    def.blend = field == SW_INPUT_BODY ? SW_BLEND_REPLACE : blend; // numbers of bodies do not mix
    def.followsWaves = field == SW_INPUT_DISPLACEMENT;
    def.position = (swPos){middle.x, 0.4, middle.z};
    def.rotation.yaw = 0.6f;
    def.size = (swVec3){220.0f, 10.0f, 160.0f};
    def.feather = 30.0f;
    def.weight = 0.9f;
    def.value[0] = field == SW_INPUT_FLOOR ? -7.0f : field == SW_INPUT_BODY ? 2.0f : 0.6f;
    def.value[1] = 0.3f;
    def.value[2] = -0.2f;
    def.value[3] = 0.5f;
    bool hasPoints = shape == SW_SHAPE_POLYGON || shape == SW_SHAPE_POLYLINE || shape == SW_SHAPE_PARTICLES;
    def.points = hasPoints ? points : NULL;
    def.pointCount = hasPoints ? 5 : 0;
    swSpline* spline = shape == SW_SHAPE_SPLINE ? MakeSpline(&host) : NULL;
    swRaster* raster = shape == SW_SHAPE_RASTER ? MakeRaster(&host, channels) : NULL;
    swMesh* mesh = shape == SW_SHAPE_MESH ? MakeMesh(&host, channels) : NULL;
    def.spline = spline;
    def.raster = raster;
    def.mesh = mesh;
    swInputId id;
    swResult result = swCreateInput(parity->world, &def, &id);
    swDestroySpline(spline);
    swDestroyRaster(raster);
    swDestroyMesh(mesh);
    return result == SW_SUCCESS;
}

// ---- both halves ----

// The largest differences of a field's numbers and of their derivatives, by parts of what is large.
static void CompareField(int field, int count, const swInputValue* core, const swInputValue* gpu, double* value,
                         double* slope, int* covered)
{
    const swInputValue below = swGetFieldBelow((sw_uint)field);
    for (int i = 0; i < count; ++i)
    {
        const float* a = (const float*)&core[i];
        const float* b = (const float*)&gpu[i];
        for (int n = 0; n < 12; ++n)
        {
            // A floor that fades into none is mixed by the inverse of its depth.
            double scale = field == SW_INPUT_FLOOR ? fmax(fabs((double)core[i].value.x) / 50.0, 1.0) : 1.0;
            double off = fabs((double)a[n] - (double)b[n]) / scale / scale;
            double* worst = n < 4 ? value : slope;
            *worst = off <= *worst ? *worst : off;
        }
        *covered += memcmp(&core[i].value, &below.value, sizeof below.value) != 0 ? 1 : 0;
    }
}

static void CheckShape(void** state, Asker* asker, swInputShape shape, const char* name, swPosXZ middle)
{
    static swPosXZ points[POINTS];
    static swInputValue core[POINTS];
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 32.0f;
    AddParitySea(&parity, &sea);
    bool isThere[SW_INPUT_FIELD_COUNT];
    for (int field = 0; field < SW_INPUT_FIELD_COUNT; ++field)
    {
        // Something below it, then the shape twice, with blends that a field has.
        AddShape(&parity, SW_SHAPE_EVERYWHERE, (swInputField)field, SW_BLEND_ALPHA, middle);
        isThere[field] = AddShape(&parity, shape, (swInputField)field, SW_BLEND_ALPHA, middle);
        AddShape(&parity, shape, (swInputField)field, SW_BLEND_ADD, (swPosXZ){middle.x + 30.0, middle.z - 20.0});
    }
    StepParity(&parity, 0.5);
    ScatterPoints(points, POINTS, middle.x, middle.z, 400.0);
    const swInputValue* gpu = Ask(asker, &parity.gpuWorld->inputs, points);
    double value = 0.0, slope = 0.0;
    int fieldCount = 0, covered = 0;
    for (int field = 0; field < SW_INPUT_FIELD_COUNT; ++field)
    {
        if (isThere[field])
        {
            swFindInputValues(swGetWorldFrame(parity.world)->inputs, field, 0, POINTS, points, core);
            CompareField(field, POINTS, core, gpu + field * POINTS, &value, &slope, &covered);
            fieldCount += 1;
        }
    }
    printf("  %-10s %s %2d fields: values %.2g, slopes %.2g\n", name,
           middle.x < 1e4 ? "here:  " : "100 km:", fieldCount, value, slope);
    // What lies between the corners of a mesh or the samples of a raster is no number of a body: that field is refused.
    bool isMixed = shape == SW_SHAPE_MESH || shape == SW_SHAPE_RASTER;
    assert_true(isThere[SW_INPUT_BODY] == !isMixed && fieldCount == SW_INPUT_FIELD_COUNT - (isMixed ? 1 : 0));
    assert_true(covered > fieldCount * POINTS / 10);
    assert_true(value < 1e-3);
    assert_true(slope < 1e-3);
    FreeParity(&parity);
}

static void EveryShapeSaysTheSameOfEveryField(void** state)
{
    static const struct
    {
        swInputShape shape;
        const char* name;
    } shapes[] = {{SW_SHAPE_CIRCLE, "circle"},       {SW_SHAPE_RECTANGLE, "rectangle"}, {SW_SHAPE_POLYGON, "polygon"},
                  {SW_SHAPE_POLYLINE, "polyline"},   {SW_SHAPE_SPLINE, "spline"},       {SW_SHAPE_MESH, "mesh"},
                  {SW_SHAPE_PARTICLES, "particles"}, {SW_SHAPE_RASTER, "raster"}};
    Asker asker = MakeAsker(*state);
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; ++i)
    {
        CheckShape(state, &asker, shapes[i].shape, shapes[i].name, (swPosXZ){20.0, -30.0});
        CheckShape(state, &asker, shapes[i].shape, shapes[i].name, (swPosXZ){1e5 + 17.3, -1e5 - 40.6});
    }
    FreeAsker(&asker);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(EveryShapeSaysTheSameOfEveryField)};
    return cmocka_run_group_tests_name("shapes and fields: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
