// SPDX-License-Identifier: MIT
// Layers in false colours: which slices, what they hold, and where each stands in a picture.

#include "seaway/sheet.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/host.h"
#include "core/base/misuse.h"

#define SW_SHEET_COOKIE 0x53485431
#define SW_SHEET_GAP 4           // pixels between two slices
#define SW_SHEET_BAR 16          // height of the row of colours
#define SW_SHEET_UNKNOWN 1e29f   // what a layer holds where there is nothing is larger
#define SW_SHEET_DEEPEST 1000.0f // m, of what colours are for
#define SW_SHEET_MOST_COLUMNS 4  // of a picture with a pixel for each texel

struct swSheet
{
    swHost host;
    swSheetInfo info;
    float* texels; // of one slice, as it was read
    float* values; // [sliceCount][resolution][resolution]
    size_t texelBytes, valueBytes;
};

swSheetDef swDefaultSheetDef(void)
{
    return (swSheetDef){
        .layer = SW_LAYER_DISPLACEMENT, .channel = 1, .slice = -1, .high = 1.0f, .internalValue = SW_SHEET_COOKIE};
}

// ---- names ----

static int findName(const char* text, size_t size, swLayer layer, bool isChannel)
{
    for (int i = 0;; ++i)
    {
        const char* name = isChannel ? swLayer_GetChannelName(layer, i) : swLayer_GetName((swLayer)i);
        if (name == NULL)
        {
            return -1;
        }
        if (strlen(name) == size && memcmp(name, text, size) == 0)
        {
            return i;
        }
    }
}

static void sayNames(char* problem, size_t size, swLayer layer, bool isChannel, const char* text, size_t length)
{
    if (problem == NULL || size == 0)
    {
        return;
    }
    int shown = length < 64 ? (int)length : 64;
    if (isChannel)
    {
        snprintf(problem, size, "%s has no channel \"%.*s\"; it has ", swLayer_GetName(layer), shown, text);
    }
    else
    {
        snprintf(problem, size, "there is no layer \"%.*s\"; the layers are ", shown, text);
    }
    const char* name = NULL;
    for (int i = 0; (name = isChannel ? swLayer_GetChannelName(layer, i) : swLayer_GetName((swLayer)i)) != NULL; ++i)
    {
        size_t used = strlen(problem);
        snprintf(problem + used, size - used, "%s%s", i > 0 ? ", " : "", name);
    }
}

static bool parseSlice(const char* text, int* slice)
{
    int number = 0;
    const char* at = text;
    for (; *at >= '0' && *at <= '9' && number < SW_MAX_SLICES; ++at)
    {
        number = 10 * number + (*at - '0');
    }
    *slice = number;
    return at != text && *at == '\0' && number < SW_MAX_SLICES;
}

bool swParseSheet(const char* text, swSheetDef* def, char* problem, size_t size)
{
    SW_REQUIRE(text != NULL && def != NULL, false, NULL, "swParseSheet() needs a text and a def");
    size_t length = strcspn(text, ".:");
    int layer = findName(text, length, SW_LAYER_COUNT, false);
    if (layer < 0)
    {
        sayNames(problem, size, SW_LAYER_COUNT, false, text, length);
        return false;
    }
    int channel = layer == SW_LAYER_DISPLACEMENT ? 1 : 0, slice = -1;
    const char* rest = text + length;
    if (*rest == '.')
    {
        length = strcspn(rest + 1, ":");
        channel = findName(rest + 1, length, (swLayer)layer, true);
        if (channel < 0)
        {
            sayNames(problem, size, (swLayer)layer, true, rest + 1, length);
            return false;
        }
        rest += 1 + length;
    }
    if (*rest == ':' && !parseSlice(rest + 1, &slice))
    {
        if (problem != NULL)
        {
            snprintf(problem, size, "\"%.64s\" is no slice; the finest is 0, and a view has %d at most", rest + 1,
                     SW_MAX_SLICES);
        }
        return false;
    }
    def->layer = (swLayer)layer;
    def->channel = channel;
    def->slice = slice;
    return true;
}

// ---- values ----

