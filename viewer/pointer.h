// SPDX-License-Identifier: MIT
#pragma once

// What is under the mouse: the water that a ray through its pixel meets, and what the sea's fields say there.

#include "camera.h"
#include "seaway/input.h"
#include "seaway/query.h"

typedef struct PointerWater
{
    bool isHit;
    swPos place;    // host coordinates
    swVec3 normal;  // of the surface
    float distance; // m from the eye
    float depth, level, clip;
    swVec2 flow;
    int body; // its number; -1: none
} PointerWater;

// Where a pixel looks: column and row in pixels of a picture of width x height.
swVec3 FindRay(const Camera* camera, double column, double row, double width, double height);

PointerWater FindWater(const swWorld* world, const Camera* camera, double column, double row, double width,
                       double height);
