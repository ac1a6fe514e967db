// SPDX-License-Identifier: MIT
#pragma once

// PNG in and out for the golden pictures: 8-bit RGB(A).

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

// `rgba` is width * height * 4 bytes; alpha is not written.
static inline bool WritePng(const char* path, uint32_t width, uint32_t height, const uint8_t* rgba)
{
    uint8_t* rgb = malloc(3ull * width * height);
    if (!rgb)
    {
        return false;
    }
    for (size_t i = 0; i < (size_t)width * height; ++i)
    {
        memcpy(rgb + 3 * i, rgba + 4 * i, 3);
    }
    png_image image = {.version = PNG_IMAGE_VERSION, .width = width, .height = height, .format = PNG_FORMAT_RGB};
    bool isWritten = png_image_write_to_file(&image, path, 0, rgb, 0, NULL) != 0;
    free(rgb);
    return isWritten;
}

// NULL if there is no such picture of that size; the caller frees.
static inline uint8_t* ReadPng(const char* path, uint32_t width, uint32_t height)
{
    png_image image = {.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_file(&image, path))
    {
        return NULL;
    }
    image.format = PNG_FORMAT_RGBA;
    uint8_t* rgba = image.width == width && image.height == height ? malloc(4ull * width * height) : NULL;
    if (rgba && !png_image_finish_read(&image, NULL, rgba, 0, NULL))
    {
        free(rgba);
        rgba = NULL;
    }
    png_image_free(&image);
    return rgba;
}
