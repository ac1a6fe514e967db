// SPDX-License-Identifier: MIT
// The stage by itself: devices by name and number, frames, and the way back to the host.

#include <string.h>

#include <seaway/lines.h>
#include <seaway/stage.h>

#include "support/cmocka_setup.h"
#include "support/counting_host.h"

#define WIDTH 5
#define HEIGHT 3
#define BYTES (4 * WIDTH * HEIGHT)

static CountingMemory s_memory;
static swStage* s_stage;

static swStageImage MakeImage(void)
{
    const swStageImageDef def = {.name = "a small image",
                                 .format = VK_FORMAT_R8G8B8A8_UNORM,
                                 .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                                 .width = WIDTH,
                                 .height = HEIGHT};
    swStageImage image;
    assert_int_equal(swStage_CreateImage(s_stage, &def, &image), SW_SUCCESS);
    return image;
}

static swStageBuffer MakeBuffer(uint8_t value)
{
    swStageBuffer buffer;
    assert_int_equal(swStage_CreateBuffer(s_stage, BYTES, VK_BUFFER_USAGE_TRANSFER_DST_BIT, &buffer), SW_SUCCESS);
    memset(buffer.data, value, BYTES);
    return buffer;
}

// Clears the image and copies it.
static void RecordClear(const swStageImage* image, const swStageBuffer* buffer, VkCommandBuffer commands)
{
    swStage_UseImage(s_stage, commands, image, SW_STAGE_USE_DISCARD, SW_STAGE_USE_COLOR_TARGET);
    swStage_BeginDrawing(s_stage, commands, image, image->view, false, NULL);
    swStage_EndDrawing(s_stage, commands);
    swStage_CopyToHost(s_stage, commands, image, SW_STAGE_USE_COLOR_TARGET, buffer);
}

static int CountBytes(const swStageBuffer* buffer, uint8_t value)
{
    const uint8_t* bytes = buffer->data;
    int count = 0;
    for (int i = 0; i < BYTES; ++i)
    {
        count += bytes[i] == value;
    }
    return count;
}

static void DevicesHaveNamesAndNumbers(void** state)
{
    (void)state;
    swDeviceChoice choice = SW_DEVICE_AUTO;
    int index = -1;
    assert_true(swParseStageDevice("software", &choice, &index));
    assert_int_equal(choice, SW_DEVICE_SOFTWARE);
    assert_true(swParseStageDevice("gpu", &choice, &index));
    assert_int_equal(choice, SW_DEVICE_GPU);
    assert_true(swParseStageDevice("auto", &choice, &index));
    assert_int_equal(choice, SW_DEVICE_AUTO);
    assert_true(swParseStageDevice("63", &choice, &index));
    assert_int_equal(choice, SW_DEVICE_INDEX);
    assert_int_equal(index, 63);
    static const char* const others[] = {"", "64", "-1", "1.5", "fast", "0x1", " 1", "1 ", "00001"};
    for (size_t i = 0; i < sizeof(others) / sizeof(others[0]); ++i)
    {
        assert_false(swParseStageDevice(others[i], &choice, &index));
    }
}

static void ListedDevicesAreThoseThatAnIndexMeans(void** state)
{
    (void)state;
    const swHost host = swDefaultHost();
    static swStageDevice devices[8];
    int count = 0;
    assert_int_equal(swListStageDevices(&host, 8, devices, &count), SW_SUCCESS);
    assert_true(count >= 1);
    for (int i = 0; i < count && i < 8; ++i)
    {
        assert_int_equal(devices[i].isUsable, devices[i].missing[0] == '\0');
        swGpuDef def = swDefaultGpuDef();
        def.choice = SW_DEVICE_INDEX;
        def.deviceIndex = i;
        swStage* stage = NULL;
        if (devices[i].isUsable)
        {
            assert_int_equal(swCreateStage(&host, &def, &stage), SW_SUCCESS);
            assert_string_equal(swGpu_GetDeviceName(swStage_GetGpu(stage)), devices[i].name);
            swDestroyStage(stage);
        }
    }
    int again = 0;
    assert_int_equal(swListStageDevices(&host, 0, devices, &again), SW_SUCCESS); // how many there are
    assert_int_equal(again, count);
}

