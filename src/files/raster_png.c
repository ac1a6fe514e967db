// SPDX-License-Identifier: MIT
// PNG images as numbers: samples as they are stored, whatever gamma or colours the file speaks of.

#include <errno.h>
#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdio.h>
#include <string.h>

#include "files/raster_grid.h"

// What libpng may leave by a jump lives here, not on the stack of the function that it jumps to.
typedef struct PngGrid
{
    swRasterGrid grid;
    FILE* file;
    png_structp png;
    png_infop info;
    char message[160];
    unsigned char* row; // of a whole image where it is interlaced
    size_t rowSize, rowsSize;
    png_bytep* rows;
    float* values;
    int width, height, bytesEach, samples, channel;
    bool isInterlaced;
} PngGrid;

static void onError(png_structp png, png_const_charp message)
{
    PngGrid* reader = png_get_error_ptr(png);
    snprintf(reader->message, sizeof(reader->message), "%s", message);
    longjmp(png_jmpbuf(png), 1);
}

static void onWarning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message; // of chunks that hold no samples
}

// The sample of a pixel that counts.
static swResult chooseChannel(PngGrid* reader, int colorType)
{
    const char* const names = colorType == PNG_COLOR_TYPE_GRAY         ? "Y"
                              : colorType == PNG_COLOR_TYPE_GRAY_ALPHA ? "YA"
                              : colorType == PNG_COLOR_TYPE_RGB        ? "RGB"
                                                                       : "RGBA";
    const char* asked = reader->grid.def->variable;
    reader->samples = (int)strlen(names);
    reader->channel = 0;
    if (asked != NULL)
    {
        const char* at = strlen(asked) == 1 ? strchr(names, asked[0]) : NULL;
        if (at == NULL)
        {
            return swFail(reader->grid.host, SW_ERROR_FORMAT, "%s has no channel %s; its channels are %s.",
                          reader->grid.name, asked, names);
        }
        reader->channel = (int)(at - names);
    }
    return SW_SUCCESS;
}

static swResult readHeading(PngGrid* reader)
{
    const double unknown[2] = {(double)NAN, (double)NAN};
    swRasterGrid* grid = &reader->grid;
    png_init_io(reader->png, reader->file);
    png_read_info(reader->png, reader->info);
    reader->width = (int)png_get_image_width(reader->png, reader->info);
    reader->height = (int)png_get_image_height(reader->png, reader->info);
    int depth = png_get_bit_depth(reader->png, reader->info);
    int colorType = png_get_color_type(reader->png, reader->info);
    if (colorType == PNG_COLOR_TYPE_PALETTE || depth < 8)
    {
        return swFail(grid->host, SW_ERROR_FORMAT,
                      "%s is a PNG image of %s; heights need 16 bits of grey. Save it as such.", grid->name,
                      colorType == PNG_COLOR_TYPE_PALETTE ? "a palette's colours" : "fewer than 8 bits");
    }
    if (depth == 8)
    {
        swLog(grid->host, SW_LOG_WARNING,
              "%s has 8 bits: heights lie on %d steps, which waves and foam show as terraces. Use 16 bits.", grid->name,
              256);
    }
    reader->bytesEach = depth / 8;
    reader->isInterlaced = png_get_interlace_type(reader->png, reader->info) != PNG_INTERLACE_NONE;
    swResult result = chooseChannel(reader, colorType);
    return result != SW_SUCCESS ? result : swPlaceImageGrid(grid, reader->width, reader->height, unknown, unknown, 0);
}

static void keepRow(PngGrid* reader, int row, const unsigned char* bytes)
{
    const swRasterGrid* grid = &reader->grid;
    swImageRows rows = swGetImageRows(grid);
    size_t width = (size_t)(grid->east.end - grid->east.begin);
    if (row < rows.first || row >= rows.end)
    {
        return;
    }
    for (size_t i = 0; i < width; ++i)
    {
        size_t pixel = i + (size_t)grid->east.begin;
        const unsigned char* at =
            bytes + (pixel * (size_t)reader->samples + (size_t)reader->channel) * (size_t)reader->bytesEach;
        unsigned number = reader->bytesEach == 2 ? (unsigned)at[0] << 8 | at[1] : at[0];
        reader->values[(size_t)(row - rows.first) * width + i] = (float)number;
    }
}

