// SPDX-License-Identifier: MIT
#pragma once

// The surface above points of the horizontal plane: find the particle that is there, then say where it is. See sample.c.

#include "core/waves/waves_fft.h"
#include "seaway/query.h"

void swQuerySurface(const swFrame* frame, const swWaveKernels* kernels, const swQueryDef* def, int count,
                    const swPosXZ* points, const swSurfaceSamples* samples, swQueryStats* stats);

void swQueryParticles(const swFrame* frame, const swWaveKernels* kernels, const swQueryDef* def, int count,
                      const swPosXZ* points, const swSurfaceSamples* samples, swVec2* slopes);
