// SPDX-License-Identifier: MIT
// Rasters to EXR images, and what such an image was made from. Built with and without OpenEXR. The images are not
// compressed: OpenEXR 3.1.5 writes some chunks that compression would not shorten so that it cannot read them.

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "core/base/host.h"
#include "core/base/misuse.h"
#include "files/file_text.h"
#include "files/raster_exr.h"
#include "seaway/files.h"

#if SW_HAS_EXR
#include <openexr.h>

// The file in memory, so that it takes its place only once it is whole.
typedef struct ExrBytes
{
    const swHost* host;
    char* data;
    size_t size, capacity;
} ExrBytes;

static void onError(exr_const_context_t context, exr_result_t code, const char* message)
{
    (void)context;
    (void)code;
    (void)message; // one sentence of ours follows
}

static bool growBytes(ExrBytes* bytes, size_t size)
{
    size_t capacity = bytes->capacity;
    while (capacity < size)
    {
        capacity *= 2;
    }
    if (capacity == bytes->capacity)
    {
        return true;
    }
    char* data = swAllocateZero(bytes->host, capacity);
    if (data == NULL)
    {
        return false;
    }
    memcpy(data, bytes->data, bytes->size);
    swFree(bytes->host, bytes->data, bytes->capacity);
    bytes->data = data;
    bytes->capacity = capacity;
    return true;
}

static int64_t writeBytes(exr_const_context_t context, void* user, const void* buffer, uint64_t size, uint64_t offset,
                          exr_stream_error_func_ptr_t tell)
{
    ExrBytes* bytes = user;
    size_t end = (size_t)(offset + size);
    if (!growBytes(bytes, end))
    {
        tell(context, EXR_ERR_OUT_OF_MEMORY, "no memory");
        return -1;
    }
    memcpy(bytes->data + offset, buffer, (size_t)size);
    bytes->size = bytes->size > end ? bytes->size : end;
    return (int64_t)size;
}

static bool writeHeader(exr_context_t file, const swRasterInfo* info, const char* source, uint64_t hash)
{
    int part = 0;
    char hex[17];
    snprintf(hex, sizeof(hex), "%016" PRIx64, hash);
    const struct
    {
        const char* name;
        double number;
    } numbers[] = {{SW_EXR_X, info->x},
                   {SW_EXR_Z, info->z},
                   {SW_EXR_SPACING_X, info->spacingX},
                   {SW_EXR_SPACING_Z, info->spacingZ}};
    bool isDone = exr_add_part(file, "height", EXR_STORAGE_SCANLINE, &part) == EXR_ERR_SUCCESS &&
                  exr_initialize_required_attr_simple(file, part, info->width, info->height, EXR_COMPRESSION_NONE) ==
                      EXR_ERR_SUCCESS &&
                  exr_add_channel(file, part, "Y", EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LINEAR, 1, 1) == EXR_ERR_SUCCESS &&
                  exr_attr_set_string(file, part, SW_EXR_SOURCE, source) == EXR_ERR_SUCCESS &&
                  exr_attr_set_string(file, part, SW_EXR_SOURCE_HASH, hex) == EXR_ERR_SUCCESS;
    for (int i = 0; i < 4 && isDone; ++i)
    {
        isDone = exr_attr_set_double(file, part, numbers[i].name, numbers[i].number) == EXR_ERR_SUCCESS;
    }
    return isDone && exr_write_header(file) == EXR_ERR_SUCCESS;
}

static bool writeChunk(exr_context_t file, exr_encode_pipeline_t* encoder, int row, int width, const float* values)
{
    exr_chunk_info_t chunk;
    if (exr_write_scanline_chunk_info(file, 0, row, &chunk) != EXR_ERR_SUCCESS)
    {
        return false;
    }
    exr_result_t result =
        row == 0 ? exr_encoding_initialize(file, 0, &chunk, encoder) : exr_encoding_update(file, 0, &chunk, encoder);
    if (result != EXR_ERR_SUCCESS)
    {
        return false;
    }
    exr_coding_channel_info_t* channel = encoder->channels;
    channel->encode_from_ptr = (const uint8_t*)(values + (size_t)row * (size_t)width);
    channel->user_pixel_stride = sizeof(float);
    channel->user_line_stride = (int32_t)sizeof(float) * width;
    channel->user_bytes_per_element = sizeof(float);
    channel->user_data_type = EXR_PIXEL_FLOAT;
    if (row == 0 && exr_encoding_choose_default_routines(file, 0, encoder) != EXR_ERR_SUCCESS)
    {
        return false;
    }
    return exr_encoding_run(file, 0, encoder) == EXR_ERR_SUCCESS;
}

static bool encode(exr_context_t file, const swRaster* raster, const char* source, uint64_t hash)
{
    swRasterInfo info = swRaster_GetInfo(raster);
    int32_t lines = 0;
    if (!writeHeader(file, &info, source, hash) || exr_get_scanlines_per_chunk(file, 0, &lines) != EXR_ERR_SUCCESS)
    {
        return false;
    }
    exr_encode_pipeline_t encoder = EXR_ENCODE_PIPELINE_INITIALIZER;
    bool isWritten = true;
    for (int row = 0; row < info.height && isWritten; row += lines)
    {
        isWritten = writeChunk(file, &encoder, row, info.width, swRaster_GetValues(raster));
    }
    exr_encoding_destroy(file, &encoder);
    return isWritten;
}

