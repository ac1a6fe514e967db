// SPDX-License-Identifier: MIT
// TIFF images as heights, placed by the tags of GeoTIFF [OGC 19-008]: a point of the image that is tied to a place, the
// size of a pixel, and whether a pixel is an area, whose middle is half a pixel farther, or a point.

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tiffio.h>

#include "files/raster_grid.h"

#define TAG_PIXEL_SCALE 33550
#define TAG_TIE_POINTS 33922
#define TAG_TRANSFORMATION 34264
#define TAG_GEO_KEYS 34735
#define TAG_METADATA 42112 // GDAL's, as the next
#define TAG_NO_DATA 42113

#define KEY_MODEL_TYPE 1024
#define KEY_RASTER_TYPE 1025
#define KEY_PROJECTION 3072
#define KEY_LINEAR_UNITS 3076
#define UNIT_METRE 9001

typedef struct TiffGrid
{
    swRasterGrid grid;
    TIFF* tiff;
    char message[200];
    uint32_t width, height;
    uint16_t bits, format, samples;
    uint16_t sample;   // which of them is read
    bool isPoint;      // a pixel's place is its middle
    bool isSouthFirst; // the rows run northwards
    char unit;
    double noData;
    bool hasNoData;
    double scale, offset; // a number n of the file means offset + scale n
} TiffGrid;

// libtiff's own complaints, of which the first is told.
static int onError(TIFF* tiff, void* context, const char* module, const char* format, va_list arguments)
{
    TiffGrid* reader = context;
    (void)tiff;
    (void)module;
    if (reader->message[0] == '\0')
    {
        vsnprintf(reader->message, sizeof(reader->message), format, arguments);
    }
    return 1;
}

static int onWarning(TIFF* tiff, void* context, const char* module, const char* format, va_list arguments)
{
    (void)tiff;
    (void)context;
    (void)module;
    (void)format;
    (void)arguments; // of tags that libtiff does not know, which GeoTIFF's are
    return 1;
}

static swResult failRead(const TiffGrid* reader)
{
    return swFail(reader->grid.host, SW_ERROR_FORMAT, "%s cannot be read as TIFF: %s", reader->grid.name,
                  reader->message[0] != '\0' ? reader->message : "it is damaged.");
}

// A tag that libtiff does not know by itself: its numbers, and how many there are.
static const void* findTag(TIFF* tiff, uint32_t tag, TIFFDataType type, uint32_t* count)
{
    const TIFFField* field = TIFFFindField(tiff, tag, TIFF_ANY);
    const void* data = NULL;
    if (field == NULL || TIFFFieldDataType(field) != type || !TIFFFieldPassCount(field))
    {
        return NULL;
    }
    if (TIFFFieldReadCount(field) == TIFF_VARIABLE2)
    {
        return TIFFGetField(tiff, tag, count, &data) ? data : NULL;
    }
    uint16_t few = 0;
    bool isThere = TIFFFieldReadCount(field) == TIFF_VARIABLE && TIFFGetField(tiff, tag, &few, &data);
    *count = few;
    return isThere ? data : NULL;
}

// Of the directory of keys: four numbers a key, of which the last is its value where the second is 0.
static int findKey(const uint16_t* keys, uint32_t count, int key)
{
    for (uint32_t i = 4; i + 3 < count; i += 4)
    {
        if (keys[i] == key && keys[i + 1] == 0)
        {
            return keys[i + 3];
        }
    }
    return -1;
}

// Web Mercator's metres are longer than real ones by 1 over the cosine of the latitude.
static void warnOfProjection(const TiffGrid* reader, int projection)
{
    if (projection == 3857 || projection == 3785)
    {
        swLog(reader->grid.host, SW_LOG_WARNING,
              "%s is in Web Mercator (EPSG %d), whose metres are no true ones away from the equator: twice as long at "
              "60 degrees north. Warp it to UTM or to degrees first.",
              reader->grid.name, projection);
    }
}

