// SPDX-License-Identifier: MIT
// Float values are kept to the bit: nothing is resampled, and sampling at the middle of a cell gives its value.

#include "core/input/raster.h"

#include <math.h>
#include <string.h>

#include "core/base/hash.h"
#include "core/base/misuse.h"
#include "shared/raster.h"

#define LARGEST_VALUE 1e6f
#define FARTHEST 1e9 // m, of a cell from the origin

static size_t countValues(const swRasterDef* def)
{
    return (size_t)def->width * (size_t)def->height * (size_t)def->channels * (size_t)def->frames;
}

// Each number is in its range; the far end has to be as near as the first cell.
static swResult checkShape(const swHost* host, const swRasterDef* def, const char* name)
{
    swResult result = swCheckDef(host, &swRasterFields, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    double east = def->x + def->spacingX * def->width, south = def->z + def->spacingZ * def->height;
    if (east > FARTHEST || south > FARTHEST)
    {
        return swFail(host, SW_ERROR_INVALID, "%s reaches to (%g, %g) m; a raster lies within %g m of the origin.",
                      name, east, south, FARTHEST);
    }
    if (countValues(def) > SW_MAX_RASTER_VALUES)
    {
        return swFail(host, SW_ERROR_INVALID, "%s has %zu values; a raster has at most %zu.", name, countValues(def),
                      (size_t)SW_MAX_RASTER_VALUES);
    }
    return SW_SUCCESS;
}

// Infinity and values beyond the largest are no data, not even unknown data.
static swResult checkValues(const swHost* host, const swRasterDef* def, const char* name)
{
    size_t count = countValues(def);
    for (size_t i = 0; i < count; ++i)
    {
        float value = def->values[i];
        if (fabsf(value) > LARGEST_VALUE)
        {
            size_t cell = i / (size_t)def->channels;
            return swFail(host, SW_ERROR_INVALID,
                          "%s has %g in column %zu, row %zu, both counted from 0; values are at most %g, NaN where "
                          "nothing is known.",
                          name, (double)value, cell % (size_t)def->width,
                          cell / (size_t)def->width % (size_t)def->height, (double)LARGEST_VALUE);
        }
    }
    return SW_SUCCESS;
}

static void measure(swRaster* raster)
{
    size_t count = (size_t)raster->width * (size_t)raster->height * (size_t)raster->channels * (size_t)raster->frames;
    raster->least = raster->most = NAN;
    for (size_t i = 0; i < count; ++i)
    {
        float value = raster->values[i];
        if (isnan(value))
        {
            raster->values[i] = NAN; // one NaN, so that the hash knows no other
            raster->unknownCount += 1;
            continue;
        }
        raster->least = value >= raster->least ? raster->least : value;
        raster->most = value <= raster->most ? raster->most : value;
    }
    swHash hash = swBeginHash();
    swAddHash(&hash, (uint64_t)raster->width << 32 | (uint64_t)raster->height);
    swAddHashDouble(&hash, raster->x);
    swAddHashDouble(&hash, raster->z);
    swAddHashDouble(&hash, raster->spacingX);
    swAddHashDouble(&hash, raster->spacingZ);
    if (raster->channels > 1 || raster->frames > 1)
    {
        swAddHash(&hash, (uint64_t)raster->channels << 32 | (uint64_t)raster->frames);
    }
    swAddHashFloats(&hash, raster->values, count);
    raster->hash = swEndHash(&hash);
}

swResult swCreateRaster(const swHost* host, const swRasterDef* def, swRaster** raster)
{
    SW_REQUIRE_PLACE(host, raster, "swCreateRaster()");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE && def->values != NULL, SW_ERROR_INVALID, host,
               "swCreateRaster() needs a def made by swDefaultRasterDef(), and values");
    const char* name = def->name != NULL ? def->name : "raster";
    swResult result = checkShape(host, def, name);
    result = result != SW_SUCCESS ? result : checkValues(host, def, name);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    size_t head = (sizeof(swRaster) + 63) & ~(size_t)63;
    size_t size = countValues(def) * sizeof(float);
    swRaster* made = swAllocate(host, head + size);
    if (made == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for %s, %zu bytes.", name, head + size);
    }
    *made = (swRaster){.host = *host,
                       .width = def->width,
                       .height = def->height,
                       .x = def->x,
                       .z = def->z,
                       .spacingX = def->spacingX,
                       .spacingZ = def->spacingZ,
                       .channels = def->channels,
                       .frames = def->frames,
                       .references = 1,
                       .memory = head + size,
                       .values = (float*)((char*)made + head)};
    strncpy(made->name, name, sizeof(made->name) - 1);
    memcpy(made->values, def->values, size);
    measure(made);
    *raster = made;
    return SW_SUCCESS;
}

void swRetainRaster(const swRaster* raster)
{
    if (raster != NULL)
    {
        atomic_fetch_add(&((swRaster*)raster)->references, 1);
    }
}

void swReleaseRaster(const swRaster* raster)
{
    if (raster != NULL && atomic_fetch_sub(&((swRaster*)raster)->references, 1) == 1)
    {
        swHost host = raster->host;
        swFree(&host, (void*)raster, raster->memory);
    }
}

void swDestroyRaster(swRaster* raster)
{
    swReleaseRaster(raster);
}

swRasterInfo swRaster_GetInfo(const swRaster* raster)
{
    SW_REQUIRE(raster != NULL, ((swRasterInfo){.name = "", .least = NAN, .most = NAN}), NULL,
               "swRaster_GetInfo() needs a raster");
    return (swRasterInfo){raster->name,     raster->width,    raster->height,   raster->x,     raster->z,
                          raster->spacingX, raster->spacingZ, raster->least,    raster->most,  raster->unknownCount,
                          raster->memory,   raster->hash,     raster->channels, raster->frames};
}

const float* swRaster_GetValues(const swRaster* raster)
{
    SW_REQUIRE(raster != NULL, NULL, NULL, "swRaster_GetValues() needs a raster");
    return raster->values;
}

// The cell at or below a place along an axis, and how far it is to the next. False outside.
static bool findCell(double place, double first, double spacing, int count, int* cell, float* part)
{
    double at = (place - first) / spacing;
    if (!(at >= 0.0 && at <= (double)(count - 1)))
    {
        return false;
    }
    int low = (int)at;
    *cell = low;
    *part = (float)(at - (double)low);
    return true;
}

float swSampleRaster(const swRaster* raster, double x, double z)
{
    int column = 0, row = 0;
    float east = 0.0f, south = 0.0f;
    if (!findCell(x, raster->x, raster->spacingX, raster->width, &column, &east) ||
        !findCell(z, raster->z, raster->spacingZ, raster->height, &row, &south))
    {
        return NAN;
    }
    size_t channels = (size_t)raster->channels;
    const float* north = raster->values + ((size_t)row * (size_t)raster->width + (size_t)column) * channels;
    const float* southern = south > 0.0f ? north + (size_t)raster->width * channels : north;
    size_t next = east > 0.0f ? channels : 0;
    return swMixFourCells(north[0], north[next], southern[0], southern[next], east, south);
}

void swRaster_Sample(const swRaster* raster, int count, const swPosXZ* points, float* values)
{
    SW_REQUIRE_VOID(raster != NULL && count >= 0 && (count == 0 || (points != NULL && values != NULL)),
                    raster != NULL ? &raster->host : NULL,
                    "swRaster_Sample() needs a raster, points and a place for their values");
    for (int i = 0; i < count; ++i)
    {
        values[i] = swSampleRaster(raster, points[i].x, points[i].z);
    }
}