swResult swCreateSheet(const swHost* host, swSheet** sheet)
{
    SW_REQUIRE_PLACE(host, sheet, "swCreateSheet()");
    *sheet = swAllocateZero(host, sizeof(**sheet));
    if (*sheet == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for a sheet.");
    }
    (*sheet)->host = *host;
    return SW_SUCCESS;
}

static void freeTexels(swSheet* sheet)
{
    swFree(&sheet->host, sheet->texels, sheet->texelBytes);
    swFree(&sheet->host, sheet->values, sheet->valueBytes);
    sheet->texels = sheet->values = NULL;
    sheet->texelBytes = sheet->valueBytes = 0;
    sheet->info.sliceCount = 0;
}

void swDestroySheet(swSheet* sheet)
{
    if (sheet != NULL)
    {
        swHost host = sheet->host;
        freeTexels(sheet);
        swFree(&host, sheet, sizeof(*sheet));
    }
}

static bool makeRoom(swSheet* sheet, size_t texels, size_t values)
{
    if (sheet->texelBytes == texels && sheet->valueBytes == values)
    {
        return true;
    }
    freeTexels(sheet);
    sheet->texels = swAllocate(&sheet->host, texels);
    sheet->texelBytes = sheet->texels != NULL ? texels : 0;
    sheet->values = swAllocate(&sheet->host, values);
    sheet->valueBytes = sheet->values != NULL ? values : 0;
    return sheet->texels != NULL && sheet->values != NULL;
}

static bool isKnown(float value)
{
    return fabsf(value) < SW_SHEET_UNKNOWN; // false of NaN
}

// A floor that fades into none is as deep as one likes: colours are for what is shallower, if there is such.
static bool isShown(const swSheetInfo* info, float value)
{
    bool isDepth = info->def.layer == SW_LAYER_PLACES && info->def.channel == 0;
    return isKnown(value) && (!isDepth || value <= SW_SHEET_DEEPEST || info->least > SW_SHEET_DEEPEST);
}

static void findRange(swSheetInfo* info, const float* values)
{
    size_t count = (size_t)info->sliceCount * (size_t)info->resolution * (size_t)info->resolution;
    info->least = info->greatest = NAN;
    info->unknownCount = 0;
    for (size_t i = 0; i < count; ++i)
    {
        if (isKnown(values[i]))
        {
            info->least = values[i] >= info->least ? info->least : values[i]; // the first one replaces NaN
            info->greatest = values[i] <= info->greatest ? info->greatest : values[i];
        }
        else
        {
            info->unknownCount += 1;
        }
    }
    float most = NAN;
    for (size_t i = 0; i < count; ++i)
    {
        most = !isShown(info, values[i]) || values[i] <= most ? most : values[i];
    }
    info->low = info->def.hasRange ? info->def.low : info->least;
    info->high = info->def.hasRange ? info->def.high : most;
}

static bool isDefGood(const swSheetDef* def)
{
    return swLayer_GetName(def->layer) != NULL && swLayer_GetChannelName(def->layer, def->channel) != NULL &&
           def->slice >= -1 && isfinite(def->low) && isfinite(def->high) && (!def->hasRange || def->low < def->high);
}

