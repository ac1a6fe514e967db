// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/assert.h"
#include "core/base/host.h"
#include "core/world/world.h"

swViewDef swDefaultViewDef(void)
{
    return (swViewDef){
        .sliceCount = 7,
        .resolution = 384,
        .finestTexel = 1.0f / 16.0f,
        .maxScaleLevel = 10,
        .internalValue = SW_DEF_COOKIE,
    };
}

static bool isPowerOfTwoTexel(float texel)
{
    int exponent;
    return texel >= 1.0f / 64.0f && texel <= 16.0f && frexpf(texel, &exponent) == 0.5f;
}

swResult swCheckViewDef(const swWorld* world, const swViewDef* def)
{
    const swHost* host = &world->host;
    if (def->sliceCount < 2 || def->sliceCount > SW_MAX_SLICES)
    {
        return swFail(host, SW_ERROR_INVALID, "a view's slice count is %d; it must be in [2, %d]", def->sliceCount,
                      SW_MAX_SLICES);
    }
    if (def->resolution < 64 || def->resolution > 1024 || def->resolution % 64 != 0)
    {
        return swFail(host, SW_ERROR_INVALID, "a view's resolution is %d; it must be a multiple of 64 in [64, 1024]",
                      def->resolution);
    }
    if (!isPowerOfTwoTexel(def->finestTexel))
    {
        return swFail(host, SW_ERROR_INVALID, "a view's finest texel is %g m; it must be a power of two in [1/64, 16]",
                      (double)def->finestTexel);
    }
    if (def->maxScaleLevel < 0 || def->maxScaleLevel > 16)
    {
        return swFail(host, SW_ERROR_INVALID, "a view's highest scale level is %d; it must be in [0, 16]",
                      def->maxScaleLevel);
    }
    if (def->enableCpuLayers && !world->def.enableQueries)
    {
        return swFail(host, SW_ERROR_INVALID, "a view asks for CPU layers in a world made without queries");
    }
    return SW_SUCCESS;
}

swResult swCreateView(swWorld* world, const swViewDef* def, swView** view)
{
    bool isValid = world != NULL && def != NULL && def->internalValue == SW_DEF_COOKIE && view != NULL;
    SW_ASSERT(isValid);
    if (!isValid)
    {
        return SW_ERROR_INVALID;
    }
    *view = NULL;
    swResult result = swCheckViewDef(world, def);
    return result == SW_SUCCESS ? swAddView(world, def, view) : result;
}

void swDestroyView(swView* view)
{
    if (view != NULL)
    {
        swRemoveView(view);
    }
}

void swView_SetViewpoint(swView* view, swPos position)
{
    // Texel indices of the finest lattice must fit: far beyond any planet.
    bool isValid = view != NULL && fabs(position.x) <= SW_FARTHEST_VIEWPOINT &&
                   fabs(position.y) <= SW_FARTHEST_VIEWPOINT && fabs(position.z) <= SW_FARTHEST_VIEWPOINT;
    SW_ASSERT(isValid);
    if (isValid)
    {
        swPosXZ origin = view->world->origin;
        view->viewpoint = (swPos){position.x + origin.x, position.y, position.z + origin.z};
    }
}

swPos swView_GetViewpoint(const swView* view)
{
    swPosXZ origin = view->world->origin;
    return (swPos){view->viewpoint.x - origin.x, view->viewpoint.y, view->viewpoint.z - origin.z};
}

int swView_GetSliceCount(const swView* view)
{
    return view->def.sliceCount;
}

static bool isSlice(const swView* view, int slice)
{
    return view != NULL && slice >= 0 && slice < view->def.sliceCount;
}

swSliceInfo swView_GetSlice(const swView* view, int slice)
{
    SW_ASSERT(isSlice(view, slice));
    if (!isSlice(view, slice))
    {
        return (swSliceInfo){0};
    }
    const swSlice* s = &view->stack.slices[slice];
    return (swSliceInfo){
        .texel = s->texel,
        .firstX = s->firstX,
        .firstZ = s->firstZ,
        .resolution = view->def.resolution,
        .minWavelength = s->minWavelength,
        .fade = slice == 0 ? view->stack.fade : 0.0f,
    };
}

static const float* findLayer(const swView* view, int slice, const float* layer, int channels)
{
    SW_ASSERT(isSlice(view, slice));
    if (!isSlice(view, slice) || layer == NULL)
    {
        return NULL;
    }
    size_t side = (size_t)view->def.resolution;
    return layer + (size_t)slice * side * side * (size_t)channels;
}

const float* swView_GetDisplacement(const swView* view, int slice)
{
    return findLayer(view, slice, view->displacement, 4);
}

const float* swView_GetDerivatives(const swView* view, int slice)
{
    return findLayer(view, slice, view->derivatives, 4);
}

const float* swView_GetFoam(const swView* view, int slice)
{
    return findLayer(view, slice, view->foam[view->foamIndex], 1);
}
