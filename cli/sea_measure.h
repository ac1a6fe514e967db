// SPDX-License-Identifier: MIT
#pragma once

// A scene's sea, made of several seeds, and measured beside what its spectra ask for. What `seaway stats` prints and
// both plots draw.

#include <stdbool.h>

#include "seaway/measure.h"
#include "seaway/scene.h"

typedef struct MeasureOptions
{
    double area;     // side of the square with gauges, m; 0: chosen by the peak
    double duration; // of a record, s; 0: chosen by the peak
    int seeds;
    bool withDirections; // also look at squares of the surface, for the directional spectrum
} MeasureOptions;

#define MEASURE_MAX_SEEDS 256
// Gauges of a seed are dealt out to so many groups, whose scatter tells the error.
#define MEASURE_GROUPS 4

typedef struct SeaMeasurement
{
    const swScene* scene;
    MeasureOptions options;
    swSeaBins bins;
    swSeaGauges gauges;
    double depth; // the first system's, m

    swSeaState asked, measured;
    swSeaState error;                 // standard errors of `measured`
    double foamWind;                  // m/s: what the waves tell of, or the scene's
    double askedWhitecaps, whitecaps; // mean foam: by that wind, and of the foam layer in its steady state
    double surfaceHeight;             // 4 times the deviation of heights above points, m
    double surfaceSlope;              // mean square, of the true surface
    double heightDeviation;           // of Hs from seed to seed, m
    double density[SW_MAX_SEA_BINS], densityError[SW_MAX_SEA_BINS]; // measured, m^2/Hz, and its standard error
    swSeaSums sums;
    swSeaPatches* patches; // NULL without directions
} SeaMeasurement;

// Complains and returns NULL if the scene has no waves or memory is short. The scene has to outlive it.
SeaMeasurement* MeasureSea(const swScene* scene, const MeasureOptions* options);
void DestroyMeasurement(SeaMeasurement* sea);

// What the scene's systems ask for at a frequency, m^2/Hz; and, into density[count], m^2/Hz/rad, at 2 pi i / count.
double AskDensity(const SeaMeasurement* sea, double frequency);
void AskDirections(const SeaMeasurement* sea, double frequency, int count, double* density);

// Asked for between two frequencies, m^2.
double AskVariance(const SeaMeasurement* sea, double low, double high);
