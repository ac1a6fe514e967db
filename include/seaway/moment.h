// SPDX-License-Identifier: MIT
#pragma once

#include "world.h"

/// @file
/// The water at one time, which is what queries ask (query.h). A world has one of its own: the water of its last step.

typedef struct swMoment swMoment;

/// The water of the world's last step. The pointer stays the same for the world's life; what it shows changes with each
/// step, so while one thread steps, sets or destroys, no other may ask it.
SW_API const swMoment* swWorld_GetMoment(const swWorld* world);

/// Time of the water, s.
SW_API double swMoment_GetTime(const swMoment* moment);