static swResult readKeys(TiffGrid* reader)
{
    uint32_t count = 0;
    const uint16_t* keys = findTag(reader->tiff, TAG_GEO_KEYS, TIFF_SHORT, &count);
    if (keys == NULL)
    {
        return SW_SUCCESS;
    }
    int model = findKey(keys, count, KEY_MODEL_TYPE), unit = findKey(keys, count, KEY_LINEAR_UNITS);
    reader->isPoint = findKey(keys, count, KEY_RASTER_TYPE) == 2;
    reader->unit = model == 2 ? 'd' : model == 1 ? 'm' : 0;
    if (model == 1 && unit > 0 && unit != UNIT_METRE && unit != 32767)
    {
        return swFail(
            reader->grid.host, SW_ERROR_FORMAT,
            "%s has coordinates of unit %d (EPSG); only metres (9001) and degrees are read. Convert it first.",
            reader->grid.name, unit);
    }
    warnOfProjection(reader, findKey(keys, count, KEY_PROJECTION));
    return SW_SUCCESS;
}

// The middle of the north-western pixel and the size of pixels.
static swResult readPlace(TiffGrid* reader, double spacing[2], double first[2])
{
    uint32_t scaleCount = 0, tieCount = 0, turnCount = 0;
    const double* scale = findTag(reader->tiff, TAG_PIXEL_SCALE, TIFF_DOUBLE, &scaleCount);
    const double* ties = findTag(reader->tiff, TAG_TIE_POINTS, TIFF_DOUBLE, &tieCount);
    const double* turn = findTag(reader->tiff, TAG_TRANSFORMATION, TIFF_DOUBLE, &turnCount);
    double half = reader->isPoint ? 0.0 : 0.5;
    if (scale != NULL && scaleCount >= 2 && ties != NULL && tieCount >= 6)
    {
        spacing[0] = scale[0];
        spacing[1] = scale[1];
        first[0] = ties[3] + scale[0] * (half - ties[0]);
        first[1] = ties[4] - scale[1] * (half - ties[1]);
    }
    else if (turn != NULL && turnCount >= 16)
    {
        if (turn[1] != 0.0 || turn[4] != 0.0 || !(turn[5] != 0.0))
        {
            return swFail(reader->grid.host, SW_ERROR_FORMAT,
                          "%s is turned against north; a raster's rows run eastwards. Warp it first.",
                          reader->grid.name);
        }
        reader->isSouthFirst = turn[5] > 0.0;
        spacing[0] = turn[0];
        spacing[1] = fabs(turn[5]);
        first[0] = turn[3] + half * turn[0];
        first[1] = turn[7] + turn[5] * (half + (reader->isSouthFirst ? reader->height - 1.0 : 0.0));
    }
    return SW_SUCCESS;
}

static void readNoData(TiffGrid* reader)
{
    uint32_t count = 0;
    const char* text = findTag(reader->tiff, TAG_NO_DATA, TIFF_ASCII, &count);
    char copy[64] = "";
    if (text == NULL || count == 0 || count >= sizeof(copy))
    {
        return;
    }
    memcpy(copy, text, count);
    char* end = NULL;
    reader->noData = strtod(copy, &end);
    reader->hasNoData = end != copy;
}

// What stands between `begin` and the next '<' in GDAL's XML, in lower case; false if it does not fit.
static bool copyItem(const char* begin, const char* end, char* text, size_t size)
{
    size_t count = 0;
    while (begin + count < end && begin[count] != '<')
    {
        count += 1;
    }
    for (size_t i = 0; i < count && count < size; ++i)
    {
        char c = begin[i] >= 'A' && begin[i] <= 'Z' ? (char)(begin[i] - 'A' + 'a') : begin[i];
        text[i] = c == '-' || c == '_' ? ' ' : c;
    }
    text[count < size ? count : 0] = '\0';
    return count > 0 && count < size;
}

// An item of a channel with a role, such as <Item name="SCALE" sample="0" role="scale">0.1</Item>.
static bool findItem(const char* xml, int channel, const char* role, char* text, size_t size)
{
    const char* all = xml + strlen(xml);
    char wanted[32];
    snprintf(wanted, sizeof(wanted), "sample=\"%d\"", channel);
    for (const char* item = strstr(xml, "<Item "); item != NULL; item = strstr(item + 1, "<Item "))
    {
        const char* close = strchr(item, '>');
        const char* sample = strstr(item, wanted);
        const char* found = strstr(item, role);
        if (close != NULL && sample != NULL && sample < close && found != NULL && found < close)
        {
            return copyItem(close + 1, all, text, size);
        }
    }
    return false;
}

