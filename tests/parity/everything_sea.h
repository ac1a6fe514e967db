// SPDX-License-Identifier: MIT
#pragma once

// A sea with everything that a host can put into it, at any number of places: for parity_everything.c. Each feature can
// be had alone.

#include <seaway/seaway.h>

typedef enum Feature
{
    FEATURE_DEPTH,     // a raster with an unknown cell, a circle, a turned rectangle
    FEATURE_LEVEL,     // a lake, a dam, a tide
    FEATURE_RIVER,     // a spline with a level and a bed
    FEATURE_FLOW,      // a current everywhere, a gyre, a stream along a spline
    FEATURE_DISPLACED, // inputs that displace the water: with the waves, and where they stand
    FEATURE_REGIONS,   // weights of systems by rasters, polygons, particles; one that removes the others
    FEATURE_RIBBONS,   // waves that run along splines, of tiles and of free waves
    FEATURE_SHAPES,    // floors by a mesh, a polygon, a trail and particles
    FEATURE_HOLES,     // solids, a hull, an area
    FEATURE_BODIES,    // lakes with waves of their own
    FEATURE_COUNT
} Feature;

const char* GetFeatureName(Feature feature);

#define ALL_FEATURES ((1u << FEATURE_COUNT) - 1u)

// Half the side of the square around a place in which there are features, m.
#define FEATURE_REACH 300.0

// Two systems of tiles and one of free waves, and the features of a mask around each of the places. Ends the program if
// anything is refused.
swWorld* MakeEverything(const swHost* host, uint32_t features, int placeCount, const swPosXZ* places);
