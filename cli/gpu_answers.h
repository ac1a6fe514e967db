// SPDX-License-Identifier: MIT
#pragma once

// The sea at points, asked of the GPU and waited for: a device, a world on it and one query.

#include "args.h"

typedef struct GpuAnswers GpuAnswers;

// NULL after a complaint. The world must outlive it. Samples may want what the def has.
GpuAnswers* OpenGpuAnswers(const DeviceName* device, const swWorld* world, const swGpuQueryDef* def);
void CloseGpuAnswers(GpuAnswers* answers);

// At the time of the world's last step, at most as many points as the def's capacity: the surface above points, the
// water at places, or what rays meet, by the def's kind.
bool AskGpu(GpuAnswers* answers, int count, const swPosXZ* points, const swSurfaceSamples* samples);
bool AskGpuBelow(GpuAnswers* answers, int count, const swPos* places, const swVolumeSamples* samples);
bool AskGpuRays(GpuAnswers* answers, int count, const swRay* rays, swRayHit* hits);