swResult swSheet_Read(swSheet* sheet, swGpuWorld* gpuWorld, const swView* view, const swSheetDef* def)
{
    SW_REQUIRE(sheet != NULL, SW_ERROR_INVALID, NULL, "swSheet_Read() needs a sheet");
    SW_REQUIRE(gpuWorld != NULL && view != NULL && def != NULL && def->internalValue == SW_SHEET_COOKIE &&
                   isDefGood(def),
               SW_ERROR_INVALID, &sheet->host,
               "swSheet_Read() needs a swGpuWorld, a view, and a def made by swDefaultSheetDef() with a layer, one of "
               "its channels, and a low number below the high one");
    int total = swView_GetSliceCount(view);
    if (def->slice >= total)
    {
        return swFail(&sheet->host, SW_ERROR_INVALID, "There is no slice %d: the view has %d, the finest is 0.",
                      def->slice, total);
    }
    swSheetInfo info = {.def = *def,
                        .firstSlice = def->slice >= 0 ? def->slice : 0,
                        .sliceCount = def->slice >= 0 ? 1 : total,
                        .resolution = swView_GetSlice(view, 0).resolution};
    size_t side = (size_t)info.resolution, step = (size_t)swLayer_GetTexelSize(def->layer);
    if (!makeRoom(sheet, side * side * step * sizeof(float), (size_t)info.sliceCount * side * side * sizeof(float)))
    {
        freeTexels(sheet);
        return swFail(&sheet->host, SW_ERROR_NO_MEMORY, "No memory for a sheet of %d slices of %d x %d texels.",
                      info.sliceCount, info.resolution, info.resolution);
    }
    for (int i = 0; i < info.sliceCount; ++i)
    {
        swResult result = swGpuWorld_ReadLayer(gpuWorld, view, def->layer, info.firstSlice + i, sheet->texels);
        if (result != SW_SUCCESS)
        {
            sheet->info.sliceCount = 0;
            return result;
        }
        float* to = sheet->values + (size_t)i * side * side;
        for (size_t j = 0; j < side * side; ++j)
        {
            to[j] = sheet->texels[step * j + (size_t)def->channel];
        }
    }
    findRange(&info, sheet->values);
    sheet->info = info;
    return SW_SUCCESS;
}

swSheetInfo swSheet_GetInfo(const swSheet* sheet)
{
    SW_REQUIRE(sheet != NULL, (swSheetInfo){0}, NULL, "swSheet_GetInfo() needs a sheet");
    return sheet->info;
}

// ---- pictures ----

typedef struct swSheetLayout
{
    int columns, side; // slices in a row, pixels of a slice
    int left, top;     // of the first one
    int width, bar;    // of all slices, and the first row of the colours
} swSheetLayout;

static int countRows(int count, int columns)
{
    return (count + columns - 1) / columns;
}

void swFindSheetSize(int sliceCount, int resolution, int* width, int* height)
{
    SW_REQUIRE_VOID(width != NULL && height != NULL && sliceCount > 0 && sliceCount <= SW_MAX_SLICES &&
                        resolution > 0 && resolution <= 1024,
                    NULL, "swFindSheetSize() needs slices, their resolution and places for the size");
    int rows = countRows(sliceCount, SW_SHEET_MOST_COLUMNS);
    int columns = countRows(sliceCount, rows);
    *width = columns * (resolution + SW_SHEET_GAP) - SW_SHEET_GAP;
    *height = rows * (resolution + SW_SHEET_GAP) + SW_SHEET_BAR;
}

// As large as the slices fit; centred.
static swSheetLayout layOut(const swSheet* sheet, int width, int height)
{
    swSheetLayout layout = {0};
    int count = sheet->info.sliceCount;
    for (int columns = 1; columns <= count; ++columns)
    {
        int rows = countRows(count, columns);
        int wide = (width + SW_SHEET_GAP) / columns - SW_SHEET_GAP;
        int high = (height - SW_SHEET_BAR) / rows - SW_SHEET_GAP;
        int side = wide < high ? wide : high;
        if (side > layout.side)
        {
            layout.columns = columns;
            layout.side = side;
        }
    }
    if (layout.side > 0)
    {
        int step = layout.side + SW_SHEET_GAP;
        layout.width = layout.columns * step - SW_SHEET_GAP;
        layout.left = (width - layout.width) / 2;
        layout.top = (height - SW_SHEET_BAR - countRows(count, layout.columns) * step) / 2;
        layout.bar = layout.top + countRows(count, layout.columns) * step;
    }
    return layout;
}

// Index into the values of what is at a pixel, or -1.
static ptrdiff_t findTexel(const swSheet* sheet, const swSheetLayout* layout, int x, int y)
{
    int step = layout->side + SW_SHEET_GAP, side = sheet->info.resolution;
    int column = x - layout->left, row = y - layout->top;
    if (layout->side <= 0 || column < 0 || row < 0 || column >= layout->width || column % step >= layout->side ||
        row % step >= layout->side)
    {
        return -1;
    }
    int slice = row / step * layout->columns + column / step;
    if (slice >= sheet->info.sliceCount)
    {
        return -1;
    }
    int texelX = (int)((int64_t)(column % step) * side / layout->side);
    int texelZ = (int)((int64_t)(row % step) * side / layout->side);
    return ((ptrdiff_t)slice * side + texelZ) * side + texelX;
}

