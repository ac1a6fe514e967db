// SPDX-License-Identifier: MIT

#include "files/file_text.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <zlib.h>

#include "core/base/host.h"

#define FIRST_CAPACITY 65536

bool swHasFile(const char* path)
{
    FILE* file = fopen(path, "rb");
    if (file != NULL)
    {
        fclose(file);
    }
    return file != NULL;
}

static swResult growText(const swHost* host, swFileText* text)
{
    size_t capacity = text->capacity > 0 ? 2 * text->capacity : FIRST_CAPACITY;
    char* data = swAllocate(host, capacity);
    if (data == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    if (text->size > 0)
    {
        memcpy(data, text->data, text->size);
    }
    swFree(host, text->data, text->capacity);
    text->data = data;
    text->capacity = capacity;
    return SW_SUCCESS;
}

static swResult readAll(const swHost* host, gzFile file, const char* path, size_t limit, swFileText* text)
{
    for (;;)
    {
        if (text->size == text->capacity && growText(host, text) != SW_SUCCESS)
        {
            return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", path);
        }
        size_t room = text->capacity - text->size;
        int count = gzread(file, text->data + text->size, (unsigned)(room < 1u << 20 ? room : 1u << 20));
        if (count < 0)
        {
            int code = 0;
            const char* reason = gzerror(file, &code);
            return swFail(host, SW_ERROR_FILE, "Cannot read %s: %s.", path, code == Z_ERRNO ? strerror(errno) : reason);
        }
        if (count == 0)
        {
            return SW_SUCCESS;
        }
        text->size += (size_t)count;
        if (text->size > limit)
        {
            return swFail(host, SW_ERROR_FILE, "%s is larger than %zu MiB, the most that is read.", path, limit >> 20);
        }
    }
}

swResult swReadText(const swHost* host, const char* path, size_t limit, swFileText* text)
{
    memset(text, 0, sizeof(*text));
    errno = 0;
    gzFile file = gzopen(path, "rb"); // reads plain files as they are
    if (file == NULL)
    {
        return swFail(host, SW_ERROR_FILE, "Cannot open %s: %s.", path, errno != 0 ? strerror(errno) : "no memory");
    }
    swResult result = readAll(host, file, path, limit, text);
    if (gzclose(file) == Z_BUF_ERROR && result == SW_SUCCESS)
    {
        result = swFail(host, SW_ERROR_FILE, "Cannot read %s: its gzip data end early.", path);
    }
    if (result != SW_SUCCESS)
    {
        swFreeText(host, text);
    }
    return result;
}

void swFreeText(const swHost* host, swFileText* text)
{
    swFree(host, text->data, text->capacity);
    memset(text, 0, sizeof(*text));
}