static swResult writeExr(const swHost* host, const char* path, const swRaster* raster, const char* source,
                         uint64_t hash)
{
    swRasterInfo info = swRaster_GetInfo(raster);
    size_t lines = (size_t)info.height * ((size_t)info.width * sizeof(float) + 16); // each with its number and place
    ExrBytes bytes = {.host = host, .capacity = lines + 4096};
    bytes.data = swAllocateZero(host, bytes.capacity);
    if (bytes.data == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to write %s, %zu bytes.", path, bytes.capacity);
    }
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    settings.error_handler_fn = onError;
    settings.user_data = &bytes;
    settings.write_fn = writeBytes;
    exr_context_t file = NULL;
    bool isWritten = exr_start_write(&file, path, EXR_WRITE_FILE_DIRECTLY, &settings) == EXR_ERR_SUCCESS;
    if (isWritten)
    {
        isWritten = encode(file, raster, source, hash);
        isWritten = exr_finish(&file) == EXR_ERR_SUCCESS && isWritten;
    }
    swResult result = isWritten ? swWriteText(host, path, bytes.data, bytes.size)
                                : swFail(host, SW_ERROR_NO_MEMORY, "OpenEXR cannot make %s: is there memory?", path);
    swFree(host, bytes.data, bytes.capacity);
    return result;
}

// The lattice, to the bit as it was written.
static bool readLattice(exr_context_t file, swRasterSource* source)
{
    const struct
    {
        const char* name;
        double* number;
    } numbers[] = {{SW_EXR_X, &source->x},
                   {SW_EXR_Z, &source->z},
                   {SW_EXR_SPACING_X, &source->spacingX},
                   {SW_EXR_SPACING_Z, &source->spacingZ}};
    exr_attr_box2i_t window;
    bool isThere = exr_get_data_window(file, 0, &window) == EXR_ERR_SUCCESS;
    if (isThere)
    {
        long long width = (long long)window.max.x - window.min.x + 1;
        long long height = (long long)window.max.y - window.min.y + 1;
        isThere = width >= 1 && width <= SW_MAX_RASTER_SIDE && height >= 1 && height <= SW_MAX_RASTER_SIDE;
        source->width = isThere ? (int)width : 0;
        source->height = isThere ? (int)height : 0;
    }
    for (int i = 0; i < 4 && isThere; ++i)
    {
        isThere = exr_attr_get_double(file, 0, numbers[i].name, numbers[i].number) == EXR_ERR_SUCCESS;
    }
    return isThere;
}

static swResult readSource(const swHost* host, const char* path, swRasterSource* source)
{
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    settings.error_handler_fn = onError;
    exr_context_t file = NULL;
    if (exr_start_read(&file, path, &settings) != EXR_ERR_SUCCESS)
    {
        return swHasFile(path) ? swFail(host, SW_ERROR_FORMAT, "%s is no EXR image; it should be a baked raster.", path)
                               : swFail(host, SW_ERROR_FILE, "Cannot read %s: there is no such file.", path);
    }
    const char *text = NULL, *hex = NULL;
    int32_t textSize = 0, hexSize = 0;
    bool isThere = exr_attr_get_string(file, 0, SW_EXR_SOURCE_HASH, &hexSize, &hex) == EXR_ERR_SUCCESS &&
                   hexSize == 16 && sscanf(hex, "%16" SCNx64, &source->hash) == 1 && readLattice(file, source);
    if (exr_attr_get_string(file, 0, SW_EXR_SOURCE, &textSize, &text) == EXR_ERR_SUCCESS && textSize > 0)
    {
        size_t size = (size_t)textSize < sizeof(source->text) ? (size_t)textSize : sizeof(source->text) - 1;
        memcpy(source->text, text, size);
    }
    exr_finish(&file);
    return isThere ? SW_SUCCESS
                   : swFail(host, SW_ERROR_FORMAT,
                            "%s does not say what it was made from; it was not written by swWriteRaster().", path);
}
#else
static swResult refuse(const swHost* host, const char* path)
{
    return swFail(host, SW_ERROR_UNSUPPORTED,
                  "%s would be an EXR image, which this build does not know: configure with "
                  "libopenexr-dev installed.",
                  path);
}
#endif

swResult swWriteRaster(const swHost* host, const char* path, const swRaster* raster, const char* madeFrom,
                       uint64_t sourceHash)
{
    SW_REQUIRE(swIsHostValid(host) && path != NULL && raster != NULL, SW_ERROR_INVALID, host,
               "swWriteRaster() needs a host, a path and a raster");
    const char* source = madeFrom != NULL ? madeFrom : "";
    SW_REQUIRE(strlen(source) < SW_MAX_RASTER_SOURCE, SW_ERROR_INVALID, host,
               "swWriteRaster() takes a source of at most %d bytes", SW_MAX_RASTER_SOURCE - 1);
    swRasterInfo info = swRaster_GetInfo(raster);
    if (info.channels != 1 || info.frames != 1)
    {
        return swFail(host, SW_ERROR_UNSUPPORTED, "%s has %d channels and %d frames; only rasters of one are written.",
                      info.name, info.channels, info.frames);
    }
#if SW_HAS_EXR
    return writeExr(host, path, raster, source, sourceHash);
#else
    (void)sourceHash;
    return refuse(host, path);
#endif
}

swResult swReadRasterSource(const swHost* host, const char* path, swRasterSource* source)
{
    SW_REQUIRE(swIsHostValid(host) && path != NULL && source != NULL, SW_ERROR_INVALID, host,
               "swReadRasterSource() needs a host, a path and a place for the answer");
    *source = (swRasterSource){.hash = 0};
#if SW_HAS_EXR
    return readSource(host, path, source);
#else
    return refuse(host, path);
#endif
}
