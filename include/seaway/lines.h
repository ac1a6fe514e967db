// SPDX-License-Identifier: MIT
#pragma once

#include "input.h"
#include "stage.h"

/// @file
/// Lines over a finished picture, hidden by what stands before them in the scene; and what they are for: seeing what
/// queries, inputs and the mesh are. A part of the stage's library, see stage.h. One thread at a time.

/// Lines that a swStageLines holds; what is added beyond is left out.
#define SW_MAX_STAGE_LINES 65536

typedef struct swStageLines swStageLines;

/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swStage_CreateLines(swStage* stage, swStageLines** lines);
/// The device must be done with it. NULL is allowed.
SW_API void swStage_DestroyLines(swStage* stage, swStageLines* lines);

SW_API void swStageLines_Clear(swStageLines* lines);

/// A line between two places in the host's coordinates. `color` is sRGB, each from 0 to 1.
SW_API void swStageLines_Add(swStageLines* lines, swPos from, swPos to, swVec3 color);
SW_API int swStageLines_GetCount(const swStageLines* lines);

/// After swStage_DrawPicture(), with the camera of its shot: draws them over the targets' output, faintly where the
/// scene hides them. Leaves output in SW_STAGE_USE_COLOR_TARGET.
SW_API void swStage_DrawLines(swStage* stage, VkCommandBuffer commands, swStageLines* lines,
                              const swStageTargets* targets, const swCamera* camera);

/// @name What can be seen by lines
/// @{

/// The surface as queries answer it: crosses on a square of count x count points about a place, `step` m apart, and the
/// normal at each. Range of the count [1, 128].
SW_API void swStageLines_AddQueries(swStageLines* lines, const swMoment* moment, swPosXZ middle, float step, int count);

/// A ray: green up to where it meets the water, and a cross there; red without a hit.
SW_API void swStageLines_AddRay(swStageLines* lines, const swMoment* moment, swPos from, swVec3 direction, float reach);

/// The bounds of the tiles of the surface's mesh, as the picture was prepared last; each slice has a colour.
SW_API void swStageLines_AddTiles(swStageLines* lines, const swPicture* picture, const swMoment* moment);

/// The outlines of a world's inputs and bodies of water, on the water or the floor, each field in a colour of its own:
/// see swGetInputColor(). Inputs that are everywhere have none.
SW_API void swStageLines_AddInputs(swStageLines* lines, const swWorld* world);
/// @}

/// What is seen by lines around what a camera looks at; the bits can be added.
typedef enum swStageMarks
{
    SW_MARKS_QUERIES = 1, ///< 17 x 17 queries about it
    SW_MARKS_RAY = 2,     ///< a ray to it, from beside the camera
    SW_MARKS_TILES = 4,
    SW_MARKS_INPUTS = 8
} swStageMarks;

/// Marks as users name them: "queries", "ray", "tiles", "inputs", with commas between. False for anything else.
SW_API bool swParseStageMarks(const char* text, uint32_t* marks);

/// The marks of a world in a prepared picture.
SW_API void swStageLines_AddMarks(swStageLines* lines, const swWorld* world, const swPicture* picture,
                                  const swCamera* camera, uint32_t marks);

/// The colour of a field's outlines: floor brown, level green, flow blue, waves yellow, displacement violet, clip cyan,
/// foam white, albedo magenta, wind orange, shadow black, body red.
SW_API swVec3 swGetInputColor(swInputField field);