// GDAL writes scale, offset and unit of the numbers into a tag of its own.
static swResult readMetadata(TiffGrid* reader)
{
    uint32_t count = 0;
    const char* tag = findTag(reader->tiff, TAG_METADATA, TIFF_ASCII, &count);
    reader->scale = 1.0;
    if (tag == NULL || count == 0)
    {
        return SW_SUCCESS;
    }
    char* xml = swAllocate(reader->grid.host, (size_t)count + 1);
    if (xml == NULL)
    {
        return swFail(reader->grid.host, SW_ERROR_NO_MEMORY, "No memory for a tag of %s.", reader->grid.name);
    }
    memcpy(xml, tag, count);
    xml[count] = '\0';
    char text[64];
    reader->scale = findItem(xml, reader->sample, "role=\"scale\"", text, sizeof(text)) ? strtod(text, NULL) : 1.0;
    reader->offset = findItem(xml, reader->sample, "role=\"offset\"", text, sizeof(text)) ? strtod(text, NULL) : 0.0;
    if (findItem(xml, reader->sample, "role=\"unittype\"", text, sizeof(text)))
    {
        double size = swKnowRasterUnit(&reader->grid, text);
        reader->scale *= size;
        reader->offset *= size;
    }
    swFree(reader->grid.host, xml, (size_t)count + 1);
    return SW_SUCCESS;
}

// A second image may say which pixels are known.
static void warnOfMask(TiffGrid* reader)
{
    bool hasMask = false;
    while (TIFFReadDirectory(reader->tiff) != 0 && !hasMask)
    {
        uint32_t kind = 0;
        TIFFGetField(reader->tiff, TIFFTAG_SUBFILETYPE, &kind);
        hasMask = (kind & FILETYPE_MASK) != 0;
    }
    if (hasMask)
    {
        swLog(reader->grid.host, SW_LOG_WARNING,
              "%s has a mask of the pixels that are known, which is not read: all count. Write a number for unknown "
              "ones into it, as gdalwarp -dstnodata does.",
              reader->grid.name);
    }
    reader->message[0] = '\0';
    TIFFSetDirectory(reader->tiff, 0);
}

// A channel is named by its number, from 1 on, or by R, G, B, A.
static swResult chooseSample(TiffGrid* reader)
{
    static const char letters[] = "RGBA";
    const char* asked = reader->grid.def->variable;
    long number = asked != NULL ? strtol(asked, NULL, 10) : 1;
    const char* letter = asked != NULL && asked[0] != '\0' && asked[1] == '\0' ? strchr(letters, asked[0]) : NULL;
    number = letter != NULL ? letter - letters + 1 : number;
    if (number < 1 || number > reader->samples)
    {
        return swFail(reader->grid.host, SW_ERROR_FORMAT,
                      "%s has no channel '%s'; it has %u, which are named by their numbers from 1 on, or R, G, B, A.",
                      reader->grid.name, asked, (unsigned)reader->samples);
    }
    reader->sample = (uint16_t)(number - 1);
    if (asked == NULL && reader->samples > 1)
    {
        swLog(reader->grid.host, SW_LOG_WARNING,
              "%s has %u channels, of which the first is read; swRasterFileDef::variable names another.",
              reader->grid.name, (unsigned)reader->samples);
    }
    return SW_SUCCESS;
}

static bool isKnownSample(const TiffGrid* reader)
{
    bool isFloat = reader->format == SAMPLEFORMAT_IEEEFP;
    return isFloat ? reader->bits == 32 || reader->bits == 64
                   : (reader->format == SAMPLEFORMAT_INT || reader->format == SAMPLEFORMAT_UINT) &&
                         (reader->bits == 8 || reader->bits == 16 || reader->bits == 32);
}

