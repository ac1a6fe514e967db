// SPDX-License-Identifier: MIT
#pragma once

// Inputs as bytes, in digests, and back to a state that was saved.

#include "core/base/hash.h"
#include "core/base/stream.h"
#include "core/input/inputs.h"
#include "seaway/save.h"

// A place in the sea that was read: whether a host could have given it, which counts from an origin of its own. It then
// counts from there, so that it can be checked as a def's is.
bool swTakeSavedPlace(swPos* position);

// All inputs. Those that are read are made, in a world that has none; what they use, `find` gives. SW_ERROR_FORMAT,
// SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT, SW_ERROR_UNSUPPORTED (something is not given; the log names it).
swResult swStreamInputs(swInputs* inputs, swStream* stream, const swRestoreDef* find);

// The same into the inputs that are there: first look whether they have all that they had then, then read.
// SW_ERROR_FORMAT; SW_ERROR_UNSUPPORTED: they have not.
swResult swCheckInputs(const swInputs* inputs, swStream* stream);
void swRewindInputs(swInputs* inputs, swStream* stream);

// All that decides what inputs say. Nothing of a world without any.
void swHashInputs(swHash* hash, const swInputs* inputs);

// The same of the inputs of one field.
void swHashFieldInputs(swHash* hash, const swInputs* inputs, swInputField field);
