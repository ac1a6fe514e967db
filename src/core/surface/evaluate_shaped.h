// SPDX-License-Identifier: MIT
#pragma once

// What evaluate.c and evaluate_shaped.c share.

#include "core/surface/evaluate.h"

// The free waves that an evaluation asks for, and the bounds of its tiles; tileCount is 0.
swWaveSumJob swMakeSumJob(const swQuery* query, const swEvaluation* out, int count, const swPosXZ* points);

// Whether tiles have texels of a field (as swTileChoice numbers them) at the query's time.
bool swHasTexels(const swQuery* query, int field);

// swEvaluate() where waves are the same everywhere.
void swEvaluatePlain(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out);

// swEvaluate() where waves are shaped by their places. Where a shape leaves waves as they are, tiles give the same
// bits.
void swEvaluateShaped(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out);
