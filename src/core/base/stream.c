// SPDX-License-Identifier: MIT
#include "core/base/stream.h"

#include <string.h>

// `width` bytes of a number.
static uint64_t streamBytes(swStream* stream, uint64_t value, size_t width)
{
    if (stream->isBroken || (stream->purpose != SW_STREAM_COUNT && stream->size - stream->at < width))
    {
        stream->isBroken = true;
        return 0;
    }
    uint64_t result = swIsReading(stream) ? 0 : value;
    for (size_t i = 0; i < width && stream->purpose != SW_STREAM_COUNT; ++i)
    {
        if (swIsReading(stream))
        {
            result |= (uint64_t)stream->data[stream->at + i] << (8 * i);
        }
        else
        {
            stream->data[stream->at + i] = (uint8_t)(value >> (8 * i));
        }
    }
    stream->at += width;
    return result;
}

// Writing leaves the values alone: others may be reading them.
void swStreamU32(swStream* stream, uint32_t* value)
{
    uint32_t result = (uint32_t)streamBytes(stream, *value, 4);
    if (swIsReading(stream))
    {
        *value = result;
    }
}

void swStreamU64(swStream* stream, uint64_t* value)
{
    uint64_t result = streamBytes(stream, *value, 8);
    if (swIsReading(stream))
    {
        *value = result;
    }
}

void swStreamI32(swStream* stream, int* value)
{
    uint32_t bits = (uint32_t)*value;
    swStreamU32(stream, &bits);
    if (swIsReading(stream))
    {
        *value = (int)(int32_t)bits;
    }
}

void swStreamI64(swStream* stream, int64_t* value)
{
    uint64_t bits = (uint64_t)*value;
    swStreamU64(stream, &bits);
    if (swIsReading(stream))
    {
        *value = (int64_t)bits;
    }
}

void swStreamF32(swStream* stream, float* value)
{
    uint32_t bits;
    memcpy(&bits, value, sizeof bits);
    swStreamU32(stream, &bits);
    if (swIsReading(stream))
    {
        memcpy(value, &bits, sizeof bits);
    }
}

void swStreamF64(swStream* stream, double* value)
{
    uint64_t bits;
    memcpy(&bits, value, sizeof bits);
    swStreamU64(stream, &bits);
    if (swIsReading(stream))
    {
        memcpy(value, &bits, sizeof bits);
    }
}

void swStreamBool(swStream* stream, bool* value)
{
    bool isReading = swIsReading(stream); // then the value may hold no bool yet
    bool result = streamBytes(stream, !isReading && *value ? 1 : 0, 1) != 0;
    if (isReading)
    {
        *value = result;
    }
}

void swStreamFloats(swStream* stream, float* values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
    {
        swStreamF32(stream, &values[i]);
    }
}

void swStreamRange(swStream* stream, int* value, int least, int most)
{
    swStreamI32(stream, value);
    if (*value < least || *value > most)
    {
        stream->isBroken = true;
        *value = least; // when reading: what is written is within its range
    }
}

bool swStreamHasLeft(swStream* stream, size_t count, size_t size)
{
    if (swIsReading(stream) && !stream->isBroken)
    {
        stream->isBroken = count > (stream->size - stream->at) / size;
    }
    return !stream->isBroken;
}