static swResult allocate(PngGrid* reader)
{
    const swHost* host = reader->grid.host;
    swResult result = SW_SUCCESS;
    reader->rowSize = png_get_rowbytes(reader->png, reader->info);
    size_t rowCount = reader->isInterlaced ? (size_t)reader->height : 1;
    if (reader->rowSize * rowCount > reader->grid.def->memoryLimit)
    {
        return swFail(host, SW_ERROR_LIMIT, "%s is interlaced and takes %zu bytes to read; save it without.",
                      reader->grid.name, reader->rowSize * rowCount);
    }
    reader->rowsSize = reader->isInterlaced ? rowCount * sizeof(png_bytep) : 0;
    reader->values = swAllocateCells(&reader->grid, &result);
    reader->row = swAllocate(host, reader->rowSize * rowCount);
    reader->rows = reader->isInterlaced ? swAllocate(host, reader->rowsSize) : NULL;
    if (result == SW_SUCCESS && (reader->row == NULL || (reader->isInterlaced && reader->rows == NULL)))
    {
        result = swFail(host, SW_ERROR_NO_MEMORY, "No memory for the rows of %s.", reader->grid.name);
    }
    for (size_t i = 0; i < rowCount && result == SW_SUCCESS && reader->isInterlaced; ++i)
    {
        reader->rows[i] = reader->row + i * reader->rowSize;
    }
    return result;
}

static void readRows(PngGrid* reader)
{
    if (reader->isInterlaced)
    {
        png_read_image(reader->png, reader->rows);
    }
    for (int row = 0; row < reader->height; ++row)
    {
        if (!reader->isInterlaced)
        {
            png_read_row(reader->png, reader->row, NULL);
        }
        keepRow(reader, row, reader->isInterlaced ? reader->rows[row] : reader->row);
    }
}

static swResult read(PngGrid* reader)
{
    if (setjmp(png_jmpbuf(reader->png)) != 0)
    {
        return swFail(reader->grid.host, SW_ERROR_FORMAT, "%s is damaged: %s. Save it anew.", reader->grid.name,
                      reader->message);
    }
    swResult result = readHeading(reader);
    result = result != SW_SUCCESS ? result : allocate(reader);
    if (result == SW_SUCCESS)
    {
        readRows(reader);
    }
    return result;
}

static void freeReader(PngGrid* reader)
{
    const swHost* host = reader->grid.host;
    if (reader->values != NULL)
    {
        swFreeCells(&reader->grid, reader->values);
    }
    size_t rowCount = reader->isInterlaced ? (size_t)reader->height : 1;
    swFree(host, reader->row, reader->rowSize * rowCount);
    swFree(host, reader->rows, reader->rowsSize);
    png_destroy_read_struct(&reader->png, &reader->info, NULL);
    fclose(reader->file);
}

swResult swReadPngGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster)
{
    PngGrid reader = {.grid = {.host = host, .name = path, .def = def, .isDepth = def->isDepth}};
    reader.file = fopen(path, "rb");
    if (reader.file == NULL)
    {
        return swFail(host, SW_ERROR_FILE, "Cannot read %s: %s", path, strerror(errno));
    }
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, onError, onWarning);
    reader.info = reader.png != NULL ? png_create_info_struct(reader.png) : NULL;
    swResult result =
        reader.info != NULL ? SW_SUCCESS : swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", path);
    result = result != SW_SUCCESS ? result : read(&reader);
    result = result != SW_SUCCESS ? result : swMakeGridRaster(&reader.grid, reader.values, raster);
    freeReader(&reader);
    return result;
}