static swResult readHeading(TiffGrid* reader)
{
    TIFF* tiff = reader->tiff;
    uint16_t planes = PLANARCONFIG_CONTIG;
    warnOfMask(reader);
    if (!TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &reader->width) ||
        !TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &reader->height))
    {
        return failRead(reader);
    }
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &reader->bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &reader->format);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &reader->samples);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &planes);
    if (reader->width < 1 || reader->height < 1 || reader->width > 10000000 || reader->height > 10000000 ||
        reader->samples < 1 || (reader->samples > 1 && planes != PLANARCONFIG_CONTIG) || !isKnownSample(reader))
    {
        return swFail(
            reader->grid.host, SW_ERROR_FORMAT,
            "%s has %u x %u pixels of %u samples of %u bits, format %u; what is read is float of 32 or 64 bits "
            "and integers of 8, 16 or 32 bits. Convert it first.",
            reader->grid.name, reader->width, reader->height, (unsigned)reader->samples, (unsigned)reader->bits,
            (unsigned)reader->format);
    }
    double spacing[2] = {(double)NAN, (double)NAN}, first[2] = {(double)NAN, (double)NAN};
    swResult result = chooseSample(reader);
    result = result != SW_SUCCESS ? result : readKeys(reader);
    result = result != SW_SUCCESS ? result : readPlace(reader, spacing, first);
    readNoData(reader);
    result = result != SW_SUCCESS ? result : readMetadata(reader);
    return result != SW_SUCCESS
               ? result
               : swPlaceImageGrid(&reader->grid, (int)reader->width, (int)reader->height, spacing, first, reader->unit);
}

static float decode(const TiffGrid* reader, const unsigned char* at)
{
    double number = 0.0;
    if (reader->format == SAMPLEFORMAT_IEEEFP)
    {
        float single = 0.0f;
        memcpy(reader->bits == 64 ? (void*)&number : (void*)&single, at, reader->bits / 8);
        number = reader->bits == 64 ? number : (double)single;
    }
    else
    {
        bool isSigned = reader->format == SAMPLEFORMAT_INT;
        int8_t i8 = 0;
        int16_t i16 = 0;
        int32_t i32 = 0;
        uint16_t u16 = 0;
        uint32_t u32 = 0;
        memcpy(&i8, at, 1);
        memcpy(&i16, at, reader->bits >= 16 ? 2 : 1);
        memcpy(&i32, at, reader->bits == 32 ? 4 : 1);
        memcpy(&u16, &i16, 2);
        memcpy(&u32, &i32, 4);
        number = reader->bits == 8    ? (isSigned ? (double)i8 : (double)at[0])
                 : reader->bits == 16 ? (isSigned ? (double)i16 : (double)u16)
                                      : (isSigned ? (double)i32 : (double)u32);
    }
    bool isScaled = reader->scale != 1.0 || reader->offset != 0.0;
    bool isMissing = reader->hasNoData && (number == reader->noData || (float)number == (float)reader->noData);
    return isMissing ? NAN : (float)(isScaled ? reader->offset + reader->scale * number : number);
}

// A piece of the image, whose first pixel is at (column, row), into what is kept of it.
static void keepPiece(const TiffGrid* reader, const unsigned char* bytes, uint32_t pieceWidth, uint32_t pieceHeight,
                      uint32_t column, uint32_t row, float* values)
{
    const swRasterGrid* grid = &reader->grid;
    swImageRows rows = swGetImageRows(grid);
    size_t width = (size_t)(grid->east.end - grid->east.begin);
    size_t pixelSize = (size_t)reader->samples * reader->bits / 8;
    size_t first = (size_t)reader->sample * reader->bits / 8;
    for (uint32_t j = 0; j < pieceHeight; ++j)
    {
        for (uint32_t i = 0; i < pieceWidth; ++i)
        {
            int x = (int)(column + i), y = (int)(row + j);
            y = reader->isSouthFirst ? (int)reader->height - 1 - y : y;
            if (x >= grid->east.begin && x < grid->east.end && y >= rows.first && y < rows.end)
            {
                values[(size_t)(y - rows.first) * width + (size_t)(x - grid->east.begin)] =
                    decode(reader, bytes + ((size_t)j * pieceWidth + i) * pixelSize + first);
            }
        }
    }
}

