// SPDX-License-Identifier: MIT
// Nests of rasters: the finest that knows a place counts.

#include "core/base/misuse.h"
#include "core/world/world.h"

// Feathers of this many cells of the coarser raster are wide enough for its bends.
#define FEATHER_CELLS 3.0

static double getSpacing(const swRaster* raster)
{
    swRasterInfo info = swRaster_GetInfo(raster);
    return info.spacingX > info.spacingZ ? info.spacingX : info.spacingZ;
}

static double getShorterSide(const swRaster* raster)
{
    swRasterInfo info = swRaster_GetInfo(raster);
    double width = info.spacingX * (info.width - 1), height = info.spacingZ * (info.height - 1);
    return width < height ? width : height;
}

// Indices of the rasters, the coarsest first; equal ones as they come.
static void sortRasters(int count, const swRaster* const* rasters, int* sorted)
{
    for (int i = 0; i < count; ++i)
    {
        int at = i;
        while (at > 0 && getSpacing(rasters[sorted[at - 1]]) < getSpacing(rasters[i]))
        {
            sorted[at] = sorted[at - 1];
            at -= 1;
        }
        sorted[at] = i;
    }
}

// `coarser` is the spacing of the one below, 0 if there is none.
static float findFeather(const swInputDef* def, const swRaster* raster, double coarser)
{
    double side = getShorterSide(raster);
    if (coarser <= 0.0)
    {
        return def->feather > 0.0f ? def->feather : (float)(side / 16.0);
    }
    double feather = FEATHER_CELLS * coarser;
    return (float)(feather < 0.25 * side ? feather : 0.25 * side);
}

static swResult createAll(swWorld* world, const swInputDef* def, int count, const swRaster* const* rasters,
                          swInputId* ids)
{
    int sorted[SW_MAX_NEST];
    sortRasters(count, rasters, sorted);
    double coarser = 0.0, spacing = 0.0;
    for (int rank = 0; rank < count; ++rank)
    {
        const swRaster* raster = rasters[sorted[rank]];
        double own = getSpacing(raster);
        coarser = own < spacing ? spacing : coarser; // siblings have the same parent
        spacing = own;
        swInputDef level = *def;
        level.shape = SW_SHAPE_RASTER;
        level.blend = SW_BLEND_ALPHA;
        level.raster = raster;
        level.order = def->order + rank;
        level.feather = findFeather(def, raster, coarser);
        swResult result = swCreateInput(world, &level, &ids[sorted[rank]]);
        if (result != SW_SUCCESS)
        {
            for (int made = 0; made < rank; ++made)
            {
                swDestroyInput(world, ids[sorted[made]]);
                ids[sorted[made]] = (swInputId){0, 0};
            }
            return result;
        }
    }
    return SW_SUCCESS;
}

swResult swCreateNest(swWorld* world, const swInputDef* def, int count, const swRaster* const* rasters, swInputId* ids)
{
    SW_REQUIRE(world != NULL && rasters != NULL && ids != NULL && count >= 1 && count <= SW_MAX_NEST, SW_ERROR_INVALID,
               swFindHost(world), "swCreateNest() needs a world, 1 to %d rasters, and a place for as many handles",
               SW_MAX_NEST);
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swCreateNest() needs a def made by swDefaultInputDef()");
    for (int i = 0; i < count; ++i)
    {
        ids[i] = (swInputId){0, 0};
        SW_REQUIRE(rasters[i] != NULL, SW_ERROR_INVALID, &world->host, "swCreateNest() was given no raster at %d", i);
    }
    return createAll(world, def, count, rasters, ids);
}
