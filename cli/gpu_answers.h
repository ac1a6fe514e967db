// SPDX-License-Identifier: MIT
#pragma once

// The surface at points, asked of the GPU and waited for: a device, a world on it and one query.

#include "args.h"

typedef struct GpuAnswers GpuAnswers;

// NULL after a complaint. The world must outlive it. Samples may want velocity and acceleration only `withMotion`.
GpuAnswers* OpenGpuAnswers(const DeviceName* device, const swWorld* world, const swQueryDef* def, bool withMotion,
                           int capacity);
void CloseGpuAnswers(GpuAnswers* answers);

// At the time of the world's last step, at most `capacity` points.
bool AskGpu(GpuAnswers* answers, int count, const swPosXZ* points, const swSurfaceSamples* samples);
