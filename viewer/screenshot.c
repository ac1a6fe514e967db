// SPDX-License-Identifier: MIT
#include "screenshot.h"

#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static bool Exists(const char* path)
{
    FILE* file = fopen(path, "rb");
    if (file != NULL)
    {
        fclose(file);
    }
    return file != NULL;
}

bool NameScreenshot(char* path, size_t size)
{
    for (int i = 1; i < 10000; i++)
    {
        snprintf(path, size, "seaway_%04d.png", i);
        if (!Exists(path))
        {
            return true;
        }
    }
    return false;
}

// Half a picture is taken away; what is no regular file, such as a device, stays.
static void RemovePart(const char* path)
{
    struct stat status;
    if (stat(path, &status) == 0 && S_ISREG(status.st_mode))
    {
        remove(path);
    }
}

static bool WritePng(const char* path, const uint8_t* rgb, uint32_t width, uint32_t height, char* reason, size_t size)
{
    png_image image = {.version = PNG_IMAGE_VERSION, .width = width, .height = height, .format = PNG_FORMAT_RGB};
    FILE* file = fopen(path, "wb");
    if (file == NULL)
    {
        snprintf(reason, size, "%s was not written: %s", path, strerror(errno));
        return false;
    }
    errno = 0;
    bool isWritten = png_image_write_to_stdio(&image, file, 0, rgb, 0, NULL) != 0;
    if (!isWritten)
    {
        snprintf(reason, size, "%s was not written: %s", path, errno != 0 ? strerror(errno) : image.message);
    }
    if (fclose(file) != 0 && isWritten)
    {
        snprintf(reason, size, "%s was not written: %s", path, strerror(errno));
        isWritten = false;
    }
    if (!isWritten)
    {
        RemovePart(path);
    }
    return isWritten;
}

bool WriteScreenshot(const char* path, const uint8_t* rgba, uint32_t width, uint32_t height, char* reason, size_t size)
{
    size_t count = (size_t)width * height;
    uint8_t* rgb = malloc(count * 3);
    if (rgb == NULL)
    {
        snprintf(reason, size, "%s was not written: out of memory", path);
        return false;
    }
    for (size_t i = 0; i < count; i++)
    {
        rgb[3 * i + 0] = rgba[4 * i + 0];
        rgb[3 * i + 1] = rgba[4 * i + 1];
        rgb[3 * i + 2] = rgba[4 * i + 2];
    }
    bool isWritten = WritePng(path, rgb, width, height, reason, size);
    free(rgb);
    return isWritten;
}
