// SPDX-License-Identifier: MIT
#pragma once

// The fields that inputs make, at places.

#include "core/frame/frame.h"
#include "seaway/input.h"

// Returns how many places could not be answered. `system` is the slot of the wave system whose weight is asked for.
int swFindFields(const swFrame* frame, swPosXZ origin, int system, int count, const swPosXZ* points,
                 const swFieldSamples* samples);

// Every place of a query that is refused as a whole is bad.
void swRefuseFields(int count, const swFieldSamples* samples);
