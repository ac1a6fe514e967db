// SPDX-License-Identifier: MIT
// By cutting ears: a corner whose triangle with its neighbours lies inside of the face and holds no other corner.

#include "files/polygon_ears.h"

#include <math.h>
#include <stddef.h>

typedef struct Face
{
    double x[SW_MAX_FACE_CORNERS], y[SW_MAX_FACE_CORNERS]; // in its plane, counterclockwise
    int left[SW_MAX_FACE_CORNERS];                         // corners that are not cut yet, in order
    int count;
} Face;

// How choosy a cut is: none of another corner may be on the ear, or on its edges either.
typedef enum Care
{
    CARE_STRICT, // the corner is convex
    CARE_LOOSE,  // the corner may be straight, others may touch the ear
    CARE_NONE
} Care;

static double cross(const Face* face, int a, int b, int c)
{
    return (face->x[b] - face->x[a]) * (face->y[c] - face->y[a]) -
           (face->y[b] - face->y[a]) * (face->x[c] - face->x[a]);
}

static bool isSamePlace(const Face* face, int a, int b)
{
    return face->x[a] == face->x[b] && face->y[a] == face->y[b];
}

static bool isEar(const Face* face, int at, Care care)
{
    int a = face->left[(at + face->count - 1) % face->count], b = face->left[at];
    int c = face->left[(at + 1) % face->count];
    double area = cross(face, a, b, c);
    if (care == CARE_NONE || !(area > 0.0))
    {
        return care == CARE_NONE || (care == CARE_LOOSE && area == 0.0);
    }
    for (int i = 0; i < face->count; ++i)
    {
        int p = face->left[i];
        if (isSamePlace(face, p, a) || isSamePlace(face, p, b) || isSamePlace(face, p, c))
        {
            continue;
        }
        double u = cross(face, a, b, p), v = cross(face, b, c, p), w = cross(face, c, a, p);
        bool isIn = care == CARE_STRICT ? u >= 0.0 && v >= 0.0 && w >= 0.0 : u > 0.0 && v > 0.0 && w > 0.0;
        if (isIn)
        {
            return false;
        }
    }
    return true;
}

// Onto the coordinate plane that the face is most parallel to. False without a plane.
static bool flatten(Face* face, int count, const swVec3* corners)
{
    double n[3] = {0.0, 0.0, 0.0}; // Newell's normal
    for (int i = 0; i < count; ++i)
    {
        swVec3 a = corners[i], b = corners[(i + 1) % count];
        n[0] += ((double)a.y - (double)b.y) * ((double)a.z + (double)b.z);
        n[1] += ((double)a.z - (double)b.z) * ((double)a.x + (double)b.x);
        n[2] += ((double)a.x - (double)b.x) * ((double)a.y + (double)b.y);
    }
    int axis = fabs(n[0]) > fabs(n[1]) ? 0 : 1;
    axis = fabs(n[2]) > fabs(n[axis]) ? 2 : axis;
    double side = n[axis] < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < count; ++i)
    {
        const double place[3] = {(double)corners[i].x, (double)corners[i].y, (double)corners[i].z};
        face->x[i] = place[(axis + 1) % 3];
        face->y[i] = side * place[(axis + 2) % 3];
        face->left[i] = i;
    }
    face->count = count;
    return n[axis] != 0.0;
}

// Looks on from where the last ear was, so that ears do not all meet at one corner.
static int findEar(const Face* face, int from, Care* care)
{
    for (*care = CARE_STRICT; *care < CARE_NONE; *care = (Care)(*care + 1))
    {
        for (int i = 0; i < face->count; ++i)
        {
            int at = (from + i) % face->count;
            if (isEar(face, at, *care))
            {
                return at;
            }
        }
    }
    return from % face->count;
}

bool swDivideFace(int count, const swVec3* corners, uint32_t* triangles)
{
    Face face;
    bool isFine = flatten(&face, count, corners);
    int at = 1;
    for (int i = 0; i < count - 2; ++i)
    {
        Care care = CARE_STRICT;
        at = findEar(&face, at, &care);
        isFine = isFine && care != CARE_NONE;
        triangles[3 * i] = (uint32_t)face.left[(at + face.count - 1) % face.count];
        triangles[3 * i + 1] = (uint32_t)face.left[at];
        triangles[3 * i + 2] = (uint32_t)face.left[(at + 1) % face.count];
        face.count -= 1;
        for (int k = at; k < face.count; ++k)
        {
            face.left[k] = face.left[k + 1];
        }
    }
    return isFine;
}
