// SPDX-License-Identifier: MIT
#pragma once

// Faces with more than three corners, as triangles.

#include <stdbool.h>
#include <stdint.h>

#include "seaway/math.h"

// Most corners of a face: the work goes by their square.
#define SW_MAX_FACE_CORNERS 2048

// Divide a face, which may be concave, into count - 2 triangles [count - 2][3] of its corners, turned as it is. False
// if it crosses itself or has no plane: then the triangles are there too, and what they cover is a guess.
bool swDivideFace(int count, const swVec3* corners, uint32_t* triangles);
