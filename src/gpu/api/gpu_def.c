// SPDX-License-Identifier: MIT
// The tables of what a device and its queries are made with.

#include <math.h>

#include "core/base/field.h"
#include "gpu/record/record.h"
#include "seaway/gpu.h"

// ---- a device ----

static const char* const choiceWords[] = {"auto", "gpu", "software", "index", NULL};
static const char* const layerWords[] = {"auto", "gpu", "core", NULL};

enum
{
    CHOICE_FIELD = 6
};

#define SW_DEF swGpuDef
static const swField gpuFields[] = {
    SW_GIVEN(getInstanceProcAddr, .key = NULL, .label = "loader"),
    SW_GIVEN(instance, .key = NULL, .label = "instance"),
    SW_GIVEN(physicalDevice, .key = NULL, .label = "physical device"),
    SW_GIVEN(device, .key = NULL, .label = "device"),
    SW_GIVEN(queue, .key = NULL, .label = "queue"),
    SW_NUMBER(queueFamily, "", SW_WITHIN(0.0, UINT32_MAX), 0.0, .key = NULL, .label = "queue family",
              .use = SW_USE_HERE),
    [CHOICE_FIELD] =
        SW_CHOICE(choice, choiceWords, choiceWords, SW_DEVICE_AUTO, .key = NULL, .label = "device", .use = SW_USE_HERE),
    SW_NUMBER(deviceIndex, "", SW_WITHIN(0.0, INT32_MAX), 0.0, .key = NULL, .label = "number of the device",
              .kinds = SW_KIND(SW_DEVICE_INDEX), .use = SW_USE_HERE),
    SW_GIVEN(instanceExtensions, .key = NULL, .label = "instance extensions"),
    SW_NUMBER(instanceExtensionCount, "", SW_WITHIN(0.0, UINT32_MAX), 0.0, .key = NULL,
              .label = "number of instance extensions", .use = SW_USE_HERE),
    SW_SWITCH(presentable, false, .key = NULL, .label = "presentable", .use = SW_USE_HERE),
    SW_SWITCH(enableValidation, false, .key = NULL, .label = "validation", .use = SW_USE_HERE),
    SW_NUMBER(framesInFlight, "", SW_WITHIN(1.0, SW_MAX_FRAMES_IN_FLIGHT), 2.0, .key = NULL,
              .label = "frames in flight", SW_KNOB(1.0, SW_MAX_FRAMES_IN_FLIGHT), .use = SW_USE_HERE),
    SW_CHOICE(layers, layerWords, layerWords, SW_LAYERS_AUTO, .key = NULL, .label = "layers from", .use = SW_USE_HERE),
    SW_GIVEN(pipelineCache, .key = NULL, .label = "pipeline cache"),
    SW_BYTES(pipelineCacheSize, SW_WITHIN(0.0, (double)SIZE_MAX), 0.0, .key = NULL, .label = "size of the cache",
             .use = SW_USE_HERE),
};
#undef SW_DEF

static const swFields gpuDefFields = SW_FIELDS(swGpuDef, NULL, "device", gpuFields, CHOICE_FIELD);

const swFields* swGetGpuFields(void)
{
    return &gpuDefFields;
}

swGpuDef swDefaultGpuDef(void)
{
    swGpuDef def;
    swFillDef(&gpuDefFields, &def);
    return def;
}

// ---- a query ----

static const char* const kindWords[] = {"surface", "volume", "rays", NULL};
static const char* const stretchingWords[] = {"wheeler", "linear", NULL};

#define SW_DEF swGpuQueryDef
static const swField queryFields[] = {
    SW_CHOICE(kind, kindWords, kindWords, SW_GPU_QUERY_KIND_SURFACE, .key = NULL, .label = "about", .use = SW_USE_HERE),
    SW_NUMBER(capacity, "", SW_WITHIN(1.0, 4194304.0), 1024.0, .key = NULL, .label = "most points", .use = SW_USE_HERE),
    SW_NUMBER(outputs, "", SW_WITHIN(0.0, 15.0), 0.0, .key = NULL, .label = "outputs", .use = SW_USE_HERE),
    SW_NUMBER(minWavelength, "m", SW_WITHIN(0.0, (double)INFINITY), 0.0, .key = NULL, .label = "shortest wave",
              .tip = "Shorter waves are left out", SW_KNOB(0.0, 64.0), .use = SW_USE_HERE),
    SW_NUMBER(tolerance, "m", SW_WITHIN(1e-5, 1e9), 0.0005, .key = NULL, .label = "tolerance",
              .tip = "Horizontal error at which a search ends", SW_LOG_KNOB(1e-5, 1.0), .use = SW_USE_HERE),
    SW_NUMBER(maxIterations, "", SW_WITHIN(1.0, 64.0), 24.0, .key = NULL, .label = "most iterations",
              SW_KNOB(1.0, 64.0), .use = SW_USE_HERE),
    SW_CHOICE(stretching, stretchingWords, stretchingWords, SW_STRETCHING_WHEELER, .key = NULL, .label = "stretching",
              .use = SW_USE_HERE),
    SW_SWITCH(readBack, true, .key = NULL, .label = "read back", .use = SW_USE_HERE),
};
#undef SW_DEF

static const swFields gpuQueryFields = SW_FIELDS(swGpuQueryDef, NULL, "query on the GPU", queryFields, -1);

const swFields* swGetGpuQueryFields(void)
{
    return &gpuQueryFields;
}

swGpuQueryDef swDefaultGpuQueryDef(void)
{
    swGpuQueryDef def;
    swFillDef(&gpuQueryFields, &def);
    return def;
}
