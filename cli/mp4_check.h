// SPDX-License-Identifier: MIT
#pragma once

// Whether an MP4 file is whole.

// NULL if the file at `path` is whole and holds one track of `frameCount` pictures; else what is wrong, a few words.
const char* FindVideoFault(const char* path, int frameCount);
