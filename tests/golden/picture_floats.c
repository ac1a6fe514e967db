// SPDX-License-Identifier: MIT
// Many mobile GPUs cannot filter 32-bit floats. A device that says so is taken all the same, and its pictures differ
// from those of one that can only by how filtering hardware rounds. The device here can; its loader says that it
// cannot.

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "golden/canvas.h"
#include "gpu/vk/vk_device.h"
#include "support/cmocka_setup.h"

#define SIDE 96
#define PIXELS (SIDE * SIDE)

static PFN_vkGetInstanceProcAddr s_loader;
static PFN_vkGetPhysicalDeviceFormatProperties s_getProperties;

static VKAPI_ATTR void VKAPI_CALL GetWithoutFilter(VkPhysicalDevice device, VkFormat format,
                                                   VkFormatProperties* properties)
{
    s_getProperties(device, format, properties);
    if (format == VK_FORMAT_R32_SFLOAT || format == VK_FORMAT_R32G32_SFLOAT || format == VK_FORMAT_R32G32B32A32_SFLOAT)
    {
        properties->optimalTilingFeatures &= ~(VkFormatFeatureFlags)VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
    }
}

static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL LoadWithoutFilter(VkInstance instance, const char* name)
{
    PFN_vkVoidFunction function = s_loader(instance, name);
    if (strcmp(name, "vkGetPhysicalDeviceFormatProperties") == 0 && function != NULL)
    {
        s_getProperties = (PFN_vkGetPhysicalDeviceFormatProperties)function;
        return (PFN_vkVoidFunction)GetWithoutFilter;
    }
    return function;
}

static Canvas* OpenCanvas(PFN_vkGetInstanceProcAddr loader)
{
    Canvas* canvas = CreateCanvasBy(SIDE, SIDE, true, loader);
    return canvas != NULL ? canvas : CreateCanvasBy(SIDE, SIDE, false, loader); // the layers are not installed
}

static void CloseCanvas(Canvas* canvas)
{
    assert_int_equal(GetCanvasValidationCount(canvas), 0);
    DestroyCanvas(canvas);
}

static void ADeviceThatCannotFilterFloatsIsTaken(void** state)
{
    (void)state;
    Canvas* canvas = OpenCanvas(LoadWithoutFilter);
    assert_non_null(canvas);
    const swGpu* gpu = GetCanvasGpu(canvas);
    assert_false(gpu->filtersFloats);
    char missing[256];
    assert_true(swGpu_CheckDevice(LoadWithoutFilter, swGpu_GetInstance(gpu), swGpu_GetPhysicalDevice(gpu), missing,
                                  sizeof(missing)));
    assert_string_equal(missing, "");
    CloseCanvas(canvas);
}

// Foam alone from above, then a whole picture.
static void DrawBoth(PFN_vkGetInstanceProcAddr loader, float* foam, float* hdr)
{
    Canvas* canvas = OpenCanvas(loader);
    assert_non_null(canvas);
    Shot shot = {.name = "foam",
                 .windSpeed = 18.0f,
                 .height = 12.0f,
                 .pitchDeg = -60.0f,
                 .fovDeg = 60.0f,
                 .sunElevationDeg = 40.0f,
                 .time = 40.0,
                 .steps = 3,
                 .hasCoreLayers = true};
    assert_true(DrawShot(canvas, &shot, NULL, hdr));
    shot.debug = SW_DEBUG_FOAM;
    assert_true(DrawShot(canvas, &shot, NULL, foam));
    CloseCanvas(canvas);
}

static void FoamLooksTheSameFilteredByHand(void** state)
{
    (void)state;
    static float foam[2][4 * PIXELS], hdr[2][4 * PIXELS];
    DrawBoth(s_loader, foam[0], hdr[0]);
    DrawBoth(LoadWithoutFilter, foam[1], hdr[1]);
    double worst = 0.0, sum = 0.0, square = 0.0, light = 0.0, difference = 0.0;
    for (int i = 0; i < PIXELS; ++i)
    {
        double a = (double)foam[0][4 * i], b = (double)foam[1][4 * i];
        worst = fabs(a - b) <= worst ? worst : fabs(a - b);
        sum += a / PIXELS;
        square += a * a / PIXELS;
        light += (double)hdr[0][4 * i + 1];
        difference += fabs((double)hdr[0][4 * i + 1] - (double)hdr[1][4 * i + 1]);
    }
    printf("  foam differs by at most %.2g, of mean %.2g and deviation %.2g; light by %.2g of its mean\n", worst, sum,
           sqrt(square - sum * sum), difference / light);
    assert_true(square - sum * sum > 1e-4); // it has a pattern that the nearest texels would show as steps
    assert_true(worst < 0.01);              // hardware's weights are multiples of 1 / 256
    assert_true(difference < 1e-3 * light);
}

static int FindLoader(void** state)
{
    (void)state;
    void* library = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
    void* found = library != NULL ? dlsym(library, "vkGetInstanceProcAddr") : NULL;
    memcpy(&s_loader, &found, sizeof(s_loader)); // C has no cast for it
    return s_loader != NULL ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ADeviceThatCannotFilterFloatsIsTaken),
        cmocka_unit_test(FoamLooksTheSameFilteredByHand),
    };
    return cmocka_run_group_tests_name("floats that are not filtered", tests, FindLoader, NULL);
}
