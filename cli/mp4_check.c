// SPDX-License-Identifier: MIT
// ffmpeg 5 leaves with exit code 0 when its disk is full. What it wrote tells: an MP4 file is a row of boxes, each with
// a size of 32 bits and a name before its contents [ISO/IEC 14496-12]. A whole file has the boxes `mdat` (the pictures)
// and `moov` (where they lie), ends where its last box ends, and counts its pictures in moov/trak/mdia/minf/stbl/stsz.

#include "mp4_check.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/types.h>

typedef struct Box
{
    char name[5];
    int64_t begin, end; // of the contents, bytes from the start of the file
} Box;

static bool ReadBytes(FILE* file, int64_t at, void* bytes, size_t size)
{
    return fseeko(file, (off_t)at, SEEK_SET) == 0 && fread(bytes, 1, size, file) == size;
}

static uint64_t GetNumber(const uint8_t* bytes, int count)
{
    uint64_t number = 0;
    for (int i = 0; i < count; ++i)
    {
        number = number << 8 | bytes[i];
    }
    return number;
}

// The box at `at`, which has to end at `end` or before.
static bool ReadBox(FILE* file, int64_t at, int64_t end, Box* box)
{
    uint8_t head[16];
    if (end - at < 8 || !ReadBytes(file, at, head, 8))
    {
        return false;
    }
    uint64_t size = GetNumber(head, 4), headSize = 8;
    if (size == 1) // a size of 64 bits follows
    {
        if (!ReadBytes(file, at, head, 16))
        {
            return false;
        }
        size = GetNumber(head + 8, 8);
        headSize = 16;
    }
    if (size < headSize || size > (uint64_t)(end - at))
    {
        return false;
    }
    memcpy(box->name, head + 4, 4);
    box->name[4] = 0;
    box->begin = at + (int64_t)headSize;
    box->end = at + (int64_t)size;
    return true;
}

// The first box of a name between two places. False also if a box before it is broken.
static bool FindBox(FILE* file, int64_t begin, int64_t end, const char* name, Box* box)
{
    for (int64_t at = begin; at < end && ReadBox(file, at, end, box); at = box->end)
    {
        if (strcmp(box->name, name) == 0)
        {
            return true;
        }
    }
    return false;
}

static bool AreBoxesWhole(FILE* file, int64_t size)
{
    Box box;
    int64_t at = 0;
    while (at < size)
    {
        if (!ReadBox(file, at, size, &box))
        {
            return false;
        }
        at = box.end;
    }
    return at > 0;
}

// Pictures that the first track has, or -1.
static int64_t CountPictures(FILE* file, int64_t size)
{
    static const char* const path[] = {"moov", "trak", "mdia", "minf", "stbl", "stsz"};
    Box box = {.begin = 0, .end = size};
    for (size_t i = 0; i < sizeof(path) / sizeof(path[0]); ++i)
    {
        if (!FindBox(file, box.begin, box.end, path[i], &box))
        {
            return -1;
        }
    }
    uint8_t counts[12]; // version and flags, the size that all have or 0, how many
    return box.end - box.begin >= 12 && ReadBytes(file, box.begin, counts, 12) ? (int64_t)GetNumber(counts + 8, 4) : -1;
}

static const char* FindFault(FILE* file, int frameCount)
{
    Box box;
    int64_t size = fseeko(file, 0, SEEK_END) == 0 ? (int64_t)ftello(file) : 0;
    if (size == 0)
    {
        return "the file is empty; is the disk full?";
    }
    if (!AreBoxesWhole(file, size) || !FindBox(file, 0, size, "mdat", &box) || !FindBox(file, 0, size, "moov", &box))
    {
        return "the file is not whole; is the disk full?";
    }
    return CountPictures(file, size) == frameCount ? NULL : "the file does not hold all frames; is the disk full?";
}

const char* FindVideoFault(const char* path, int frameCount)
{
    FILE* file = fopen(path, "rb");
    if (file == NULL)
    {
        return "the file is not there";
    }
    const char* fault = FindFault(file, frameCount);
    fclose(file);
    return fault;
}