// The rows that are kept, as the file counts them.
static swImageRows getFileRows(const TiffGrid* reader)
{
    swImageRows rows = swGetImageRows(&reader->grid);
    int height = (int)reader->height;
    return reader->isSouthFirst ? (swImageRows){height - rows.end, height - rows.first} : rows;
}

static swResult readStrips(TiffGrid* reader, unsigned char* bytes, float* values)
{
    swImageRows rows = getFileRows(reader);
    for (uint32_t row = 0; row < (uint32_t)rows.end; ++row) // some compressions know no other order
    {
        if (TIFFReadScanline(reader->tiff, bytes, row, 0) < 0)
        {
            return failRead(reader);
        }
        keepPiece(reader, bytes, reader->width, 1, 0, row, values);
    }
    return SW_SUCCESS;
}

static swResult readTiles(TiffGrid* reader, unsigned char* bytes, float* values)
{
    const swRasterGrid* grid = &reader->grid;
    swImageRows rows = getFileRows(reader);
    uint32_t width = 0, height = 0;
    TIFFGetField(reader->tiff, TIFFTAG_TILEWIDTH, &width);
    TIFFGetField(reader->tiff, TIFFTAG_TILELENGTH, &height);
    if (width < 1 || height < 1)
    {
        return failRead(reader);
    }
    uint32_t firstColumn = (uint32_t)grid->east.begin / width * width,
             firstRow = (uint32_t)rows.first / height * height;
    for (uint32_t row = firstRow; row < (uint32_t)rows.end; row += height)
    {
        for (uint32_t column = firstColumn; column < (uint32_t)grid->east.end; column += width)
        {
            if (TIFFReadTile(reader->tiff, bytes, column, row, 0, 0) < 0)
            {
                return failRead(reader);
            }
            keepPiece(reader, bytes, width, height, column, row, values);
        }
    }
    return SW_SUCCESS;
}

static swResult readCells(TiffGrid* reader, swRaster** raster)
{
    const swRasterGrid* grid = &reader->grid;
    swResult result = SW_SUCCESS;
    bool isTiled = TIFFIsTiled(reader->tiff) != 0;
    tmsize_t size = isTiled ? TIFFTileSize(reader->tiff) : TIFFScanlineSize(reader->tiff);
    size_t pixelSize = (size_t)reader->samples * reader->bits / 8;
    if (size <= 0 || (size_t)size > grid->def->memoryLimit || (!isTiled && (size_t)size < reader->width * pixelSize))
    {
        return failRead(reader);
    }
    float* values = swAllocateCells(grid, &result);
    unsigned char* bytes = result == SW_SUCCESS ? swAllocateZero(grid->host, (size_t)size) : NULL;
    if (result == SW_SUCCESS && bytes == NULL)
    {
        result = swFail(grid->host, SW_ERROR_NO_MEMORY, "No memory for a part of %s.", grid->name);
    }
    if (result == SW_SUCCESS)
    {
        result = isTiled ? readTiles(reader, bytes, values) : readStrips(reader, bytes, values);
    }
    result = result != SW_SUCCESS ? result : swMakeGridRaster(grid, values, raster);
    swFree(grid->host, bytes, (size_t)size);
    swFreeCells(grid, values);
    return result;
}

swResult swReadTiffGrid(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster)
{
    TiffGrid reader = {.grid = {.host = host, .name = path, .def = def, .isDepth = def->isDepth}};
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    if (options == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", path);
    }
    TIFFOpenOptionsSetErrorHandlerExtR(options, onError, &reader);
    TIFFOpenOptionsSetWarningHandlerExtR(options, onWarning, NULL);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, (tmsize_t)1 << 30);
    reader.tiff = TIFFOpenExt(path, "r", options);
    TIFFOpenOptionsFree(options);
    if (reader.tiff == NULL)
    {
        return failRead(&reader);
    }
    swResult result = readHeading(&reader);
    result = result != SW_SUCCESS ? result : readCells(&reader, raster);
    TIFFClose(reader.tiff);
    return result;
}
