// SPDX-License-Identifier: MIT
#pragma once

// MP4 by way of ffmpeg: frames go to it through a pipe as raw RGB.

#include <stdbool.h>
#include <stdint.h>

typedef struct Video Video;

// Even width and height. Complains and returns NULL if the file cannot be written or ffmpeg cannot be started.
Video* OpenVideo(const char* path, int width, int height, double framesPerSecond);
bool WriteVideoFrame(Video* video, const uint8_t* rgb);

// Wait for ffmpeg and give the file its name, if every frame was written and `keep`.
bool CloseVideo(Video* video, bool keep);
