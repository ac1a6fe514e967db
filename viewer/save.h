// SPDX-License-Identifier: MIT
#pragma once

// The sea as the panel has it, in a scene file.

#include "sea.h"

// Read the scene at `from` (NULL: an empty one), give it every value of the sea that differs from its own, and write it
// to `path`. What stood in the file stays: comments, order, quotes. Nothing of `sea` changes.
// @return what swReadScene() and swWriteScene() return; the host's log says why
swResult SaveSea(const Sea* sea, const char* from, const char* path);

// Find the first "seaway_0001.yaml" and so on of the working folder that does not exist yet; false if all do.
bool NameScene(char* path, size_t size);
