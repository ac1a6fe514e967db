// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/misuse.h"
#include "core/world/world.h"

swResult swCreateView(swWorld* world, const swViewDef* def, swView** view)
{
    if (view != NULL)
    {
        *view = NULL;
    }
    SW_REQUIRE(world != NULL && view != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swCreateView() needs a world and a place for the view");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swCreateView() needs a def made by swDefaultViewDef()");
    swResult result = swCheckViewDef(&world->host, def, world->def.enableQueries);
    return result == SW_SUCCESS ? swAddView(world, def, view) : result;
}

void swDestroyView(swView* view)
{
    if (view != NULL)
    {
        swRemoveView(view);
    }
}

static const swHost* findViewHost(const swView* view)
{
    return view != NULL ? &view->world->host : NULL;
}

// Texel indices of the finest lattice must fit: far beyond any planet.
static bool isViewpoint(swPos position)
{
    return fabs(position.x) <= SW_FARTHEST_VIEWPOINT && fabs(position.y) <= SW_FARTHEST_VIEWPOINT &&
           fabs(position.z) <= SW_FARTHEST_VIEWPOINT;
}

void swView_SetViewpoint(swView* view, swPos position)
{
    SW_REQUIRE_VOID(view != NULL && isViewpoint(position), findViewHost(view),
                    "swView_SetViewpoint() was given (%g, %g, %g) m; a viewpoint must be within %g m of 0", position.x,
                    position.y, position.z, SW_FARTHEST_VIEWPOINT);
    swPosXZ origin = view->world->origin;
    view->viewpoint = (swPos){position.x + origin.x, position.y, position.z + origin.z};
}

swPos swView_GetViewpoint(const swView* view)
{
    SW_REQUIRE(view != NULL, (swPos){0}, NULL, "swView_GetViewpoint() needs a view");
    swPosXZ origin = view->world->origin;
    return (swPos){view->viewpoint.x - origin.x, view->viewpoint.y, view->viewpoint.z - origin.z};
}

int swView_GetSliceCount(const swView* view)
{
    SW_REQUIRE(view != NULL, 0, NULL, "swView_GetSliceCount() needs a view");
    return view->def.sliceCount;
}

static bool isSlice(const swView* view, int slice)
{
    return view != NULL && slice >= 0 && slice < view->def.sliceCount;
}

swSliceInfo swView_GetSlice(const swView* view, int slice)
{
    SW_REQUIRE(isSlice(view, slice), (swSliceInfo){0}, findViewHost(view),
               "a view was asked for its slice %d, which it does not have", slice);
    const swSlice* s = &view->layers.stack.slices[slice];
    return (swSliceInfo){
        .texel = s->texel,
        .firstX = s->firstX,
        .firstZ = s->firstZ,
        .resolution = view->def.resolution,
        .minWavelength = s->minWavelength,
        .fade = slice == 0 ? view->layers.stack.fade : 0.0f,
    };
}

static bool isLayer(swLayer layer)
{
    return (int)layer >= 0 && layer < SW_LAYER_COUNT;
}

const char* swLayer_GetName(swLayer layer)
{
    return isLayer(layer) ? swGetLayerInfo(layer)->name : NULL;
}

int swLayer_GetTexelSize(swLayer layer)
{
    return isLayer(layer) ? swCountChannels(swGetLayerInfo(layer)->format) : 0;
}

const char* swLayer_GetChannelName(swLayer layer, int channel)
{
    if (!isLayer(layer) || channel < 0 || channel >= swLayer_GetTexelSize(layer))
    {
        return NULL;
    }
    const swLayerInfo* info = swGetLayerInfo(layer);
    return info->channels[0] == NULL && channel == 0 ? "amount" : info->channels[channel];
}

static const float* findLayer(const swView* view, int slice, swLayer layer)
{
    SW_REQUIRE(isSlice(view, slice), NULL, findViewHost(view),
               "a view was asked for a layer of its slice %d, which it does not have", slice);
    const float* texels = swGetLayerTexels(&view->layers, layer);
    size_t side = (size_t)view->def.resolution;
    size_t channels = (size_t)swCountChannels(swGetLayerInfo(layer)->format);
    return texels != NULL ? texels + (size_t)slice * side * side * channels : NULL;
}

const float* swView_GetPlaces(const swView* view, int slice)
{
    return findLayer(view, slice, SW_LAYER_PLACES);
}

const float* swView_GetFlow(const swView* view, int slice)
{
    return findLayer(view, slice, SW_LAYER_FLOW);
}

const float* swView_GetFlowSlopes(const swView* view, int slice)
{
    return findLayer(view, slice, SW_LAYER_FLOW_SLOPES);
}

const float* swView_GetDisplacement(const swView* view, int slice)
{
    return findLayer(view, slice, SW_LAYER_DISPLACEMENT);
}

const float* swView_GetDerivatives(const swView* view, int slice)
{
    return findLayer(view, slice, SW_LAYER_DERIVATIVES);
}

const float* swView_GetFoam(const swView* view, int slice)
{
    return findLayer(view, slice, SW_LAYER_FOAM);
}

const float* swView_GetWakeFoam(const swView* view, int slice)
{
    return findLayer(view, slice, SW_LAYER_WAKE_FOAM);
}

const float* swView_GetShoreFoam(const swView* view, int slice)
{
    return findLayer(view, slice, SW_LAYER_SHORE_FOAM);
}
