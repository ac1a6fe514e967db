// SPDX-License-Identifier: MIT
#include "parity/parity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "gpu/vk/vk_submit.h"

int OpenParityGpu(void** state)
{
    return OpenParityGpuWith(state, SW_LAYERS_GPU); // the passes are what is tested, also on a software device
}

int OpenParityGpuWith(void** state, swLayerSource layers)
{
    swHost host = swDefaultHost();
    swGpuDef def = swDefaultGpuDef();
    def.enableValidation = true;
    def.layers = layers;
    swGpu* gpu = NULL;
    swResult result = swCreateGpu(&host, &def, &gpu);
    if (result == SW_ERROR_UNSUPPORTED)
    {
        puts("the validation layers are not installed: this run checks numbers only");
        def.enableValidation = false;
        result = swCreateGpu(&host, &def, &gpu);
    }
    if (result != SW_SUCCESS)
    {
        printf("no device: %s\n", swResult_GetText(result));
        return -1;
    }
    printf("device: %s\n", swGpu_GetDeviceName(gpu));
    *state = gpu;
    return 0;
}

int CloseParityGpu(void** state)
{
    swGpu* gpu = *state;
    int messages = swGpu_GetValidationCount(gpu);
    swDestroyGpu(gpu);
    if (messages != 0)
    {
        printf("the validation layers had %d messages\n", messages);
    }
    return messages == 0 ? 0 : -1;
}

Parity MakeParity(void** state)
{
    swWorldDef def = swDefaultWorldDef();
    return MakeParityOf(state, &def);
}

Parity MakeParityOf(void** state, const swWorldDef* def)
{
    Parity parity = {.gpu = *state};
    swHost host = swDefaultHost();
    assert_int_equal(swCreateTaskPool(&host, 1, &parity.pool), SW_SUCCESS);
    swTaskPool_Attach(parity.pool, &host);
    assert_int_equal(swCreateWorld(&host, def, &parity.world), SW_SUCCESS);
    assert_int_equal(swCreateGpuWorld(parity.gpu, parity.world, &parity.gpuWorld), SW_SUCCESS);
    return parity;
}

void AddParitySea(Parity* parity, const swWaveSystemDef* def)
{
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(parity->world, def, &id), SW_SUCCESS);
}

void AddParityView(Parity* parity, int sliceCount, int resolution, swPos viewpoint)
{
    swViewDef def = swDefaultViewDef();
    def.sliceCount = sliceCount;
    def.resolution = resolution;
    def.enableCpuLayers = true;
    assert_int_equal(swCreateView(parity->world, &def, &parity->view), SW_SUCCESS);
    swView_SetViewpoint(parity->view, viewpoint);
    parity->sliceCount = sliceCount;
    parity->resolution = resolution;
}

void FreeParity(Parity* parity)
{
    swDestroyGpuWorld(parity->gpuWorld);
    swDestroyView(parity->view);
    swDestroyWorld(parity->world);
    swDestroyTaskPool(parity->pool);
}

void StepParity(Parity* parity, double dt)
{
    assert_int_equal(swWorld_Step(parity->world, dt), SW_SUCCESS);
    VkCommandBuffer commands;
    assert_int_equal(swBeginSubmit(parity->gpu, &commands), SW_SUCCESS);
    // Frame indices grow over all worlds of a device.
    uint64_t frameIndex = parity->gpu->hasFrame ? parity->gpu->frameIndex + 1 : 0;
    assert_int_equal(swGpuWorld_Record(parity->gpuWorld, commands, frameIndex), SW_SUCCESS);
    assert_int_equal(swEndSubmit(parity->gpu), SW_SUCCESS);
}

Difference Compare(const float* a, const float* b, size_t count, int channels, int compared)
{
    Difference difference = {0};
    double sum = 0.0, reference = 0.0;
    for (size_t i = 0; i < count; ++i)
    {
        for (int c = 0; c < compared; ++c)
        {
            double x = (double)a[i * (size_t)channels + (size_t)c];
            double error = fabs(x - (double)b[i * (size_t)channels + (size_t)c]);
            difference.worst = error <= difference.worst ? difference.worst : error; // NaN counts as worst
            sum += error * error;
            reference += x * x;
        }
    }
    double total = (double)count * compared;
    difference.rms = sqrt(sum / total);
    difference.scale = sqrt(reference / total);
    return difference;
}

Difference MaxDifference(Difference a, Difference b)
{
    return (Difference){.worst = fmax(a.worst, b.worst), .rms = fmax(a.rms, b.rms), .scale = fmax(a.scale, b.scale)};
}

Difference CompareLayer(Parity* parity, swLayer layer)
{
    int channels = layer >= SW_LAYER_FOAM ? 1 : 4;
    size_t count = (size_t)parity->resolution * (size_t)parity->resolution;
    float* gpu = malloc(count * (size_t)channels * sizeof(float));
    assert_non_null(gpu);
    Difference difference = {0};
    for (int slice = 0; slice < parity->sliceCount; ++slice)
    {
        const float* cpu = layer == SW_LAYER_FOAM          ? swView_GetFoam(parity->view, slice)
                           : layer == SW_LAYER_WAKE_FOAM   ? swView_GetWakeFoam(parity->view, slice)
                           : layer == SW_LAYER_SHORE_FOAM  ? swView_GetShoreFoam(parity->view, slice)
                           : layer == SW_LAYER_DERIVATIVES ? swView_GetDerivatives(parity->view, slice)
                                                           : swView_GetDisplacement(parity->view, slice);
        assert_non_null(cpu);
        assert_int_equal(swGpuWorld_ReadLayer(parity->gpuWorld, parity->view, layer, slice, gpu), SW_SUCCESS);
        difference = MaxDifference(difference, Compare(cpu, gpu, count, channels, channels));
    }
    free(gpu);
    return difference;
}

void PrintDifference(const char* what, Difference difference, const char* unit)
{
    printf("  %-44s max %.3g %s, rms %.3g, of rms %.3g\n", what, difference.worst, unit, difference.rms,
           difference.scale);
}