static void AnImageComesBackToTheHost(void** state)
{
    (void)state;
    swStageImage image = MakeImage();
    swStageBuffer buffer = MakeBuffer(0xab);
    swStageFrame frame;
    assert_int_equal(swStage_BeginFrame(s_stage, &frame), SW_SUCCESS);
    RecordClear(&image, &buffer, frame.commands);
    assert_int_equal(swStage_SubmitFrame(s_stage, &frame, NULL), SW_SUCCESS);
    assert_int_equal(swStage_Wait(s_stage), SW_SUCCESS);
    assert_int_equal(CountBytes(&buffer, 0), BYTES);
    swStage_DestroyBuffer(s_stage, &buffer);
    swStage_DestroyImage(s_stage, &image);
}

static void ADroppedFrameDoesNotRun(void** state)
{
    (void)state;
    swStageImage image = MakeImage();
    swStageBuffer buffer = MakeBuffer(0xab);
    swStageFrame dropped, next;
    assert_int_equal(swStage_BeginFrame(s_stage, &dropped), SW_SUCCESS);
    RecordClear(&image, &buffer, dropped.commands);
    swStage_DropFrame(s_stage, &dropped);
    for (int i = 0; i < 6; ++i) // the dropped frame's place is used again
    {
        assert_int_equal(swStage_BeginFrame(s_stage, &next), SW_SUCCESS);
        assert_true(next.index == dropped.index + 1 + (uint64_t)i);
        assert_int_equal(swStage_SubmitFrame(s_stage, &next, NULL), SW_SUCCESS);
    }
    assert_int_equal(swStage_Wait(s_stage), SW_SUCCESS);
    assert_int_equal(CountBytes(&buffer, 0xab), BYTES);
    swStage_DestroyBuffer(s_stage, &buffer);
    swStage_DestroyImage(s_stage, &image);
}

static void WhatIsTooLargeIsRefused(void** state)
{
    (void)state;
    swStageTargets targets;
    assert_int_equal(swStage_CreateTargets(s_stage, 1u << 20, 4, 0, 0, &targets), SW_ERROR_UNSUPPORTED);
    assert_true(targets.hdr.image == VK_NULL_HANDLE && targets.output.image == VK_NULL_HANDLE);
    assert_int_equal(swStage_CreateTargets(s_stage, 8, 1u << 20, 8, 8, &targets), SW_ERROR_UNSUPPORTED);
    assert_true(targets.hdr.image == VK_NULL_HANDLE && targets.depth.memory == VK_NULL_HANDLE);
    assert_int_equal(s_memory.messages, 2);
}

static void AFormatThatTheDeviceCannotUseIsRefused(void** state)
{
    (void)state;
    swStageImage image;
    swStageImageDef def = {.name = "an image",
                           .format = VK_FORMAT_S8_UINT,
                           .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                           .width = WIDTH,
                           .height = HEIGHT};
    int messages = s_memory.messages;
    assert_int_equal(swStage_CreateImage(s_stage, &def, &image), SW_ERROR_UNSUPPORTED);
    assert_true(image.image == VK_NULL_HANDLE);
    def.format = VK_FORMAT_R8G8B8A8_UNORM;
    def.otherFormat = VK_FORMAT_S8_UINT;
    assert_int_equal(swStage_CreateImage(s_stage, &def, &image), SW_ERROR_UNSUPPORTED);
    assert_int_equal(s_memory.messages, messages + 2);
}

#ifdef NDEBUG // misuse stops the program where asserts are on
static void WhatIsRefusedCanBeDestroyed(void** state)
{
    (void)state;
    swStageTargets targets;
    swStageBuffer buffer;
    swStageImage image;
    memset(&targets, 0xff, sizeof(targets));
    memset(&buffer, 0xff, sizeof(buffer));
    memset(&image, 0xff, sizeof(image));
    assert_int_equal(swStage_CreateTargets(s_stage, 0, 0, 0, 0, &targets), SW_ERROR_INVALID);
    assert_int_equal(swStage_CreateBuffer(s_stage, 0, VK_BUFFER_USAGE_TRANSFER_DST_BIT, &buffer), SW_ERROR_INVALID);
    assert_int_equal(swStage_CreateImage(s_stage, &(swStageImageDef){.name = "no image"}, &image), SW_ERROR_INVALID);
    swStage_DestroyTargets(s_stage, &targets);
    swStage_DestroyBuffer(s_stage, &buffer);
    swStage_DestroyImage(s_stage, &image);
    assert_int_equal(swGpu_GetValidationCount(swStage_GetGpu(s_stage)), 0);
}

