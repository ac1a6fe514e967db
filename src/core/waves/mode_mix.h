// SPDX-License-Identifier: MIT
#pragma once

// A sea that turns into another one, wave by wave. Both have the same waves with the same phases, so that any mixture
// of amplitudes is a sea: nothing jumps, whatever the spectra.

#include "core/base/hash.h"
#include "core/base/stream.h"
#include "core/waves/waves_fft.h"

typedef struct swModeMix swModeMix;

// The waves of both seas, `bands` filled with memory for them (swFreeModes() as usual) and set to share 0. The two must
// outlive neither call: amplitudes are copied.
// SW_ERROR_UNSUPPORTED if a wave of both has different frequencies, or a band different tiles: they cannot be mixed.
swResult swMakeModeMix(const swHost* host, const swBandModes* from, const swBandModes* to, const float* response,
                       swBandModes* bands, swModeMix** mix);
void swFreeModeMix(const swHost* host, swModeMix* mix);

// Set the bands' amplitudes and variances: 0 is the first sea, 1 the second. The energy of a band runs linearly between
// its energies in both.
void swApplyModeMix(const swModeMix* mix, float share, swBandModes* bands);

// Part by which the variance of the two seas' sum is above the sum of their variances: 0 of seas with phases of their
// own.
double swFindSharedVariance(const swBandModes* a, const swBandModes* b, const float* response);

// All that a mix is made of; its share is not part of it.
void swAddHashMix(swHash* hash, const swModeMix* mix);

// A mix and its bands as bytes. Reading makes both, as swMakeModeMix() does; SW_ERROR_FORMAT if they are no mix of
// bands on `tileWaves` and `resolution`.
swResult swStreamModeMix(swStream* stream, const swHost* host, int tileWaves, int resolution, swBandModes* bands,
                         swModeMix** mix);
