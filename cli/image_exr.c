// SPDX-License-Identifier: MIT
// EXR through OpenEXR's C core: one scan-line part, ZIP over 16 lines, channels in the file's alphabetical order B, G,
// R.

#include "image.h"

#include <errno.h>
#include <openexr.h>
#include <string.h>

#include "output.h"
#include "common.h"

static void OnExrError(exr_const_context_t context, exr_result_t code, const char* message)
{
    (void)context;
    (void)code;
    (void)message; // one sentence of ours follows
}

static bool WriteHeader(exr_context_t file, int width, int height, bool asHalf)
{
    static const char* const names[3] = {"B", "G", "R"};
    int part = 0;
    exr_pixel_type_t type = asHalf ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT;
    if (exr_add_part(file, "sea", EXR_STORAGE_SCANLINE, &part) != EXR_ERR_SUCCESS ||
        exr_initialize_required_attr_simple(file, part, width, height, EXR_COMPRESSION_ZIP) != EXR_ERR_SUCCESS)
    {
        return false;
    }
    for (int i = 0; i < 3; ++i)
    {
        if (exr_add_channel(file, part, names[i], type, EXR_PERCEPTUALLY_LINEAR, 1, 1) != EXR_ERR_SUCCESS)
        {
            return false;
        }
    }
    return exr_write_header(file) == EXR_ERR_SUCCESS;
}

// One chunk of lines that starts at `row`. The encoder keeps its buffers from chunk to chunk.
static bool WriteChunk(exr_context_t file, exr_encode_pipeline_t* encoder, int row, int width, const float* rgb)
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
    const float* first = rgb + (size_t)row * (size_t)width * 3;
    for (int i = 0; i < encoder->channel_count; ++i)
    {
        exr_coding_channel_info_t* channel = encoder->channels + i;
        channel->encode_from_ptr = (const uint8_t*)(first + 2 - i); // B, G, R of red first
        channel->user_pixel_stride = 3 * sizeof(float);
        channel->user_line_stride = 3 * (int32_t)sizeof(float) * width;
        channel->user_bytes_per_element = sizeof(float);
        channel->user_data_type = EXR_PIXEL_FLOAT;
    }
    if (row == 0 && exr_encoding_choose_default_routines(file, 0, encoder) != EXR_ERR_SUCCESS)
    {
        return false;
    }
    return exr_encoding_run(file, 0, encoder) == EXR_ERR_SUCCESS;
}

static bool EncodeExr(exr_context_t file, int width, int height, const float* rgb, bool asHalf)
{
    int32_t linesPerChunk = 0;
    if (!WriteHeader(file, width, height, asHalf) ||
        exr_get_scanlines_per_chunk(file, 0, &linesPerChunk) != EXR_ERR_SUCCESS)
    {
        return false;
    }
    exr_encode_pipeline_t encoder = EXR_ENCODE_PIPELINE_INITIALIZER;
    bool isWritten = true;
    for (int row = 0; row < height && isWritten; row += linesPerChunk)
    {
        isWritten = WriteChunk(file, &encoder, row, width, rgb);
    }
    exr_encoding_destroy(file, &encoder);
    return isWritten;
}

bool WriteExr(const char* path, int width, int height, const float* rgb, bool asHalf)
{
    OutputFile output;
    if (!BeginOutput(&output, path))
    {
        return false;
    }
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    settings.error_handler_fn = OnExrError;
    exr_context_t file = NULL;
    errno = 0;
    exr_result_t opened = exr_start_write(&file, output.path, EXR_WRITE_FILE_DIRECTLY, &settings);
    bool isWritten = opened == EXR_ERR_SUCCESS && EncodeExr(file, width, height, rgb, asHalf);
    int reason = errno;
    if (opened == EXR_ERR_SUCCESS)
    {
        isWritten = exr_finish(&file) == EXR_ERR_SUCCESS && isWritten;
    }
    if (!isWritten)
    {
        Complain("cannot write %s: %s", path, reason != 0 ? strerror(reason) : "OpenEXR failed");
    }
    return EndOutput(&output, isWritten);
}
