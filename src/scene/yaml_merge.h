// SPDX-License-Identifier: MIT
#pragma once

// A YAML text that says something else, changed as little as that takes.

#include "scene/yaml_tree.h"

// `text` says what `before` has. Make a text that says what `after` has; what is equal in both keeps its bytes. Keys
// that `after` lacks go, unless `before` lacks them too: those are nothing that trees tell of. New ones come behind
// those that stand there; a list's items know which of the text's they are. The new text is memory of the host,
// `*newSize + 1` bytes with a zero at the end. SW_ERROR_FORMAT and a sentence with the line if the text cannot be
// changed so.
swResult swMergeYaml(const swHost* host, const char* text, size_t size, const char* name, const swTree* before,
                     const swTree* after, char** newText, size_t* newSize);
