// SPDX-License-Identifier: MIT
// One channel of an EXR image through OpenEXR's C core, in scan lines or tiles (the finest level), float to the bit.
// What swWriteRaster() says in the header (where the cells lie) is read from there.

#include <math.h>
#include <openexr.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "files/raster_exr.h"
#include "files/raster_grid.h"

typedef struct ExrGrid
{
    swRasterGrid grid;
    exr_context_t file;
    char message[160];
    int width, height, firstX, firstY; // of the data window
    const char* channel;
} ExrGrid;

static void onError(exr_const_context_t context, exr_result_t code, const char* message)
{
    void* user = NULL;
    (void)code;
    if (exr_get_user_data(context, &user) == EXR_ERR_SUCCESS && user != NULL)
    {
        ExrGrid* reader = user;
        snprintf(reader->message, sizeof(reader->message), "%s", message);
    }
}

static swResult failRead(const ExrGrid* reader)
{
    return swFail(reader->grid.host, SW_ERROR_FORMAT, "%s cannot be read as an EXR image: %s", reader->grid.name,
                  reader->message[0] != '\0' ? reader->message : "it is damaged.");
}

static bool hasChannel(const exr_attr_chlist_t* channels, const char* name)
{
    for (int i = 0; i < channels->num_channels; ++i)
    {
        if (strcmp(channels->entries[i].name.str, name) == 0)
        {
            return true;
        }
    }
    return false;
}

static swResult chooseChannel(ExrGrid* reader)
{
    static const char* const usual[] = {"Y", "Z", "R", NULL};
    const exr_attr_chlist_t* channels = NULL;
    if (exr_get_channels(reader->file, 0, &channels) != EXR_ERR_SUCCESS || channels->num_channels < 1)
    {
        return failRead(reader);
    }
    const char* asked = reader->grid.def->variable;
    reader->channel = asked;
    if (asked == NULL)
    {
        reader->channel = channels->num_channels == 1 ? channels->entries[0].name.str : NULL;
        for (int i = 0; usual[i] != NULL && reader->channel == NULL; ++i)
        {
            reader->channel = hasChannel(channels, usual[i]) ? usual[i] : NULL;
        }
    }
    if (reader->channel == NULL || !hasChannel(channels, reader->channel))
    {
        return swFail(reader->grid.host, SW_ERROR_FORMAT,
                      "%s has no channel %s; its first is %s. swRasterFileDef::variable names the one to read.",
                      reader->grid.name, asked != NULL ? asked : "Y, Z or R", channels->entries[0].name.str);
    }
    return SW_SUCCESS;
}

static double findNumber(const ExrGrid* reader, const char* name)
{
    double number = (double)NAN;
    return exr_attr_get_double(reader->file, 0, name, &number) == EXR_ERR_SUCCESS ? number : (double)NAN;
}

static swResult readHeading(ExrGrid* reader)
{
    exr_attr_box2i_t window;
    exr_storage_t storage;
    if (exr_get_data_window(reader->file, 0, &window) != EXR_ERR_SUCCESS ||
        exr_get_storage(reader->file, 0, &storage) != EXR_ERR_SUCCESS)
    {
        return failRead(reader);
    }
    if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
    {
        return swFail(reader->grid.host, SW_ERROR_FORMAT, "%s is a deep EXR image; heights need a flat one.",
                      reader->grid.name);
    }
    long long width = (long long)window.max.x - window.min.x + 1, height = (long long)window.max.y - window.min.y + 1;
    if (width < 1 || height < 1 || width > 10000000 || height > 10000000)
    {
        return failRead(reader);
    }
    reader->firstX = window.min.x;
    reader->firstY = window.min.y;
    reader->width = (int)width;
    reader->height = (int)height;
    const double spacing[2] = {findNumber(reader, SW_EXR_SPACING_X), findNumber(reader, SW_EXR_SPACING_Z)};
    const double first[2] = {findNumber(reader, SW_EXR_X), -findNumber(reader, SW_EXR_Z)};
    swResult result = chooseChannel(reader);
    reader->message[0] = '\0'; // that an attribute is missing is no fault
    return result != SW_SUCCESS ? result
                                : swPlaceImageGrid(&reader->grid, reader->width, reader->height, spacing, first,
                                                   isfinite(first[0]) ? 'm' : 0);
}

// `block` has room for two chunks: the channel that counts, and behind it whatever the others hold, since OpenEXR 3.1
// decodes wrongly where one of several channels has no place to go.
static bool decodeChunk(const ExrGrid* reader, exr_decode_pipeline_t* decoder, const exr_chunk_info_t* chunk,
                        float* block, bool isFirst)
{
    exr_result_t result = isFirst ? exr_decoding_initialize(reader->file, 0, chunk, decoder)
                                  : exr_decoding_update(reader->file, 0, chunk, decoder);
    if (result != EXR_ERR_SUCCESS)
    {
        return false;
    }
    for (int i = 0; i < decoder->channel_count; ++i)
    {
        exr_coding_channel_info_t* channel = &decoder->channels[i];
        bool isOurs = strcmp(channel->channel_name, reader->channel) == 0;
        if (isOurs && (channel->x_samples != 1 || channel->y_samples != 1))
        {
            return false; // of fewer samples than pixels
        }
        size_t others = (size_t)chunk->width * (size_t)chunk->height;
        channel->decode_to_ptr = (uint8_t*)(isOurs ? block : block + others);
        channel->user_pixel_stride = sizeof(float);
        channel->user_line_stride = (int32_t)(sizeof(float) * (size_t)chunk->width);
        channel->user_bytes_per_element = sizeof(float);
        channel->user_data_type = EXR_PIXEL_FLOAT;
    }
    if (isFirst && exr_decoding_choose_default_routines(reader->file, 0, decoder) != EXR_ERR_SUCCESS)
    {
        return false;
    }
    return exr_decoding_run(reader->file, 0, decoder) == EXR_ERR_SUCCESS;
}

