// SPDX-License-Identifier: MIT
#pragma once

// Pictures of a world without a window: an own device, an HDR and a depth image, and the way back to the host.
// Frames run one after the other: record, submit, wait. Two records of a sea's frame never overlap.

#include <stdbool.h>
#include <stdint.h>

#include "seaway/draw.h"
#include "seaway/sheet.h"

typedef struct PictureMaker PictureMaker;

typedef struct PictureMakerDef
{
    swDeviceChoice device;
    int deviceIndex;
    int width, height; // of the finished picture
    int supersample;   // each pixel is the mean of supersample^2 rendered ones
    bool enableValidation;
} PictureMakerDef;

// Complains and returns NULL if there is no device, no memory, or the picture is larger than the device can draw.
PictureMaker* CreatePictureMaker(const swHost* host, const PictureMakerDef* def);

// A view whose slices suit the device and the picture; see swGpu_FitView().
swViewDef FitPictureView(const PictureMaker* maker, const swViewDef* def);

// Take up a world, which must outlive the maker. Once, before any picture.
bool ShowWorld(PictureMaker* maker, const swWorld* world);

// Run the passes of the world's last step and draw nothing: how foam gathers before the first picture. Where the core
// makes the layers, foam has gathered with the step already.
bool AdvancePicture(PictureMaker* maker);

// Lines over the pictures that are made from now on: bits of swStageMarks. False after a sentence.
bool SetPictureMarks(PictureMaker* maker, uint32_t marks);

// The sea floor is another now: pictures show it from the next one on.
void ForgetPictureLand(PictureMaker* maker);

// Run the passes of the world's last step and draw. `dt` is the time since the last picture, for exposure;
// `isFirst` jumps to the measured exposure.
bool MakePicture(PictureMaker* maker, const swShot* shot, float dt, bool isFirst);

// Run the passes of the world's last step and read a layer of them, instead of drawing.
bool MakeSheet(PictureMaker* maker, const swView* view, const swSheetDef* def, swSheet* sheet);

// Room for width * height * 3. Bytes are tone mapped and sRGB encoded; floats are linear light before tone mapping.
void ReadPictureBytes(const PictureMaker* maker, uint8_t* rgb);
void ReadPictureFloats(const PictureMaker* maker, float* rgb);

const swGpu* GetPictureGpu(const PictureMaker* maker);
size_t GetPictureMemory(const PictureMaker* maker);

// Returns the number of messages that the validation layers gave. NULL is allowed.
int DestroyPictureMaker(PictureMaker* maker);
