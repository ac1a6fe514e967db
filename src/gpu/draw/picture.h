// SPDX-License-Identifier: MIT
#pragma once

// One picture's numbers for the shaders, and what the stages of drawing share.

#include "gpu/draw/mesh_rings.h"
#include "gpu/pass/passes.h"
#include "seaway/draw.h"
#include "seaway/water_body.h"
#include "shared/picture.h"

typedef struct swPictureFrame
{
    swPictureParams params;
    swMeshRings rings;
    swDetailParams bands[SW_MAX_TILES];
    swDetailWave waves[SW_MAX_FREE_WAVES];
    swMeshBody bodies[SW_MAX_WATER_BODIES];
    swPictureLook looks[SW_MAX_BODY_WATERS + 1];
    uint32_t lookCount;
    swUpload paramsUpload;
    swUpload slicesUpload;
    swUpload tilesUpload;
    swUpload bandsUpload;
    swUpload wavesUpload;
    swUpload bodiesUpload;
    swUpload looksUpload;
} swPictureFrame;

// Fill everything but the uploads. The camera's place is in the host's coordinates, which begin at `origin` in the sea:
// the same place of the sea gives the same numbers, wherever that is. `detailSide` is the width of the detail layers.
void swBuildPicture(const swShot* shot, swPosXZ origin, const swFrame* frame, const swViewFrame* view,
                    uint32_t detailSide, swPictureFrame* built);

// After swBeginGpuFrame().
swResult swUploadPicture(swGpu* gpu, swPictureFrame* built);
