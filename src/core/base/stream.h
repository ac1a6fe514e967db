// SPDX-License-Identifier: MIT
#pragma once

// Values in a row of bytes, little-endian on every machine. One function lists the fields of a thing for all three
// purposes: to count its bytes, to write them, to read them back. After a failure (the end of the data, a number out of
// range) reading gives zeros and `isBroken` says so; nothing needs to be checked in between but counts that loops use.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum swStreamPurpose
{
    SW_STREAM_COUNT,
    SW_STREAM_WRITE,
    SW_STREAM_READ
} swStreamPurpose;

typedef struct swStream
{
    swStreamPurpose purpose;
    uint8_t* data; // not written to when reading
    size_t size;
    size_t at;
    bool isBroken;
} swStream;

static inline bool swIsReading(const swStream* stream)
{
    return stream->purpose == SW_STREAM_READ;
}

void swStreamU32(swStream* stream, uint32_t* value);
void swStreamU64(swStream* stream, uint64_t* value);
void swStreamI32(swStream* stream, int* value);
void swStreamI64(swStream* stream, int64_t* value);
void swStreamF32(swStream* stream, float* value);
void swStreamF64(swStream* stream, double* value);
void swStreamBool(swStream* stream, bool* value);
void swStreamFloats(swStream* stream, float* values, size_t count);

// Reading only: whether `count` things of at least `size` bytes are left; if not, the stream is broken. Ask before
// memory for them is taken or they are looped over, so that a count alone takes nothing.
bool swStreamHasLeft(swStream* stream, size_t count, size_t size);

// A count or an index that must lie within [least, most].
void swStreamRange(swStream* stream, int* value, int least, int most);