// A chunk whose first pixel is at (column, row) of the image.
static void keepChunk(const ExrGrid* reader, const exr_chunk_info_t* chunk, int column, int row, const float* block,
                      float* values)
{
    const swRasterGrid* grid = &reader->grid;
    swImageRows rows = swGetImageRows(grid);
    size_t width = (size_t)(grid->east.end - grid->east.begin);
    for (int j = 0; j < chunk->height; ++j)
    {
        for (int i = 0; i < chunk->width; ++i)
        {
            int x = column + i, y = row + j;
            if (x >= grid->east.begin && x < grid->east.end && y >= rows.first && y < rows.end)
            {
                values[(size_t)(y - rows.first) * width + (size_t)(x - grid->east.begin)] =
                    block[(size_t)j * (size_t)chunk->width + (size_t)i];
            }
        }
    }
}

// The chunks of an image, all of one size but for the last of a row or column.
typedef struct ExrChunks
{
    bool isTiled;
    int width, height;
} ExrChunks;

static bool findChunks(const ExrGrid* reader, ExrChunks* chunks)
{
    exr_storage_t storage;
    exr_tile_level_mode_t levels;
    exr_tile_round_mode_t rounding;
    uint32_t width = 0, height = 0;
    int32_t lines = 0;
    exr_get_storage(reader->file, 0, &storage);
    *chunks = (ExrChunks){.isTiled = storage == EXR_STORAGE_TILED, .width = reader->width};
    bool isFound = chunks->isTiled ? exr_get_tile_descriptor(reader->file, 0, &width, &height, &levels, &rounding) ==
                                         EXR_ERR_SUCCESS
                                   : exr_get_scanlines_per_chunk(reader->file, 0, &lines) == EXR_ERR_SUCCESS;
    if (!isFound || (chunks->isTiled && (width < 1 || height < 1 || width > 16384 || height > 16384)))
    {
        return false;
    }
    chunks->width = chunks->isTiled ? (int)width : reader->width;
    chunks->height = chunks->isTiled ? (int)height : lines;
    return chunks->height >= 1;
}

static bool readChunk(const ExrGrid* reader, const ExrChunks* chunks, int column, int row,
                      exr_decode_pipeline_t* decoder, bool isFirst, float* block, float* values)
{
    exr_chunk_info_t chunk;
    exr_result_t result = chunks->isTiled ? exr_read_tile_chunk_info(reader->file, 0, column / chunks->width,
                                                                     row / chunks->height, 0, 0, &chunk)
                                          : exr_read_scanline_chunk_info(reader->file, 0, reader->firstY + row, &chunk);
    if (result != EXR_ERR_SUCCESS || chunk.width < 1 || chunk.height < 1 || chunk.width > chunks->width ||
        chunk.height > chunks->height || !decodeChunk(reader, decoder, &chunk, block, isFirst))
    {
        return false;
    }
    keepChunk(reader, &chunk, column, row, block, values);
    return true;
}

static swResult readChunks(ExrGrid* reader, const ExrChunks* chunks, float* block, float* values)
{
    const swRasterGrid* grid = &reader->grid;
    swImageRows rows = swGetImageRows(grid);
    exr_decode_pipeline_t decoder = EXR_DECODE_PIPELINE_INITIALIZER;
    bool isRead = true, isFirst = true;
    for (int row = rows.first / chunks->height * chunks->height; row < rows.end && isRead; row += chunks->height)
    {
        for (int column = grid->east.begin / chunks->width * chunks->width; column < grid->east.end && isRead;
             column += chunks->width)
        {
            isRead = readChunk(reader, chunks, column, row, &decoder, isFirst, block, values);
            isFirst = false;
        }
    }
    exr_decoding_destroy(reader->file, &decoder);
    return isRead ? SW_SUCCESS : failRead(reader);
}

static swResult readCells(ExrGrid* reader, swRaster** raster)
{
    const swRasterGrid* grid = &reader->grid;
    ExrChunks chunks;
    if (!findChunks(reader, &chunks))
    {
        return failRead(reader);
    }
    size_t size = 2 * (size_t)chunks.width * (size_t)chunks.height * sizeof(float);
    if (size > grid->def->memoryLimit)
    {
        return swFail(grid->host, SW_ERROR_LIMIT, "%s is packed in pieces of %d x %d; save it in smaller ones.",
                      grid->name, chunks.width, chunks.height);
    }
    swResult result = SW_SUCCESS;
    float* values = swAllocateCells(grid, &result);
    float* block = result == SW_SUCCESS ? swAllocate(grid->host, size) : NULL;
    if (result == SW_SUCCESS && block == NULL)
    {
        result = swFail(grid->host, SW_ERROR_NO_MEMORY, "No memory for a part of %s.", grid->name);
    }
    result = result != SW_SUCCESS ? result : readChunks(reader, &chunks, block, values);
    result = result != SW_SUCCESS ? result : swMakeGridRaster(grid, values, raster);
    swFree(grid->host, block, size);
    swFreeCells(grid, values);
    return result;
}

swResult swReadExrGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster)
{
    ExrGrid reader = {.grid = {.host = host, .name = path, .def = def, .isDepth = def->isDepth}};
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    settings.error_handler_fn = onError;
    settings.user_data = &reader;
    if (exr_start_read(&reader.file, path, &settings) != EXR_ERR_SUCCESS)
    {
        return failRead(&reader);
    }
    swResult result = readHeading(&reader);
    result = result != SW_SUCCESS ? result : readCells(&reader, raster);
    exr_finish(&reader.file);
    return result;
}
