// SPDX-License-Identifier: MIT
// Signed distances in metres from solids in their own axes: below 0 inside. Sizes are half extents, above 0; `rounding`
// is the radius of edges. All are true distances: the nearest point of the surface is that far.
#ifndef SW_SHARED_SHAPE_SOLIDS_H
#define SW_SHARED_SHAPE_SOLIDS_H
#include "types.h"

#ifdef __STDC__
#include <math.h>
#define SW_SOLID_SQRT sqrtf
#else
#define SW_SOLID_SQRT sqrt
#endif

SW_FORMULA float swSolidMost(float a, float b)
{
    return a > b ? a : b;
}

SW_FORMULA float swSolidLeast(float a, float b)
{
    return a < b ? a : b;
}

SW_FORMULA float swSolidAway(float a)
{
    return a < SW_FLOAT(0.0) ? -a : a;
}

SW_FORMULA float swSolidLength(float x, float y, float z)
{
    return SW_SOLID_SQRT(x * x + y * y + z * z);
}

// From a corner that is built of distances along three perpendicular axes.
SW_FORMULA float swCornerDistance(float x, float y, float z)
{
    float outside =
        swSolidLength(swSolidMost(x, SW_FLOAT(0.0)), swSolidMost(y, SW_FLOAT(0.0)), swSolidMost(z, SW_FLOAT(0.0)));
    return outside + swSolidLeast(swSolidMost(swSolidMost(x, y), z), SW_FLOAT(0.0));
}

SW_FORMULA float swBoxDistance(float x, float y, float z, float halfX, float halfY, float halfZ, float rounding)
{
    float r = swSolidLeast(rounding, swSolidLeast(halfX, swSolidLeast(halfY, halfZ)));
    return swCornerDistance(swSolidAway(x) - (halfX - r), swSolidAway(y) - (halfY - r), swSolidAway(z) - (halfZ - r)) -
           r;
}

// The nearest point of an ellipsoid with half axes e to a point p is e^2 p / (s + e^2 - m^2), m the shortest half axis,
// for the one s > 0 that puts it on the ellipsoid; then the distance is (s - m^2) |p / (s + e^2 - m^2)|. s is found by
// Newton's method on 1 - 1 / |that point over e|, which is nearly straight and bends so that s comes from one side
// without a step too far, as in trust regions [Moré 1983]. Points nearer than a ten thousandth of an axis
// to a plane of symmetry are taken to be that far from it, where s would be on the edge of its range.
SW_FORMULA float swEllipsoidDistance(float x, float y, float z, float halfX, float halfY, float halfZ)
{
    float px = swSolidMost(swSolidAway(x), SW_FLOAT(1e-4) * halfX);
    float py = swSolidMost(swSolidAway(y), SW_FLOAT(1e-4) * halfY);
    float pz = swSolidMost(swSolidAway(z), SW_FLOAT(1e-4) * halfZ);
    float m = swSolidLeast(halfX, swSolidLeast(halfY, halfZ));
    float dx = (halfX - m) * (halfX + m);
    float dy = (halfY - m) * (halfY + m);
    float dz = (halfZ - m) * (halfZ + m);
    float s = swSolidMost(halfX * px - dx, swSolidMost(halfY * py - dy, halfZ * pz - dz));
    for (int i = 0; i < 8; ++i)
    {
        float overX = SW_FLOAT(1.0) / (s + dx), overY = SW_FLOAT(1.0) / (s + dy), overZ = SW_FLOAT(1.0) / (s + dz);
        float ax = halfX * px * overX, ay = halfY * py * overY, az = halfZ * pz * overZ;
        float square = ax * ax + ay * ay + az * az;
        float slope = ax * ax * overX + ay * ay * overY + az * az * overZ;
        s = s + (SW_SOLID_SQRT(square) - SW_FLOAT(1.0)) * square / slope;
    }
    return (s - m * m) * swSolidLength(px / (s + dx), py / (s + dy), pz / (s + dz));
}

// The same in a plane.
SW_FORMULA float swEllipseDistance(float x, float z, float halfX, float halfZ)
{
    if (halfX == halfZ)
    {
        return swSolidLength(x, SW_FLOAT(0.0), z) - halfX;
    }
    float px = swSolidMost(swSolidAway(x), SW_FLOAT(1e-4) * halfX);
    float pz = swSolidMost(swSolidAway(z), SW_FLOAT(1e-4) * halfZ);
    float m = swSolidLeast(halfX, halfZ);
    float dx = (halfX - m) * (halfX + m);
    float dz = (halfZ - m) * (halfZ + m);
    float s = swSolidMost(halfX * px - dx, halfZ * pz - dz);
    for (int i = 0; i < 8; ++i)
    {
        float overX = SW_FLOAT(1.0) / (s + dx), overZ = SW_FLOAT(1.0) / (s + dz);
        float ax = halfX * px * overX, az = halfZ * pz * overZ;
        float square = ax * ax + az * az;
        float slope = ax * ax * overX + az * az * overZ;
        s = s + (SW_SOLID_SQRT(square) - SW_FLOAT(1.0)) * square / slope;
    }
    return (s - m * m) * swSolidLength(px / (s + dx), SW_FLOAT(0.0), pz / (s + dz));
}

// Upright: its ends look up and down. An elliptic one with rounded edges is a thinner one that has grown by `rounding`.
SW_FORMULA float swCylinderDistance(float x, float y, float z, float halfX, float halfY, float halfZ, float rounding)
{
    float r = swSolidLeast(rounding, SW_FLOAT(0.999) * swSolidLeast(halfX, swSolidLeast(halfY, halfZ)));
    return swCornerDistance(swEllipseDistance(x, z, halfX - r, halfZ - r), swSolidAway(y) - (halfY - r),
                            SW_FLOAT(-1e30)) -
           r;
}

// Upright: `halfY` reaches to the tip of its round end.
SW_FORMULA float swCapsuleDistance(float x, float y, float z, float radius, float halfY)
{
    float beyond = swSolidMost(swSolidAway(y) - swSolidMost(halfY - radius, SW_FLOAT(0.0)), SW_FLOAT(0.0));
    return swSolidLength(x, beyond, z) - radius;
}

// What a vector of the sea's axes is in the axes of something that is turned by a quaternion.
SW_FORMULA sw_vec3 swTurnBack(sw_vec4 turn, float x, float y, float z)
{
    float cx = y * turn.z - z * turn.y, cy = z * turn.x - x * turn.z, cz = x * turn.y - y * turn.x;
    cx = cx + turn.w * x;
    cy = cy + turn.w * y;
    cz = cz + turn.w * z;
    sw_vec3 own;
    own.x = x + SW_FLOAT(2.0) * (cy * turn.z - cz * turn.y);
    own.y = y + SW_FLOAT(2.0) * (cz * turn.x - cx * turn.z);
    own.z = z + SW_FLOAT(2.0) * (cx * turn.y - cy * turn.x);
    return own;
}
#endif
