// SPDX-License-Identifier: MIT
#pragma once

// Seas without energy: flat water, which has a height of 0 and neither periods nor directions.

#include "sea_measure.h"

// Whether any system of the scene has waves: energy, a weight, and a range of wavelengths in which they are.
bool HasWaves(const swScene* scene);

// What MeasureSea() gives of a scene with waves: heights and slopes as the surface has them, and NAN for what flat
// water does not have. No bins. Complains and returns NULL if the sea cannot be made.
SeaMeasurement* MeasureCalm(const swScene* scene, const MeasureOptions* options);
