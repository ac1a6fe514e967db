// SPDX-License-Identifier: MIT
// Rasters in files of each kind: the numbers, to the bit, and where they lie. Files are made here by the libraries
// themselves.
#include "support/cmocka_setup.h"
#include "support/raster_file.h"
#if SW_HAS_NETCDF
#include "support/netcdf_maker.h"
#endif

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#if SW_HAS_PNG
#include <png.h>
#endif
#if SW_HAS_EXR
#include <openexr.h>
#endif
#if SW_HAS_TIFF
#include <tiffio.h>
#endif

#include <seaway/files.h>

static void WriteBytes(const void* bytes, size_t size)
{
    FILE* file = fopen(s_path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

// Drops the end of the file, or changes a byte of it.
static void Damage(size_t keep, size_t at)
{
    static unsigned char bytes[1 << 20];
    FILE* file = fopen(s_path, "rb");
    assert_non_null(file);
    size_t size = fread(bytes, 1, sizeof(bytes), file);
    fclose(file);
    bytes[at < size ? at : 0] ^= at > 0 ? 0x5a : 0;
    WriteBytes(bytes, keep < size ? keep : size);
}

// Rounded at no place of 24 bits.
static float Value(int column, int row)
{
    return 0.1f * (float)(column - 3) + 17.7f * (float)(row - 2) - 1234.5678f;
}

static void CheckSame(const swRaster* raster, int width, int height)
{
    swRasterInfo info = swRaster_GetInfo(raster);
    assert_int_equal(info.width, width);
    assert_int_equal(info.height, height);
    for (int i = 0; i < width * height; ++i)
    {
        float expected = Value(i % width, i / width);
        assert_memory_equal(&swRaster_GetValues(raster)[i], &expected, sizeof(float));
    }
}

// ---- without a heading ----

static void NumbersWithoutAHeadingAreReadAsTheyAreSaidToBe(void** state)
{
    (void)state;
    const unsigned char words[] = {0, 0, 1, 0, 0xff, 0xff, 0, 0x80, 0xff, 0x7f, 0x10, 0x27};
    WriteBytes(words, sizeof(words));
    swRasterFileDef def = swDefaultRasterFileDef();
    def.rawWidth = 3;
    def.rawHeight = 2;
    def.numbers = SW_RASTER_INT16;
    def.spacingEast = 10.0;
    def.spacingNorth = 20.0;
    def.imageEast = 100.0;
    def.imageNorth = 50.0;
    swRaster* raster = Read(&def);
    const float whole[6] = {0.0f, 1.0f, -1.0f, -32768.0f, 32767.0f, 10000.0f};
    assert_memory_equal(swRaster_GetValues(raster), whole, sizeof(whole));
    swRasterInfo info = swRaster_GetInfo(raster);
    assert_true(info.x == 100.0 && info.z == -50.0 && info.spacingX == 10.0 && info.spacingZ == 20.0);
    assert_string_equal(s_messages, "");
    swDestroyRaster(raster);
    def.numbers = SW_RASTER_UINT16;
    def.scale = 0.5;
    def.offset = -100.0;
    def.missing = 65535.0;
    raster = Read(&def);
    assert_true(swRaster_GetValues(raster)[3] == 16284.0f && isnan(swRaster_GetValues(raster)[2]));
    swDestroyRaster(raster);
    def = swDefaultRasterFileDef();
    def.rawWidth = 3;
    def.rawHeight = 1;
    raster = Read(&def); // floats; the middle of the image is the origin
    info = swRaster_GetInfo(raster);
    assert_true(info.x == -1.0 && info.z == 0.0 && info.spacingX == 1.0);
    assert_non_null(strstr(s_messages, "does not say where it lies"));
    assert_memory_equal(swRaster_GetValues(raster), words, 4);
    swDestroyRaster(raster);
    def.rawHeight = 2;
    CheckRefused(&def, SW_ERROR_FORMAT, "3 x 2 numbers of 4 bytes are 24. Set rawWidth");
#ifdef NDEBUG // misuse: where asserts are on, the program stops
    def.rawHeight = 0;
    CheckRefused(&def, SW_ERROR_INVALID, "both are above 0, or both 0");
#endif
}

static void ImagesAreCroppedAsTheyAreRead(void** state)
{
    (void)state;
    float values[6 * 5];
    for (int i = 0; i < 30; ++i)
    {
        values[i] = Value(i % 6, i / 6);
    }
    WriteBytes(values, sizeof(values));
    swRasterFileDef def = swDefaultRasterFileDef();
    def.rawWidth = 6;
    def.rawHeight = 5;
    def.imageEast = 0.0;
    def.imageNorth = 0.0;
    def.west = 1.0;
    def.east = 3.5;
    def.north = 1.0; // z
    def.south = 3.0;
    swRaster* raster = Read(&def);
    swRasterInfo info = swRaster_GetInfo(raster);
    assert_true(info.width == 3 && info.height == 3 && info.x == 1.0 && info.z == 1.0);
    assert_true(swRaster_GetValues(raster)[0] == Value(1, 1) && swRaster_GetValues(raster)[8] == Value(3, 3));
    swDestroyRaster(raster);
    def.memoryLimit = 35;
    CheckRefused(&def, SW_ERROR_LIMIT, "Crop it");
}

// ---- PNG ----

#if SW_HAS_PNG
static void WritePng(int width, int height, int depth, int colorType, bool isInterlaced, const unsigned char* rows)
{
    FILE* file = fopen(s_path, "wb");
    assert_non_null(file);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, depth, colorType,
                 isInterlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (colorType == PNG_COLOR_TYPE_PALETTE)
    {
        const png_color colors[2] = {{0, 0, 0}, {255, 255, 255}};
        png_set_PLTE(png, info, colors, 2);
    }
    else
    {
        png_set_gAMA(png, info, 0.45455); // heights know no gamma
    }
    png_write_info(png, info);
    png_bytep pointers[64];
    size_t rowBytes = png_get_rowbytes(png, info);
    for (int i = 0; i < height; ++i)
    {
        pointers[i] = (png_bytep)(uintptr_t)(rows + (size_t)i * rowBytes);
    }
    png_write_image(png, pointers);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    fclose(file);
}

static void PngSamplesAreTheirNumbers(void** state)
{
    (void)state;
    unsigned char rows[9 * 7 * 2];
    for (int i = 0; i < 9 * 7; ++i)
    {
        int number = 997 * i + 5;
        rows[2 * i] = (unsigned char)(number >> 8);
        rows[2 * i + 1] = (unsigned char)number;
    }
    for (int way = 0; way < 2; ++way)
    {
        WritePng(9, 7, 16, PNG_COLOR_TYPE_GRAY, way == 1, rows);
        swRasterFileDef def = swDefaultRasterFileDef();
        def.spacingEast = def.spacingNorth = 2.0;
        def.imageEast = def.imageNorth = 0.0;
        def.scale = 0.01;
        def.offset = -300.0;
        swRaster* raster = Read(&def);
        assert_string_equal(s_messages, "");
        assert_int_equal(swRaster_GetInfo(raster).width, 9);
        for (int i = 0; i < 9 * 7; ++i)
        {
            assert_true(swRaster_GetValues(raster)[i] == (float)(-300.0 + 0.01 * (double)((997 * i + 5) & 0xffff)));
        }
        swDestroyRaster(raster);
    }
}

static void PngChannelsAreChosenByName(void** state)
{
    (void)state;
    const unsigned char rows[] = {1, 2, 3, 4, 5, 6, 7, 8};
    WritePng(2, 1, 8, PNG_COLOR_TYPE_RGBA, false, rows);
    swRasterFileDef def = swDefaultRasterFileDef();
    def.variable = "B";
    swRaster* raster = Read(&def);
    assert_true(swRaster_GetValues(raster)[0] == 3.0f && swRaster_GetValues(raster)[1] == 7.0f);
    assert_non_null(strstr(s_messages, "8 bits: heights lie on 256 steps"));
    swDestroyRaster(raster);
    def.variable = "Y";
    CheckRefused(&def, SW_ERROR_FORMAT, "has no channel Y; its channels are RGBA");
}

static void PngThatHoldsNoHeightsIsRefused(void** state)
{
    (void)state;
    unsigned char rows[40 * 40 * 2];
    for (size_t i = 0; i < sizeof(rows); ++i)
    {
        rows[i] = (unsigned char)(i * i * 31 + i / 7);
    }
    WritePng(2, 1, 8, PNG_COLOR_TYPE_PALETTE, false, (const unsigned char[]){0, 1});
    CheckRefused(NULL, SW_ERROR_FORMAT, "a palette's colours; heights need 16 bits of grey");
    WritePng(40, 40, 16, PNG_COLOR_TYPE_GRAY, false, rows);
    Damage(2000, 0);
    CheckRefused(NULL, SW_ERROR_FORMAT, "is damaged");
    WritePng(40, 40, 16, PNG_COLOR_TYPE_GRAY, false, rows);
    Damage(SIZE_MAX, 1000);
    CheckRefused(NULL, SW_ERROR_FORMAT, "is damaged");
}
#endif

// ---- EXR ----

#if SW_HAS_EXR
// Channels in the alphabetical order of the file, all of one kind, of Value() + 1000 times their number.
static void WriteExr(int width, int height, int channelCount, const char* const* names, exr_pixel_type_t type,
                     bool isTiled)
{
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    exr_context_t file = NULL;
    int part = 0;
    assert_int_equal(exr_start_write(&file, s_path, EXR_WRITE_FILE_DIRECTLY, &settings), EXR_ERR_SUCCESS);
    assert_int_equal(exr_add_part(file, "p", isTiled ? EXR_STORAGE_TILED : EXR_STORAGE_SCANLINE, &part), 0);
    assert_int_equal(exr_initialize_required_attr_simple(file, part, width, height, EXR_COMPRESSION_NONE), 0);
    if (isTiled)
    {
        assert_int_equal(exr_set_tile_descriptor(file, part, 4, 4, EXR_TILE_ONE_LEVEL, EXR_TILE_ROUND_DOWN), 0);
    }
    for (int i = 0; i < channelCount; ++i)
    {
        assert_int_equal(exr_add_channel(file, part, names[i], type, EXR_PERCEPTUALLY_LINEAR, 1, 1), 0);
    }
    assert_int_equal(exr_write_header(file), 0);
    exr_encode_pipeline_t encoder = EXR_ENCODE_PIPELINE_INITIALIZER;
    float block[4][64 * 64];
    int step = isTiled ? 4 : 1, wide = isTiled ? 4 : width;
    bool isFirst = true;
    for (int row = 0; row < height; row += step)
    {
        for (int column = 0; column < width; column += wide)
        {
            exr_chunk_info_t chunk;
            assert_int_equal(isTiled ? exr_write_tile_chunk_info(file, 0, column / 4, row / 4, 0, 0, &chunk)
                                     : exr_write_scanline_chunk_info(file, 0, row, &chunk),
                             0);
            assert_int_equal(isFirst ? exr_encoding_initialize(file, 0, &chunk, &encoder)
                                     : exr_encoding_update(file, 0, &chunk, &encoder),
                             0);
            for (int c = 0; c < channelCount; ++c)
            {
                for (int k = 0; k < chunk.width * chunk.height; ++k)
                {
                    block[c][k] = Value(column + k % chunk.width, row + k / chunk.width) + 1000.0f * (float)c;
                }
                exr_coding_channel_info_t* channel = &encoder.channels[c];
                channel->encode_from_ptr = (const uint8_t*)block[c];
                channel->user_pixel_stride = 4;
                channel->user_line_stride = 4 * chunk.width;
                channel->user_bytes_per_element = 4;
                channel->user_data_type = EXR_PIXEL_FLOAT;
            }
            assert_int_equal(isFirst ? exr_encoding_choose_default_routines(file, 0, &encoder) : 0, 0);
            assert_int_equal(exr_encoding_run(file, 0, &encoder), 0);
            isFirst = false;
        }
    }
    exr_encoding_destroy(file, &encoder);
    assert_int_equal(exr_finish(&file), 0);
}

static void ExrIsReadInLinesAndTiles(void** state)
{
    (void)state;
    const char* const one[] = {"height"};
    const char* const colours[] = {"B", "G", "R"};
    for (int way = 0; way < 2; ++way)
    {
        WriteExr(11, 9, 1, one, EXR_PIXEL_FLOAT, way == 1);
        swRaster* raster = Read(NULL);
        CheckSame(raster, 11, 9);
        swDestroyRaster(raster);
        WriteExr(11, 9, 3, colours, EXR_PIXEL_FLOAT, way == 1);
        swRasterFileDef def = swDefaultRasterFileDef();
        def.variable = "B";
        def.imageEast = def.imageNorth = 0.0;
        raster = Read(&def);
        CheckSame(raster, 11, 9);
        swDestroyRaster(raster);
        def.variable = NULL; // R
        def.west = 5.0;
        def.north = 6.0;
        raster = Read(&def);
        assert_true(swRaster_GetInfo(raster).width == 6 && swRaster_GetInfo(raster).height == 3);
        assert_true(swRaster_GetValues(raster)[0] == Value(5, 6) + 2000.0f);
        swDestroyRaster(raster);
        def.variable = "depth";
        CheckRefused(&def, SW_ERROR_FORMAT, "has no channel depth; its first is B");
    }
}

static void HalvesOfExrAreTheirNumbers(void** state)
{
    (void)state;
    const char* const one[] = {"Y"};
    WriteExr(5, 4, 1, one, EXR_PIXEL_HALF, false);
    swRaster* raster = Read(NULL);
    for (int i = 0; i < 20; ++i)
    {
        assert_true(fabsf(swRaster_GetValues(raster)[i] - Value(i % 5, i / 5)) <= 0.5f); // 11 bits at 1234
    }
    swDestroyRaster(raster);
}

// Of Value(), or noise that nothing compresses; the first cell is unknown.
static swRaster* MakeRaster(int width, int height, bool isNoise)
{
    swHost host = MakeHost();
    swRasterDef def = swDefaultRasterDef();
    def.width = width;
    def.height = height;
    def.x = 12.3456789012345;
    def.z = -1e6 / 3.0;
    def.spacingX = 0.1;
    def.spacingZ = 100.0 / 3.0;
    float* values = malloc((size_t)width * (size_t)height * sizeof(float));
    assert_non_null(values);
    for (int i = 0; i < width * height; ++i)
    {
        uint32_t noise = (uint32_t)i * 2654435761u;
        noise ^= noise >> 13;
        values[i] = isNoise ? (float)(noise * 2246822519u) * 1e-5f : Value(i % width, i / width);
    }
    values[0] = NAN;
    def.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    free(values);
    return raster;
}

static void WhatIsWrittenIsReadToTheBitAtItsPlace(void** state)
{
    (void)state;
    const int sizes[][2] = {{1, 1}, {3, 1}, {37, 53}, {64, 65}};
    for (int i = 0; i < 8; ++i)
    {
        swHost host = MakeHost();
        swRaster* made = MakeRaster(sizes[i / 2][0], sizes[i / 2][1], i % 2 == 1);
        assert_int_equal(swWriteRaster(&host, s_path, made, "a test", 0x0123456789abcdefu), SW_SUCCESS);
        swRaster* raster = Read(NULL);
        assert_string_equal(s_messages, "");
        assert_true(swRaster_GetInfo(raster).hash == swRaster_GetInfo(made).hash); // place and values
        swRasterSource source;
        assert_int_equal(swReadRasterSource(&host, s_path, &source), SW_SUCCESS);
        assert_string_equal(source.text, "a test");
        assert_true(source.hash == 0x0123456789abcdefu);
        swDestroyRaster(raster);
        swDestroyRaster(made);
    }
}

static void ImagesThatDoNotSayWhatTheyWereMadeFromAreNamed(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swRasterSource source;
    const char* const one[] = {"Y"};
    WriteExr(5, 4, 1, one, EXR_PIXEL_FLOAT, false);
    assert_int_equal(swReadRasterSource(&host, s_path, &source), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "does not say what it was made from"));
    assert_int_equal(swReadRasterSource(&host, "no_such_file.exr", &source), SW_ERROR_FILE);
    WriteBytes("text", 4);
    assert_int_equal(swReadRasterSource(&host, s_path, &source), SW_ERROR_FORMAT);
}

static void DamagedExrIsRefused(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swRaster* made = MakeRaster(64, 64, false);
    assert_int_equal(swWriteRaster(&host, s_path, made, NULL, 1), SW_SUCCESS);
    Damage(3000, 0);
    CheckRefused(NULL, SW_ERROR_FORMAT, "cannot be read as an EXR image");
    assert_int_equal(swWriteRaster(&host, s_path, made, NULL, 1), SW_SUCCESS);
    Damage(100, 0);
    CheckRefused(NULL, SW_ERROR_FORMAT, "cannot be read as an EXR image");
    assert_int_equal(swWriteRaster(&host, "no_such_folder/floor.exr", made, NULL, 1), SW_ERROR_FILE);
    swDestroyRaster(made);
}
#endif

// ---- TIFF ----

#if SW_HAS_TIFF
typedef struct Tiff
{
    int width, height, bits, format;
    bool isTiled, isDegrees, isPoint, isTurned;
    int unit;
    const char* noData;
} Tiff;

static const TIFFFieldInfo GeoTags[] = {
    {33550, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, (char*)(uintptr_t) "ModelPixelScale"},
    {33922, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, (char*)(uintptr_t) "ModelTiepoint"},
    {34264, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, (char*)(uintptr_t) "ModelTransformation"},
    {34735, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1, (char*)(uintptr_t) "GeoKeyDirectory"},
    {42113, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, (char*)(uintptr_t) "GDALNoData"},
};

static void PutSample(const Tiff* kind, unsigned char* at, int column, int row)
{
    float single = Value(column, row);
    double wide = (double)single;
    int16_t whole = (int16_t)(column * 100 - row * 7);
    const void* from = kind->format != SAMPLEFORMAT_IEEEFP ? (const void*)&whole
                       : kind->bits == 64                  ? (const void*)&wide
                                                           : (const void*)&single;
    memcpy(at, from, (size_t)kind->bits / 8);
}

// The north-western corner of the image (or the middle of its first pixel) at 500, 800; pixels of 10 x 20, or a
// thousandth of that.
static void WriteTiff(const Tiff* kind)
{
    TIFF* tiff = TIFFOpen(s_path, "w");
    assert_non_null(tiff);
    TIFFMergeFieldInfo(tiff, GeoTags, 5);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, kind->width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, kind->height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, kind->bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, kind->format);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    double unit = kind->isDegrees ? 1e-3 : 1.0;
    double scale[3] = {10.0 * unit, 20.0 * unit, 0.0};
    double tie[6] = {0.0, 0.0, 0.0, kind->isDegrees ? 5.0 : 500.0, kind->isDegrees ? 52.0 : 800.0, 0.0};
    double turn[16] = {scale[0], 0.0, 0.0, tie[3], 0.0, -scale[1], 0.0, tie[4], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    uint16_t keys[] = {1,    1, 0, 3,
                       1024, 0, 1, (uint16_t)(kind->isDegrees ? 2 : 1),
                       1025, 0, 1, (uint16_t)(kind->isPoint ? 2 : 1),
                       3076, 0, 1, (uint16_t)(kind->unit != 0 ? kind->unit : 9001)};
    if (kind->isTurned)
    {
        TIFFSetField(tiff, 34264, 16, turn);
    }
    else
    {
        TIFFSetField(tiff, 33550, 3, scale);
        TIFFSetField(tiff, 33922, 6, tie);
    }
    TIFFSetField(tiff, 34735, 16, keys);
    if (kind->noData != NULL)
    {
        TIFFSetField(tiff, 42113, kind->noData);
    }
    unsigned char bytes[64 * 64 * 8];
    size_t size = (size_t)kind->bits / 8;
    if (kind->isTiled)
    {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
        for (int row = 0; row < kind->height; row += 16)
        {
            for (int column = 0; column < kind->width; column += 16)
            {
                for (int i = 0; i < 256; ++i)
                {
                    PutSample(kind, bytes + (size_t)i * size, column + i % 16, row + i / 16);
                }
                assert_true(TIFFWriteTile(tiff, bytes, (uint32_t)column, (uint32_t)row, 0, 0) > 0);
            }
        }
    }
    for (int row = 0; row < kind->height && !kind->isTiled; ++row)
    {
        for (int column = 0; column < kind->width; ++column)
        {
            PutSample(kind, bytes + (size_t)column * size, column, row);
        }
        assert_int_equal(TIFFWriteScanline(tiff, bytes, (uint32_t)row, 0), 1);
    }
    TIFFClose(tiff);
}

static void TiffIsReadInStripsAndTiles(void** state)
{
    (void)state;
    for (int way = 0; way < 8; ++way)
    {
        Tiff kind = {.width = 21,
                     .height = 18,
                     .bits = (way & 1) != 0 ? 64 : 32,
                     .format = SAMPLEFORMAT_IEEEFP,
                     .isTiled = (way & 2) != 0,
                     .isTurned = (way & 4) != 0};
        WriteTiff(&kind);
        swRaster* raster = Read(NULL);
        assert_string_equal(s_messages, "");
        CheckSame(raster, 21, 18);
        swRasterInfo info = swRaster_GetInfo(raster);
        assert_true(info.x == 505.0 && info.z == -790.0 && info.spacingX == 10.0 && info.spacingZ == 20.0);
        swDestroyRaster(raster);
        swRasterFileDef def = swDefaultRasterFileDef();
        def.west = 670.0; // beyond the first tile
        def.north = -460.0;
        raster = Read(&def);
        assert_true(swRaster_GetValues(raster)[0] == Value(17, 17));
        swDestroyRaster(raster);
    }
}

static void AreasAndPointsOfTiffAreHalfAPixelApart(void** state)
{
    (void)state;
    Tiff kind = {.width = 4, .height = 3, .bits = 16, .format = SAMPLEFORMAT_INT, .isPoint = true, .noData = "-7"};
    WriteTiff(&kind);
    swRaster* raster = Read(NULL);
    swRasterInfo info = swRaster_GetInfo(raster);
    assert_true(info.x == 500.0 && info.z == -800.0);
    assert_true(swRaster_GetValues(raster)[1] == 100.0f && isnan(swRaster_GetValues(raster)[4]));
    assert_int_equal(info.unknownCount, 1);
    swDestroyRaster(raster);
    kind.isDegrees = true;
    kind.isPoint = false;
    WriteTiff(&kind);
    swRasterFileDef def = swDefaultRasterFileDef();
    def.originEast = 5.0;
    def.originNorth = 52.0;
    raster = Read(&def);
    info = swRaster_GetInfo(raster); // a degree of longitude and one of latitude there are 68,677.6 and 111,267.0 m
    assert_true(fabs(info.spacingX - 686.776) < 0.01 && fabs(info.x - 343.388) < 0.01);
    assert_true(fabs(info.spacingZ - 2225.34) < 0.04 && fabs(info.z - 1112.67) < 0.02);
    swDestroyRaster(raster);
}

static void TiffThatHoldsNoHeightsIsRefused(void** state)
{
    (void)state;
    Tiff kind = {.width = 40, .height = 30, .bits = 16, .format = SAMPLEFORMAT_INT, .unit = 9002};
    WriteTiff(&kind);
    CheckRefused(NULL, SW_ERROR_FORMAT, "coordinates of unit 9002");
    kind.unit = 0;
    WriteTiff(&kind);
    Damage(200, 0);
    CheckRefused(NULL, SW_ERROR_FORMAT, "cannot be read as TIFF");
    WriteBytes("II*\0\0\0\0\0", 8);
    CheckRefused(NULL, SW_ERROR_FORMAT, "cannot be read as TIFF");
}
#endif

// ---- netCDF: half a cell, and the 180th meridian ----

#if SW_HAS_NETCDF
static void WriteGmt(int nodeOffset)
{
    int file = MakeNetcdf(s_path, 0);
    int side = AddDimension(file, "side", 2), all = AddDimension(file, "xysize", 12);
    int x = AddVariable(file, "x_range", NC_DOUBLE, 1, &side), y = AddVariable(file, "y_range", NC_DOUBLE, 1, &side);
    int counts = AddVariable(file, "dimension", NC_INT, 1, &side), z = AddVariable(file, "z", NC_FLOAT, 1, &all);
    AddText(file, x, "units", "metres");
    AddNumber(file, z, "node_offset", NC_INT, nodeOffset);
    CheckNetcdf(nc_enddef(file));
    double values[12];
    for (int i = 0; i < 12; ++i)
    {
        values[i] = (double)Value(i % 4, i / 4);
    }
    PutNumbers(file, x, (double[]){0.0, 12.0});
    PutNumbers(file, y, (double[]){0.0, 12.0});
    PutNumbers(file, counts, (double[]){4.0, 3.0});
    PutNumbers(file, z, values);
    CheckNetcdf(nc_close(file));
}

static void CellsAndLinesOfGmtAreHalfACellApart(void** state)
{
    (void)state;
    WriteGmt(0);
    swRaster* raster = Read(NULL);
    CheckSame(raster, 4, 3);
    swRasterInfo info = swRaster_GetInfo(raster);
    assert_true(info.x == 0.0 && info.z == -12.0 && info.spacingX == 4.0 && info.spacingZ == 6.0);
    swDestroyRaster(raster);
    WriteGmt(1);
    raster = Read(NULL);
    CheckSame(raster, 4, 3);
    info = swRaster_GetInfo(raster);
    assert_true(info.x == 1.5 && info.z == -10.0 && info.spacingX == 3.0 && info.spacingZ == 4.0);
    swDestroyRaster(raster);
}

static void LongitudesMayRunOverTheMeridian(void** state)
{
    (void)state;
    int file = MakeNetcdf(s_path, NC_NETCDF4);
    int east = AddDimension(file, "lon", 4), north = AddDimension(file, "lat", 2);
    int eastAxis = AddVariable(file, "lon", NC_DOUBLE, 1, &east),
        northAxis = AddVariable(file, "lat", NC_DOUBLE, 1, &north);
    int heights = AddVariable(file, "z", NC_FLOAT, 2, (int[]){north, east});
    CheckNetcdf(nc_enddef(file));
    PutNumbers(file, eastAxis, (double[]){179.5, -180.0, -179.5, -179.0});
    PutNumbers(file, northAxis, (double[]){-0.25, 0.25});
    PutNumbers(file, heights, (double[]){1, 2, 3, 4, 5, 6, 7, 8});
    CheckNetcdf(nc_close(file));
    swRasterFileDef def = swDefaultRasterFileDef();
    def.coordinates = SW_RASTER_DEGREES;
    def.originNorth = 0.0;
    const double origins[] = {180.0, -180.0, 540.0};
    for (int i = 0; i < 3; ++i)
    {
        def.originEast = origins[i];
        swRaster* raster = Read(&def);
        float value = 0.0f;
        double degree = 111319.49; // on the equator
        swRaster_Sample(raster, 1, &(swPosXZ){0.5 * degree, -0.25 * 110574.2}, &value);
        assert_true(fabsf(value - 7.0f) < 1e-3f);
        swDestroyRaster(raster);
    }
}
#endif

static void PointsMayLieOnBothSidesOfTheMeridian(void** state)
{
    (void)state;
    const char text[] = "179.9 10 1\n180 10 2\n-179.9 10 3\n179.9 10.1 4\n-180 10.1 5\n-179.9 10.1 6\n";
    WriteBytes(text, sizeof(text) - 1);
    swRaster* raster = Read(NULL);
    assert_int_equal(swRaster_GetInfo(raster).width, 3);
    const float expected[6] = {4.0f, 5.0f, 6.0f, 1.0f, 2.0f, 3.0f};
    assert_memory_equal(swRaster_GetValues(raster), expected, sizeof(expected));
    swDestroyRaster(raster);
    const char metres[] = "0 0 1\n200 0 2\n"; // no longitudes, though they could be
    WriteBytes(metres, sizeof(metres) - 1);
    raster = Read(NULL);
    assert_true(swRaster_GetInfo(raster).x == 0.0 && swRaster_GetValues(raster)[1] == 2.0f);
    swDestroyRaster(raster);
}

static void DefsOutOfRangeAreRefused(void** state)
{
    (void)state;
#ifdef NDEBUG // misuse: where asserts are on, the program stops
    WriteBytes("0 0 1\n", 6);
    swRasterFileDef def = swDefaultRasterFileDef();
    def.scale = (double)NAN;
    CheckRefused(&def, SW_ERROR_INVALID, "both are within 1e6");
    def = swDefaultRasterFileDef();
    def.spacingEast = 0.0;
    CheckRefused(&def, SW_ERROR_INVALID, "above 0");
    def = swDefaultRasterFileDef();
    def.numbers = SW_RASTER_NUMBERS_COUNT;
    CheckRefused(&def, SW_ERROR_INVALID, "numbers is 3");
    def = swDefaultRasterFileDef();
    def.imageEast = (double)INFINITY;
    CheckRefused(&def, SW_ERROR_INVALID, "infinite place");
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(NumbersWithoutAHeadingAreReadAsTheyAreSaidToBe),
        cmocka_unit_test(ImagesAreCroppedAsTheyAreRead),
#if SW_HAS_PNG
        cmocka_unit_test(PngSamplesAreTheirNumbers),
        cmocka_unit_test(PngChannelsAreChosenByName),
        cmocka_unit_test(PngThatHoldsNoHeightsIsRefused),
#endif
#if SW_HAS_EXR
        cmocka_unit_test(ExrIsReadInLinesAndTiles),
        cmocka_unit_test(HalvesOfExrAreTheirNumbers),
        cmocka_unit_test(WhatIsWrittenIsReadToTheBitAtItsPlace),
        cmocka_unit_test(ImagesThatDoNotSayWhatTheyWereMadeFromAreNamed),
        cmocka_unit_test(DamagedExrIsRefused),
#endif
#if SW_HAS_TIFF
        cmocka_unit_test(TiffIsReadInStripsAndTiles),
        cmocka_unit_test(AreasAndPointsOfTiffAreHalfAPixelApart),
        cmocka_unit_test(TiffThatHoldsNoHeightsIsRefused),
#endif
#if SW_HAS_NETCDF
        cmocka_unit_test(CellsAndLinesOfGmtAreHalfACellApart),
        cmocka_unit_test(LongitudesMayRunOverTheMeridian),
#endif
        cmocka_unit_test(PointsMayLieOnBothSidesOfTheMeridian),
        cmocka_unit_test(DefsOutOfRangeAreRefused),
    };
    return cmocka_run_group_tests(tests, MakePath, RemovePath);
}