static void ABufferThatIsTooSmallGetsNoCopy(void** state)
{
    (void)state;
    swStageImage image = MakeImage();
    swStageBuffer buffer;
    assert_int_equal(swStage_CreateBuffer(s_stage, BYTES - 1, VK_BUFFER_USAGE_TRANSFER_DST_BIT, &buffer), SW_SUCCESS);
    swStageFrame frame;
    int messages = s_memory.messages;
    assert_int_equal(swStage_BeginFrame(s_stage, &frame), SW_SUCCESS);
    RecordClear(&image, &buffer, frame.commands);
    swStage_DropFrame(s_stage, &frame);
    assert_int_equal(s_memory.messages, messages + 1);
    assert_int_equal(swGpu_GetValidationCount(swStage_GetGpu(s_stage)), 0);
    swStage_DestroyBuffer(s_stage, &buffer);
    swStage_DestroyImage(s_stage, &image);
}
#endif

static void WithoutMemoryThereIsNoStage(void** state)
{
    (void)state;
    CountingMemory memory;
    const swHost host = MakeCountingHost(&memory);
    const swGpuDef def = swDefaultGpuDef();
    memory.failAt = 0;
    swStage* stage = NULL;
    assert_int_equal(swCreateStage(&host, &def, &stage), SW_ERROR_NO_MEMORY);
    assert_null(stage);
    memory.failAt = memory.allocations + 1; // the first of its device
    assert_int_equal(swCreateStage(&host, &def, &stage), SW_ERROR_NO_MEMORY);
    assert_null(stage);
    assert_int_equal(memory.bytes, 0);
}

static int OpenStage(void** state)
{
    (void)state;
    const swHost host = MakeCountingHost(&s_memory);
    swGpuDef def = swDefaultGpuDef();
    def.enableValidation = true;
    return swCreateStage(&host, &def, &s_stage) == SW_SUCCESS ? 0 : -1;
}

static int CloseStage(void** state)
{
    (void)state;
    int messages = swGpu_GetValidationCount(swStage_GetGpu(s_stage));
    swDestroyStage(s_stage);
    return messages + (s_memory.bytes != 0);
}

// A pyramid's level cuts are closed lines, which no other input of a field everywhere has.
static void AHullHasAnOutline(void** state)
{
    (void)state;
    static const swVec3 corners[5] = {
        {-9.0f, 0.0f, -9.0f}, {9.0f, 0.0f, -9.0f}, {9.0f, 0.0f, 9.0f}, {-9.0f, 0.0f, 9.0f}, {0.0f, 9.0f, 0.0f}};
    static const uint32_t faces[6 * 3] = {0, 1, 2, 0, 2, 3, 0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0};
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swHullDef hullDef = swDefaultHullDef();
    swInputDef input = swDefaultInputDef();
    swWorld* world = NULL;
    swHull* hull = NULL;
    swStageLines* lines = NULL;
    swInputId id;
    hullDef.vertices = corners;
    hullDef.vertexCount = 5;
    hullDef.indices = faces;
    hullDef.triangleCount = 6;
    assert_int_equal(swCreateHull(&host, &hullDef, &hull), SW_SUCCESS);
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    assert_int_equal(swStage_CreateLines(s_stage, &lines), SW_SUCCESS);
    swStageLines_AddInputs(lines, world);
    assert_int_equal(swStageLines_GetCount(lines), 0);
    input.field = SW_INPUT_CLIP;
    input.shape = SW_SHAPE_HULL;
    input.hull = hull;
    assert_int_equal(swCreateInput(world, &input, &id), SW_SUCCESS);
    swStageLines_AddInputs(lines, world);
    int count = swStageLines_GetCount(lines);
    print_message("%d lines around a pyramid\n", count);
    assert_true(count > 5 * 4 * 4 && count < 5 * 4 * 64);
    swStage_DestroyLines(s_stage, lines);
    swDestroyWorld(world);
    swDestroyHull(hull);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(DevicesHaveNamesAndNumbers),
        cmocka_unit_test(ListedDevicesAreThoseThatAnIndexMeans),
        cmocka_unit_test(AnImageComesBackToTheHost),
        cmocka_unit_test(ADroppedFrameDoesNotRun),
        cmocka_unit_test(WhatIsTooLargeIsRefused),
        cmocka_unit_test(WithoutMemoryThereIsNoStage),
        cmocka_unit_test(AFormatThatTheDeviceCannotUseIsRefused),
        cmocka_unit_test(AHullHasAnOutline),
#ifdef NDEBUG
        cmocka_unit_test(WhatIsRefusedCanBeDestroyed),
        cmocka_unit_test(ABufferThatIsTooSmallGetsNoCopy),
#endif
    };
    return cmocka_run_group_tests(tests, OpenStage, CloseStage);
}
