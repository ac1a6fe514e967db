// SPDX-License-Identifier: MIT
#pragma once

// What all queries of the core share about their answers: points that get none, and the counts of a batch.

#include <math.h>

#include "core/surface/search.h"

// NaN, for what cannot be answered.
#define SW_NO_NUMBER ((float)NAN)
#define SW_NO_VECTOR ((swVec3){SW_NO_NUMBER, SW_NO_NUMBER, SW_NO_NUMBER})

// Where a point of the host's is in the sea. False for one that cannot be answered: NaN, infinite or too far out.
bool swPlacePoint(const swQuery* query, double x, double z, swPosXZ* place);

// Add a block's search to a batch's.
void swCountFound(swQueryStats* stats, const swFound* found, int count, float tolerance);

// Every point of a query that is refused as a whole is bad.
void swRefuseStats(int count, swQueryStats* stats);
