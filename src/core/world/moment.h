// SPDX-License-Identifier: MIT
#pragma once

// The water at one time, as queries see it.

#include "core/frame/frame.h"
#include "core/waves/waves_fft.h"
#include "seaway/moment.h"

struct swMoment
{
    const swHost* host; // the caller's, for messages
    const swWaveKernels* kernels;
    const swFrame* frame;
    const swPosXZ* origin; // of the host's coordinates, in the sea
};
