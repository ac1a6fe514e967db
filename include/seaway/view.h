// SPDX-License-Identifier: MIT
#pragma once

#include "world.h"

/// @file
/// A view is a viewpoint with a stack of slices around it: square grids of the surface, each twice as wide as the one
/// before. Only drawing and layers need views; queries do not.

#define SW_MAX_SLICES 15

/// Must be initialized with swDefaultViewDef().
typedef struct swViewDef
{
    /// Range [2, SW_MAX_SLICES]. Default 7.
    int sliceCount;

    /// Texels along a slice's side. A multiple of 64. Range [64, 1024]. Default 384.
    int resolution;

    /// Texel width of the finest slice when the viewer is near the water, m. A power of two. Range [2^-6, 16].
    /// Default 1/16.
    float finestTexel;

    /// How many times the stack may double with height. Range [0, 16]. Default 10.
    int maxScaleLevel;

    /// Compute the slices' layers on the CPU too, for tests and servers that need them. Default false.
    bool enableCpuLayers;

    /// Set by swDefaultViewDef().
    int internalValue;
} swViewDef;

SW_API swViewDef swDefaultViewDef(void);

/// An opaque view of one world.
typedef struct swView swView;

/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY
SW_API swResult swCreateView(swWorld* world, const swViewDef* def, swView** view);

/// NULL is allowed.
SW_API void swDestroyView(swView* view);

/// Move the viewpoint. Slices follow with the next step, snapped to whole texels; the stack's scale follows the height
/// above sea level by powers of two, with hysteresis and a fade that hides the change.
SW_API void swView_SetViewpoint(swView* view, swPos position);
SW_API swPos swView_GetViewpoint(const swView* view);

/// One slice as the last step left it. Texel (column, row) rests at ((firstX + column) * texel, (firstZ + row) * texel)
/// in the sea; less swWorld_GetOrigin() that is a place in the host's coordinates.
typedef struct swSliceInfo
{
    double texel;           ///< m
    int64_t firstX, firstZ; ///< index of the first texel on the world's lattice of that texel width
    int resolution;         ///< texels along the side
    float minWavelength;    ///< shortest band it carries, m
    float fade;             ///< 0: shown; 1: faded into the next slice (finest slice only)
} swSliceInfo;

/// Quantities on a view's slices.
typedef enum swLayer
{
    SW_LAYER_PLACES,       ///< 4 floats a texel: depth of still water, m, its slopes along x and z, its level, m
    SW_LAYER_FLOW,         ///< 4 floats a texel: velocity of the water along x and z, m/s, 0, 0
    SW_LAYER_FLOW_SLOPES,  ///< 4 floats a texel: of the velocity along x by x and z, of that along z by x and z, 1/s
    SW_LAYER_DISPLACEMENT, ///< 4 floats a texel: x, y, z, 0
    SW_LAYER_DERIVATIVES,  ///< 4 floats a texel: gx, gz, J, 0, see swView_GetDerivatives()
    SW_LAYER_FOAM,         ///< 1 float a texel
    SW_LAYER_WAKE_FOAM,    ///< 1 float a texel: foam of inputs and wakes
    SW_LAYER_SHORE_FOAM,   ///< 1 float a texel: foam of shores
    SW_LAYER_COUNT
} swLayer;

/// The layer's name, such as "wake_foam"; NULL beyond the last.
SW_API const char* swLayer_GetName(swLayer layer);

/// Floats a texel, 1 or 4, as swGpuWorld_ReadLayer() gives them.
SW_API int swLayer_GetTexelSize(swLayer layer);

/// The name of a number of the layer, from 0 on, such as "depth"; NULL beyond the last that means something.
SW_API const char* swLayer_GetChannelName(swLayer layer, int channel);

SW_API int swView_GetSliceCount(const swView* view);
SW_API swSliceInfo swView_GetSlice(const swView* view, int slice);

/// CPU layers of a slice as [resolution][resolution] rows of z; NULL unless enableCpuLayers.
/// Displacement: 4 floats a texel (x, y, z, 0). Foam: 1 float a texel, [0, 1]: of whitecaps; that of inputs and wakes,
/// and that of shores, have lives and layers of their own, which are NULL also while nothing makes such foam.
/// Derivatives: 4 floats (gx, gz, J, 0), the unnormalised normal of the displaced surface: J is the determinant of the
/// horizontal Jacobian, (-gx, J, -gz) points along the normal, and (gx, gz) / J is the slope. Smooth also where it
/// folds.
/// Places: 4 floats a texel where it rests: the depth of still water, m (1e30 without a floor, below 0 on land), its
/// slopes along x and z, and its level above sea level, m. NULL also where no input says anything of floor or level.
/// Flow: 4 floats a texel where it rests: the velocity of the water along x and z, m/s, 0, 0; its slopes: that of x
/// along x and z, then that of z, 1/s. NULL also where no input says anything of flow.
SW_API const float* swView_GetPlaces(const swView* view, int slice);
SW_API const float* swView_GetFlow(const swView* view, int slice);
SW_API const float* swView_GetFlowSlopes(const swView* view, int slice);
SW_API const float* swView_GetDisplacement(const swView* view, int slice);
SW_API const float* swView_GetDerivatives(const swView* view, int slice);
SW_API const float* swView_GetFoam(const swView* view, int slice);
SW_API const float* swView_GetWakeFoam(const swView* view, int slice);
SW_API const float* swView_GetShoreFoam(const swView* view, int slice);
