// SPDX-License-Identifier: MIT
// libnetcdf believes what the header of a classic file says of itself, and a damaged one makes it read or allocate far
// too much. So the header is walked here first, as the format's specification has it [Rew 1990]: a list of dimensions,
// one of attributes and one of variables, big-endian, with counts of 4 bytes in versions 1 and 2 and of 8 in version 5.

#include "files/netcdf_header.h"

#include <stdint.h>
#include <string.h>

#include "core/base/host.h"

#define MAX_HEADER ((size_t)1 << 20)
#define MAX_ITEMS 4096
#define MAX_DIMENSIONS 1024
#define MAX_NAME 256
#define MAX_LENGTH 0x7fffffffu
#define TAG_DIMENSION 10
#define TAG_VARIABLE 11
#define TAG_ATTRIBUTE 12

typedef struct Walk
{
    const unsigned char* at;
    const unsigned char* end;
    int version;
    uint64_t fileSize;
    uint64_t recordCount;
    uint64_t recordSize;
    int dimensionCount;
    uint64_t lengths[MAX_DIMENSIONS];
} Walk;

static bool readNumber(Walk* walk, int bytes, uint64_t* value)
{
    *value = 0;
    if (walk->end - walk->at < bytes)
    {
        return false;
    }
    for (int i = 0; i < bytes; ++i)
    {
        *value = *value << 8 | *walk->at++;
    }
    return true;
}

static bool readCount(Walk* walk, uint64_t most, uint64_t* value)
{
    return readNumber(walk, walk->version == 5 ? 8 : 4, value) && *value <= most;
}

static bool skip(Walk* walk, uint64_t bytes)
{
    bytes = (bytes + 3) / 4 * 4;
    if ((uint64_t)(walk->end - walk->at) < bytes)
    {
        return false;
    }
    walk->at += bytes;
    return true;
}

static bool skipName(Walk* walk)
{
    uint64_t length = 0;
    return readCount(walk, MAX_NAME, &length) && length > 0 && (uint64_t)(walk->end - walk->at) >= length &&
           memchr(walk->at, 0, (size_t)length) == NULL && memchr(walk->at, '/', (size_t)length) == NULL &&
           skip(walk, length);
}

// A tag and how many items follow; both are 0 where there is no list.
static bool readList(Walk* walk, uint64_t tag, uint64_t most, uint64_t* count)
{
    uint64_t found = 0;
    return readNumber(walk, 4, &found) && readCount(walk, most, count) && (found == tag || (found == 0 && *count == 0));
}

// Bytes of a type's values; 0 if there is no such type.
static uint64_t getSize(const Walk* walk, uint64_t type)
{
    static const uint64_t sizes[12] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    return type <= (walk->version == 5 ? 11u : 6u) ? sizes[type] : 0;
}

static bool readType(Walk* walk, uint64_t* size)
{
    uint64_t type = 0;
    bool isRead = readNumber(walk, 4, &type);
    *size = isRead ? getSize(walk, type) : 0;
    return *size > 0;
}

static bool walkDimensions(Walk* walk)
{
    uint64_t count = 0;
    int unlimited = 0;
    if (!readList(walk, TAG_DIMENSION, MAX_DIMENSIONS, &count))
    {
        return false;
    }
    walk->dimensionCount = (int)count;
    for (int i = 0; i < walk->dimensionCount; ++i)
    {
        if (!skipName(walk) || !readCount(walk, MAX_LENGTH, &walk->lengths[i]))
        {
            return false;
        }
        unlimited += walk->lengths[i] == 0 ? 1 : 0;
    }
    return unlimited <= 1;
}

static bool walkAttributes(Walk* walk)
{
    uint64_t count = 0;
    bool isFine = readList(walk, TAG_ATTRIBUTE, MAX_ITEMS, &count);
    for (uint64_t i = 0; i < count && isFine; ++i)
    {
        uint64_t size = 0, values = 0;
        isFine = skipName(walk) && readType(walk, &size) && readCount(walk, MAX_HEADER, &values) &&
                 skip(walk, size * values);
    }
    return isFine;
}

