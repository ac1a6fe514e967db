// SPDX-License-Identifier: MIT
// The floor of a world as a raster.

#include <math.h>

#include "core/base/misuse.h"
#include "core/input/inputs_save.h"
#include "core/world/world.h"

#define ROW_POINTS 256

uint64_t swWorld_HashFloor(const swWorld* world, const swRasterDef* def)
{
    SW_REQUIRE(world != NULL && def != NULL && def->internalValue == SW_DEF_COOKIE, 0, swFindHost(world),
               "swWorld_HashFloor() needs a world and a def made by swDefaultRasterDef()");
    if (swCheckDef(&world->host, swGetRasterFields(), def) != SW_SUCCESS)
    {
        return 0;
    }
    swHash hash = swBeginHash();
    swAddHashDouble(&hash, world->def.seaLevel);
    swAddHash(&hash, (uint64_t)(uint32_t)def->width << 32 | (uint32_t)def->height);
    const double places[] = {def->x + world->origin.x, def->z + world->origin.z, def->spacingX, def->spacingZ};
    for (int i = 0; i < 4; ++i)
    {
        swAddHashDouble(&hash, places[i]);
    }
    swHashFieldInputs(&hash, &world->inputs, SW_INPUT_FLOOR);
    return swEndHash(&hash);
}

// A floor that is not there is not known.
static void bakeRow(const swWorld* world, const swRasterDef* def, int row, float* values)
{
    swPosXZ points[ROW_POINTS];
    for (int first = 0; first < def->width; first += ROW_POINTS)
    {
        int count = def->width - first < ROW_POINTS ? def->width - first : ROW_POINTS;
        for (int i = 0; i < count; ++i)
        {
            points[i] = (swPosXZ){def->x + def->spacingX * (first + i), def->z + def->spacingZ * row};
        }
        const swFieldSamples samples = {.floor = values + first};
        swMoment_QueryFields(swWorld_GetMoment(world), count, points, &samples);
    }
    for (int i = 0; i < def->width; ++i)
    {
        values[i] = fabsf(values[i]) <= 1e6f ? values[i] : (float)NAN;
    }
}

swResult swBakeFloor(const swWorld* world, const swRasterDef* def, swRaster** raster)
{
    if (raster != NULL)
    {
        *raster = NULL;
    }
    SW_REQUIRE(world != NULL && raster != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swBakeFloor() needs a world and a place for the raster");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swBakeFloor() needs a def made by swDefaultRasterDef()");
    swResult result = swCheckDef(&world->host, swGetRasterFields(), def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (def->channels != 1 || def->frames != 1)
    {
        return swFail(&world->host, SW_ERROR_INVALID, "a floor has one channel and one frame, not %d and %d",
                      def->channels, def->frames);
    }
    size_t size = (size_t)def->width * (size_t)def->height * sizeof(float);
    float* values = swAllocate(&world->host, size);
    if (values == NULL)
    {
        return swFail(&world->host, SW_ERROR_NO_MEMORY, "no memory for a floor of %d x %d cells", def->width,
                      def->height);
    }
    for (int row = 0; row < def->height; ++row)
    {
        bakeRow(world, def, row, values + (size_t)row * (size_t)def->width);
    }
    swRasterDef baked = *def;
    baked.values = values;
    result = swCreateRaster(&world->host, &baked, raster);
    swFree(&world->host, values, size);
    return result;
}
