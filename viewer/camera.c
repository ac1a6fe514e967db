// SPDX-License-Identifier: MIT
#include "camera.h"

#include <math.h>

#define CLEARANCE 0.3     // m between the eye and the water
#define MAX_PITCH 1.5533f // 89 degrees
#define MIN_DISTANCE 1.0  // of the orbit, m
#define MAX_DISTANCE 50e3

static swPos GetForward(const Camera* camera)
{
    double level = cos((double)camera->pitch);
    return (swPos){sin((double)camera->heading) * level, sin((double)camera->pitch),
                   -cos((double)camera->heading) * level};
}

static swPos AddScaled(swPos a, swPos b, double scale)
{
    return (swPos){a.x + b.x * scale, a.y + b.y * scale, a.z + b.z * scale};
}

Camera DefaultCamera(double seaLevel)
{
    return (Camera){
        .position = {0.0, seaLevel + 3.0, 0.0},
        .verticalFov = 0.96f, // 55 degrees
        .distance = 20.0,
        .speed = 1.0f,
    };
}

void PlaceCamera(Camera* camera, const swSceneView* view, double seaLevel)
{
    camera->mode = CAMERA_FLY;
    camera->position = (swPos){view->position.x, seaLevel + view->position.y, view->position.z};
    camera->heading = view->heading;
    camera->pitch = view->pitch;
    camera->roll = view->roll;
    camera->verticalFov = view->verticalFov;
    camera->lift = 0.0;
}

void ShiftCamera(Camera* camera, double x, double z)
{
    camera->position.x += x;
    camera->position.z += z;
    camera->target.x += x;
    camera->target.z += z;
}

void ToggleOrbit(Camera* camera, double seaLevel)
{
    if (camera->mode == CAMERA_ORBIT)
    {
        camera->mode = CAMERA_FLY;
        return;
    }
    swPos forward = GetForward(camera);
    double toSea = forward.y < -1e-3 ? (seaLevel - camera->position.y) / forward.y : 0.0;
    bool meetsSea = toSea > MIN_DISTANCE && toSea < MAX_DISTANCE;
    camera->distance = meetsSea ? toSea : fmax(20.0, 2.0 * (camera->position.y - seaLevel));
    camera->target = AddScaled(camera->position, forward, camera->distance);
    camera->mode = CAMERA_ORBIT;
    camera->roll = 0.0f;
}

// Flying covers about its own height above the water in a second, so that it is slow near and fast far.
static void Fly(Camera* camera, const CameraInput* input, double dt, double seaLevel)
{
    camera->speed = fminf(fmaxf(camera->speed * powf(1.2f, input->wheel), 0.05f), 50.0f);
    double height = fabs(camera->position.y - seaLevel);
    double metres = (3.0 + height) * (double)camera->speed * (input->isFast ? 6.0 : 1.0) * dt;
    swPos forward = GetForward(camera);
    swPos right = {cos((double)camera->heading), 0.0, sin((double)camera->heading)};
    swPos from = camera->position;
    camera->position = AddScaled(camera->position, forward, (double)input->forward * metres);
    camera->position = AddScaled(camera->position, right, (double)input->right * metres);
    camera->position.y += (double)input->up * metres;
    bool hasMoved = from.x != camera->position.x || from.y != camera->position.y || from.z != camera->position.z;
    if (hasMoved && camera->lift > 0.0)
    {
        camera->position.y += camera->lift; // go on from where the eye is, not from under the water
        camera->lift = 0.0;
    }
}

static void Orbit(Camera* camera, const CameraInput* input, double dt)
{
    double zoom = pow(0.85, (double)input->wheel) * exp(-(double)input->forward * dt * (input->isFast ? 3.0 : 1.0));
    camera->distance = fmin(fmax(camera->distance * zoom, MIN_DISTANCE), MAX_DISTANCE);
    camera->heading -= input->right * (float)dt;
    camera->target.y += (double)input->up * camera->distance * 0.5 * dt;
    camera->position = AddScaled(camera->target, GetForward(camera), -camera->distance);
}

void MoveCamera(Camera* camera, const CameraInput* input, double dt, double seaLevel)
{
    camera->heading = fmodf(camera->heading + input->turnRight, (float)(2.0 * SW_PI));
    camera->pitch = fminf(fmaxf(camera->pitch + input->turnUp, -MAX_PITCH), MAX_PITCH);
    if (camera->mode == CAMERA_ORBIT)
    {
        Orbit(camera, input, dt);
    }
    else
    {
        Fly(camera, input, dt, seaLevel);
    }
}

void KeepCameraDry(Camera* camera, double waterHeight)
{
    double lift = waterHeight + CLEARANCE - camera->position.y;
    camera->lift = camera->mayDive || lift < 0.0 ? 0.0 : lift;
}

swPos GetCameraEye(const Camera* camera)
{
    return (swPos){camera->position.x, camera->position.y + camera->lift, camera->position.z};
}

swCamera MakePictureCamera(const Camera* camera, uint32_t width, uint32_t height)
{
    return swMakeCamera(GetCameraEye(camera), camera->heading, camera->pitch, camera->roll, camera->verticalFov, width,
                        height);
}
