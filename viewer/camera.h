// SPDX-License-Identifier: MIT
#pragma once

// Two ways to look: fly freely, or orbit a point. Angles in radians; heading is clockwise from north (-z, east is +x).

#include <stdbool.h>

#include "seaway/draw.h"
#include "seaway/scene.h"

typedef enum CameraMode
{
    CAMERA_FLY,
    CAMERA_ORBIT
} CameraMode;

typedef struct Camera
{
    CameraMode mode;
    swPos position; // where the user put it; see GetCameraEye()
    float heading, pitch, roll;
    float verticalFov;
    swPos target; // of the orbit
    double distance;
    float speed;  // factor on flying, turned by the wheel
    bool mayDive; // let the camera sink under the water
    double lift;  // m that the water pushes it up now
} Camera;

// What the user holds down or moved since the last frame; all in [-1, 1] but the turns (radians) and the wheel
// (clicks).
typedef struct CameraInput
{
    float right, up, forward;
    float turnRight, turnUp;
    float wheel;
    bool isFast;
} CameraInput;

// Three metres over the water, looking north.
Camera DefaultCamera(double seaLevel);

void PlaceCamera(Camera* camera, const swSceneView* view, double seaLevel);

// The same place in coordinates whose origin lies elsewhere.
void ShiftCamera(Camera* camera, double x, double z);

// Switch between flying and orbiting without a jump: the orbit's centre is where the gaze meets the sea.
void ToggleOrbit(Camera* camera, double seaLevel);

void MoveCamera(Camera* camera, const CameraInput* input, double dt, double seaLevel);

// Keep the eye above the water, whose height under the camera is given.
void KeepCameraDry(Camera* camera, double waterHeight);

// Where the picture is taken from: the position, lifted by the water.
swPos GetCameraEye(const Camera* camera);

swCamera MakePictureCamera(const Camera* camera, uint32_t width, uint32_t height);
