// SPDX-License-Identifier: MIT
#pragma once

#include "gpu.h"

/// @file
/// A sheet shows a layer of a view in false colours: all of its slices side by side, the finest first, or one of them.
/// For tools: it reads the layer back from the device, which waits. North is up, east is right. A part of the stage's
/// library, see stage.h.

/// What a sheet shows. Must be initialized with swDefaultSheetDef().
typedef struct swSheetDef
{
    swLayer layer; ///< default SW_LAYER_DISPLACEMENT
    int channel;   ///< which of the layer's numbers, see swLayer_GetChannelName(). Default 1, the height
    int slice;     ///< -1, the default: all of them

    /// The first and the last colour stand for `low` and `high`. Default false: for the least and the greatest number
    /// that the shown slices hold; of depths beyond 1 km only where nothing is shallower, because a floor that fades
    /// into none is as deep as one likes.
    bool hasRange;
    float low, high; ///< the lower first. Default 0 and 1

    int internalValue; ///< set by swDefaultSheetDef()
} swSheetDef;
SW_API swSheetDef swDefaultSheetDef(void);

/// Read a layer as users name it: NAME[.CHANNEL][:SLICE], such as "places.level" or "displacement.y:2". Without a
/// channel it is the first one, of the displacement the height. Only layer, channel and slice of `def` are set.
/// @param problem receives what is wrong, with the names that there are, as a part of a sentence; may be NULL
/// @return whether it names a layer
SW_API bool swParseSheet(const char* text, swSheetDef* def, char* problem, size_t size);

typedef struct swSheet swSheet;

/// What a sheet holds.
typedef struct swSheetInfo
{
    swSheetDef def; ///< as it was read
    int firstSlice, sliceCount;
    int resolution;        ///< texels along a slice's side
    float least, greatest; ///< of the channel in these slices; both NaN if it holds nothing
    float low, high;       ///< what the first and the last colour stand for
    int unknownCount;      ///< texels that hold nothing, such as the depth where there is no floor
} swSheetInfo;

/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY
SW_API swResult swCreateSheet(const swHost* host, swSheet** sheet);
/// NULL is allowed.
SW_API void swDestroySheet(swSheet* sheet);

/// Read the layer as the last recorded frame left it, whose commands must have been submitted. Memory is kept from one
/// call to the next.
/// @return SW_ERROR_INVALID (also if the view has no such slice: the log says how many it has), SW_ERROR_NO_MEMORY,
/// SW_ERROR_DEVICE
SW_API swResult swSheet_Read(swSheet* sheet, swGpuWorld* gpuWorld, const swView* view, const swSheetDef* def);
SW_API swSheetInfo swSheet_GetInfo(const swSheet* sheet);

/// Size of a picture in which each texel of `sliceCount` slices is a pixel, pixels.
SW_API void swFindSheetSize(int sliceCount, int resolution, int* width, int* height);

/// Draw the slices as large as they fit, and below them the colours from low to high. What holds nothing is grey.
/// @param rgba 4 bytes a pixel, rows from the top, sRGB
SW_API void swSheet_Draw(const swSheet* sheet, int width, int height, uint8_t* rgba);

/// The same with the numbers themselves, each three times; NaN where there is none.
/// @param rgb 3 floats a pixel
SW_API void swSheet_DrawValues(const swSheet* sheet, int width, int height, float* rgb);

/// What is at a pixel of such a picture.
typedef struct swSheetPick
{
    int slice, column, row; ///< texel of the slice, see swSliceInfo
    float value;            ///< NaN where it holds nothing
} swSheetPick;

/// @return false beside the slices
SW_API bool swSheet_Pick(const swSheet* sheet, int width, int height, int x, int y, swSheetPick* pick);
