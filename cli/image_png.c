// SPDX-License-Identifier: MIT
#include "image.h"

#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdio.h>
#include <string.h>

#include "output.h"
#include "common.h"

static void OnPngError(png_structp png, png_const_charp message)
{
    (void)message; // the reason is in errno
    longjmp(png_jmpbuf(png), 1);
}

static void OnPngWarning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

// libpng leaves by longjmp when a write fails.
static bool EncodePng(FILE* file, int width, int height, const uint8_t* rgb)
{
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, OnPngError, OnPngWarning);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    if (info == NULL)
    {
        png_destroy_write_struct(&png, NULL);
        return false;
    }
    if (setjmp(png_jmpbuf(png)))
    {
        png_destroy_write_struct(&png, &info);
        return false;
    }
    png_init_io(png, file);
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    for (int row = 0; row < height; ++row)
    {
        png_write_row(png, rgb + (size_t)row * (size_t)width * 3);
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return true;
}

bool WritePng(const char* path, int width, int height, const uint8_t* rgb)
{
    OutputFile output;
    if (!BeginOutput(&output, path))
    {
        return false;
    }
    errno = 0;
    FILE* file = fopen(output.path, "wb");
    bool isWritten = file != NULL && EncodePng(file, width, height, rgb);
    int reason = errno;
    if (file != NULL && fclose(file) != 0 && isWritten)
    {
        reason = errno;
        isWritten = false;
    }
    if (!isWritten)
    {
        Complain("cannot write %s: %s", path, reason != 0 ? strerror(reason) : "libpng failed");
    }
    return EndOutput(&output, isWritten);
}
