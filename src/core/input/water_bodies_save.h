// SPDX-License-Identifier: MIT
#pragma once

// Bodies of water as bytes, and back to a state that was saved. The inputs that they own are saved with the others and
// come before them, so digests hold bodies by their inputs.

#include "core/base/stream.h"
#include "core/input/water_bodies.h"

// All bodies. Those that are read are made, in a world that has none but has their inputs. SW_ERROR_FORMAT,
// SW_ERROR_NO_MEMORY.
swResult swStreamWaterBodies(swWaterBodies* bodies, swStream* stream);

// The same into the bodies that are there: first look whether they are those of then, then read, once inputs are
// read. SW_ERROR_FORMAT; SW_ERROR_UNSUPPORTED: one is gone or has another shore.
swResult swCheckWaterBodies(const swWaterBodies* bodies, swStream* stream);
void swRewindWaterBodies(swWaterBodies* bodies, swStream* stream);
