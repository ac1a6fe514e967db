// SPDX-License-Identifier: MIT
#pragma once

// A slice is a window of texels on a lattice that is fixed to the world: texel n of the lattice rests at n * texel. The
// lattices are nested, texel n of one level is texel 2n of the level below. All indices are 64-bit integers from double
// positions, so that a slice 1,000 km from the origin is as exact as one at the origin.

#include "core/frame/frame.h"

// A slice carries waves down to this many texels a wave: four vertices of the surface mesh, whose vertices stand two
// texels apart. With half as many, mesh and morph would see the shortest waves at two vertices a wave, as ridges that
// flicker. What is shorter has its slopes in the pixels' detail layers and its whitecaps in the foam's statistics.
#define SW_TEXELS_PER_WAVE 8

// The window of `resolution` texels centred on (x, z), for a lattice `level` doublings above finestTexel.
swSlice swSnapSlice(double finestTexel, int level, int resolution, double x, double z);
