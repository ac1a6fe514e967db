// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Plain types. World space: metres, y up, right-handed; north is -z, east is +x. Positions in a world are double.

typedef struct swVec2
{
    float x, y;
} swVec2;

typedef struct swVec3
{
    float x, y, z;
} swVec3;

typedef struct swVec4
{
    float x, y, z, w;
} swVec4;

/// A position in the world, metres.
typedef struct swPos
{
    double x, y, z;
} swPos;

/// A point of the horizontal plane, metres.
typedef struct swPosXZ
{
    double x, z;
} swPosXZ;

/// How something is turned, radians: yaw first, from +x towards +z, then pitch about its own z axis (which lifts its x
/// axis, a ship's bow), then roll about its own x axis (which lowers its z axis, the starboard side).
typedef struct swAngles
{
    float yaw, pitch, roll;
} swAngles;

/// A column-major matrix: m[4 * column + row].
typedef struct swMat4
{
    float m[16];
} swMat4;

#define SW_PI 3.14159265358979323846

/// Farthest that a time of a world may be from 0, s: 8,500 years either way.
#define SW_LARGEST_TIME 2.7e11

/// Bearing (degrees clockwise from north) that waves come from, to the direction they go: radians in the x-z plane,
/// measured from +x towards +z, so that the wave travels along (cos, sin) = (x, z).
#define SW_DIRECTION_FROM_BEARING(fromDegrees) ((float)(((fromDegrees) + 90.0) * (SW_PI / 180.0)))
