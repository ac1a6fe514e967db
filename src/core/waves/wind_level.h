// SPDX-License-Identifier: MIT
#pragma once

// The wind that a sea's waves tell of. Above its peak a wind sea has an equilibrium range, S(omega) = A omega^-4, whose
// level grows with the wind, A = 4 beta I u* g [Phillips 1985]; buoys read the wind from it [Thomson 2013]
// [Voermans 2020]. Here A = 0.0037 g U, in steps of a quarter octave of wavelength.
//
// A spectrum's level in a step is written as the wind U (m/s) that it alone would tell of. Levels are proportional to
// energy and those of several systems add up. The wind of the sea is the highest level that the sea holds over an
// octave of frequency: a swell is narrower than that and tells of none.
//
// Where the wind is known, because a formula was given nothing else or because the def says so, it is taken as it is
// and the waves have no levels: the published formulas for one wind disagree by a third, and real seas by more. Known
// winds of several systems are one wind that blows over all of them, so the strongest counts and they do not add up.

#include "core/spectra/spectrum.h"
#include "seaway/waves.h"

#define SW_WIND_STEPS 4 // a band

typedef struct swBandModes swBandModes;

// No wind is stronger than this, whatever the waves: the range of what may be given, m/s.
#define SW_STRONGEST_WIND 100.0f

// Fills `wind` and `knownWind` of bands[SW_MAX_BANDS].
void swFillWindLevels(const swCompiledSpectrum* spectrum, const swSpectrumDef* def, swBandModes* bands);

// levels[SW_MAX_BANDS * SW_WIND_STEPS], shortest waves first. 0 where no wind is to be seen.
float swFindWind(const float* levels, double gravity);
