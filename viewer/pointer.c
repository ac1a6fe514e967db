// SPDX-License-Identifier: MIT
#include "pointer.h"

#include <math.h>

#define FARTHEST 20000.0f // m; the waves that count grow with the distance

swVec3 FindRay(const Camera* camera, double column, double row, double width, double height)
{
    swCamera made = MakePictureCamera(camera, (uint32_t)width, (uint32_t)height);
    double up = tan(0.5 * (double)camera->verticalFov), right = up * width / height;
    double x = (2.0 * column / width - 1.0) * right, y = (1.0 - 2.0 * row / height) * up;
    const float* m = made.view.m; // columns; rows of its rotation are the camera's axes
    return (swVec3){(float)(x * (double)m[0] + y * (double)m[1] - (double)m[2]),
                    (float)(x * (double)m[4] + y * (double)m[5] - (double)m[6]),
                    (float)(x * (double)m[8] + y * (double)m[9] - (double)m[10])};
}

PointerWater FindWater(const swWorld* world, const Camera* camera, double column, double row, double width,
                       double height)
{
    PointerWater water = {.body = -1};
    swPos eye = GetCameraEye(camera);
    swRay ray = swDefaultRay(eye, FindRay(camera, column, row, width, height));
    swQueryDef def = swDefaultQueryDef();
    ray.maxDistance = FARTHEST;
    def.minWavelength = (float)fmax(0.01 * fabs(eye.y - swWorld_GetSeaLevel(world)), 0.5);
    swRayHit hit;
    const swMoment* moment = swWorld_GetMoment(world);
    swMoment_CastRays(moment, &def, 1, &ray, &hit, NULL);
    if (!hit.isHit)
    {
        return water;
    }
    swPosXZ place = {hit.point.x, hit.point.z};
    const swFieldSamples samples = {
        .depth = &water.depth, .level = &water.level, .flow = &water.flow, .clip = &water.clip, .body = &water.body};
    swMoment_QueryFields(moment, 1, &place, &samples);
    water.isHit = true;
    water.place = hit.point;
    water.normal = hit.normal;
    water.distance = hit.distance;
    return water;
}