// From dark blue by green to yellow, ever brighter: a difference shows in black and white too.
static void colorOf(float t, uint8_t* rgb)
{
    static const uint8_t colors[9][3] = {{30, 10, 70},   {45, 45, 130},  {40, 90, 150},  {30, 130, 145}, {45, 165, 120},
                                         {105, 190, 85}, {175, 205, 60}, {235, 215, 70}, {255, 245, 190}};
    t = t > 0.0f ? t : 0.0f;
    t = 8.0f * (t < 1.0f ? t : 1.0f);
    int index = t < 7.0f ? (int)t : 7;
    float part = t - (float)index;
    for (int i = 0; i < 3; ++i)
    {
        float from = colors[index][i], to = colors[index + 1][i];
        rgb[i] = (uint8_t)(from + (to - from) * part + 0.5f);
    }
}

static void colorValue(const swSheetInfo* info, float value, uint8_t* rgb)
{
    if (!isKnown(value))
    {
        memset(rgb, 96, 3);
        return;
    }
    float span = info->high - info->low;
    colorOf(span > 0.0f ? (value - info->low) / span : 0.0f, rgb);
}

static bool canDraw(const swSheet* sheet, int width, int height, const void* pixels)
{
    SW_REQUIRE(sheet != NULL && width > 0 && height > 0 && pixels != NULL, false, sheet != NULL ? &sheet->host : NULL,
               "a sheet is drawn to a picture of at least one pixel");
    return true;
}

void swSheet_Draw(const swSheet* sheet, int width, int height, uint8_t* rgba)
{
    if (!canDraw(sheet, width, height, rgba))
    {
        return;
    }
    swSheetLayout layout = layOut(sheet, width, height);
    for (int y = 0; y < height; ++y)
    {
        bool isBar = layout.side > 0 && y >= layout.bar && y < layout.bar + SW_SHEET_BAR;
        for (int x = 0; x < width; ++x)
        {
            uint8_t* pixel = rgba + 4 * ((size_t)y * (size_t)width + (size_t)x);
            ptrdiff_t texel = isBar ? -1 : findTexel(sheet, &layout, x, y);
            memset(pixel, 24, 3);
            pixel[3] = 255;
            if (texel >= 0)
            {
                colorValue(&sheet->info, sheet->values[texel], pixel);
            }
            else if (isBar && x >= layout.left && x < layout.left + layout.width && layout.width > 1)
            {
                colorOf((float)(x - layout.left) / (float)(layout.width - 1), pixel);
            }
        }
    }
}

void swSheet_DrawValues(const swSheet* sheet, int width, int height, float* rgb)
{
    if (!canDraw(sheet, width, height, rgb))
    {
        return;
    }
    swSheetLayout layout = layOut(sheet, width, height);
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            ptrdiff_t texel = findTexel(sheet, &layout, x, y);
            float value = texel >= 0 && isKnown(sheet->values[texel]) ? sheet->values[texel] : NAN;
            float* pixel = rgb + 3 * ((size_t)y * (size_t)width + (size_t)x);
            pixel[0] = pixel[1] = pixel[2] = value;
        }
    }
}

bool swSheet_Pick(const swSheet* sheet, int width, int height, int x, int y, swSheetPick* pick)
{
    SW_REQUIRE(sheet != NULL && pick != NULL, false, sheet != NULL ? &sheet->host : NULL,
               "swSheet_Pick() needs a sheet and a place for what is there");
    swSheetLayout layout = layOut(sheet, width, height);
    ptrdiff_t texel = x < width && y < height ? findTexel(sheet, &layout, x, y) : -1;
    if (texel < 0)
    {
        return false;
    }
    ptrdiff_t side = sheet->info.resolution;
    float value = sheet->values[texel];
    *pick = (swSheetPick){.slice = sheet->info.firstSlice + (int)(texel / (side * side)),
                          .column = (int)(texel % side),
                          .row = (int)(texel / side % side),
                          .value = isKnown(value) ? value : NAN};
    return true;
}
