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

typedef enum Layer
{
    LAYER_DISPLACEMENT,
    LAYER_DERIVATIVES,
    LAYER_FOAM
} Layer;

static const float* getLayer(const swView* view, Layer layer)
{
    switch (layer)
    {
    case LAYER_DISPLACEMENT:
        return view->displacement;
    case LAYER_DERIVATIVES:
        return view->derivatives;
    default:
        return view->foam[view->foamIndex];
    }
}

static const float* findLayer(const swView* view, int slice, Layer which, int channels)
{
    SW_REQUIRE(isSlice(view, slice), NULL, findViewHost(view),
               "a view was asked for a layer of its slice %d, which it does not have", slice);
    const float* layer = getLayer(view, which);
    if (layer == NULL)
    {
        return NULL;
    }
    size_t side = (size_t)view->def.resolution;
    return layer + (size_t)slice * side * side * (size_t)channels;
}

const float* swView_GetDisplacement(const swView* view, int slice)
{
    return findLayer(view, slice, LAYER_DISPLACEMENT, 4);
}

const float* swView_GetDerivatives(const swView* view, int slice)
{
    return findLayer(view, slice, LAYER_DERIVATIVES, 4);
}

const float* swView_GetFoam(const swView* view, int slice)
{
    return findLayer(view, slice, LAYER_FOAM, 1);
}