// Values of a variable, of one record where its first dimension is the unlimited one; false if they are out of all
// bounds.
static bool walkShape(Walk* walk, uint64_t* values, bool* isRecord)
{
    uint64_t count = 0;
    *values = 1;
    *isRecord = false;
    if (!readCount(walk, MAX_DIMENSIONS, &count))
    {
        return false;
    }
    for (uint64_t i = 0; i < count; ++i)
    {
        uint64_t dimension = 0;
        if (!readCount(walk, MAX_LENGTH, &dimension) || dimension >= (uint64_t)walk->dimensionCount)
        {
            return false;
        }
        uint64_t length = walk->lengths[dimension];
        if (length == 0 && i > 0)
        {
            return false;
        }
        *isRecord = *isRecord || length == 0;
        *values *= length > 0 ? length : 1;
        if (*values > (uint64_t)1 << 40)
        {
            return false;
        }
    }
    return true;
}

static bool walkVariables(Walk* walk)
{
    uint64_t count = 0;
    bool isFine = readList(walk, TAG_VARIABLE, MAX_ITEMS, &count);
    for (uint64_t i = 0; i < count && isFine; ++i)
    {
        uint64_t values = 0, size = 0, stated = 0, begin = 0;
        bool isRecord = false;
        isFine = skipName(walk) && walkShape(walk, &values, &isRecord) && walkAttributes(walk) &&
                 readType(walk, &size) && readNumber(walk, walk->version == 5 ? 8 : 4, &stated) &&
                 readNumber(walk, walk->version == 1 ? 4 : 8, &begin);
        uint64_t bytes = size * values;
        isFine = isFine && begin <= walk->fileSize && (isRecord || bytes <= walk->fileSize - begin);
        walk->recordSize += isRecord ? bytes : 0;
    }
    return isFine;
}

static bool walkHeader(Walk* walk)
{
    walk->version = walk->end - walk->at >= 4 ? walk->at[3] : 0;
    walk->at += 4;
    if ((walk->version != 1 && walk->version != 2 && walk->version != 5) ||
        !readNumber(walk, walk->version == 5 ? 8 : 4, &walk->recordCount) || !walkDimensions(walk) ||
        !walkAttributes(walk) || !walkVariables(walk))
    {
        return false;
    }
    return walk->recordCount == 0 || walk->recordSize == 0 ? walk->recordCount <= MAX_LENGTH
                                                           : walk->recordCount <= walk->fileSize / walk->recordSize;
}

bool swCheckNetcdfHeader(const unsigned char* header, size_t size, uint64_t fileSize)
{
    Walk walk = {.at = header, .end = header + size, .fileSize = fileSize};
    return size >= 4 && walkHeader(&walk);
}

swResult swCheckNetcdfFile(const swHost* host, const char* path)
{
    FILE* file = fopen(path, "rb");
    unsigned char* header = swAllocate(host, MAX_HEADER);
    if (file == NULL || header == NULL)
    {
        bool isOpen = file != NULL;
        if (isOpen)
        {
            fclose(file);
        }
        swFree(host, header, MAX_HEADER);
        return swFail(host, isOpen ? SW_ERROR_NO_MEMORY : SW_ERROR_FILE, "%s: %s.", path,
                      isOpen ? "no memory to read it" : "cannot be opened");
    }
    size_t size = fread(header, 1, MAX_HEADER, file);
    long fileSize = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    fclose(file);
    bool isClassic = size >= 3 && memcmp(header, "CDF", 3) == 0;
    bool isFine = !isClassic || swCheckNetcdfHeader(header, size, fileSize > 0 ? (uint64_t)fileSize : 0);
    swFree(host, header, MAX_HEADER);
    return isFine ? SW_SUCCESS
                  : swFail(host, SW_ERROR_FORMAT,
                           "%s: this is no netCDF file that can be read: its header is damaged or "
                           "the file is cut off.",
                           path);
}
