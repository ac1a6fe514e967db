// SPDX-License-Identifier: MIT
#include "core/base/host.h"
#include "core/base/misuse.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/assert.h"

#define SW_ALIGNMENT 64
#define SW_LONGEST_MESSAGE 4608 // a path, and what is wrong with it

static void* allocateFromLibc(void* context, size_t size, size_t alignment)
{
    (void)context;
    // aligned_alloc wants a multiple of the alignment.
    size_t rounded = (size + alignment - 1) & ~(alignment - 1);
    return rounded < size ? NULL : aligned_alloc(alignment, rounded);
}

static void freeToLibc(void* context, void* memory, size_t size)
{
    (void)context;
    (void)size;
    free(memory);
}

static void logToStderr(void* context, swLogLevel level, const char* message)
{
    (void)context;
    if (level >= SW_LOG_WARNING)
    {
        fprintf(stderr, "seaway: %s: %s\n", level == SW_LOG_ERROR ? "error" : "warning", message);
    }
}

static void runOnCaller(void* context, swTaskFcn task, void* taskContext, int count, int grain)
{
    (void)context;
    (void)grain;
    if (count > 0)
    {
        task(taskContext, 0, count, 0);
    }
}

swHost swDefaultHost(void)
{
    swHost host = {0};
    host.allocate = allocateFromLibc;
    host.free = freeToLibc;
    host.log = logToStderr;
    host.parallelFor = runOnCaller;
    host.workerCount = 1;
    host.internalValue = SW_DEF_COOKIE;
    return host;
}

bool swIsHostValid(const swHost* host)
{
    return host != NULL && host->internalValue == SW_DEF_COOKIE && host->allocate != NULL && host->free != NULL &&
           host->parallelFor != NULL && host->workerCount >= 1 && host->workerCount <= SW_MAX_WORKERS;
}

void* swAllocate(const swHost* host, size_t size)
{
    return size == 0 ? NULL : host->allocate(host->memoryContext, size, SW_ALIGNMENT);
}

void* swAllocateZero(const swHost* host, size_t size)
{
    void* memory = swAllocate(host, size);
    if (memory != NULL)
    {
        memset(memory, 0, size);
    }
    return memory;
}

void swFree(const swHost* host, void* memory, size_t size)
{
    if (memory != NULL)
    {
        host->free(host->memoryContext, memory, size);
    }
}

// What is quoted from files and names may hold anything; a message is one line, and no escape sequence for a terminal.
static void copyLine(const char* text, char* line, size_t size)
{
    static const char digits[] = "0123456789abcdef";
    size_t used = 0;
    for (; *text != '\0' && used + 5 <= size; ++text)
    {
        unsigned char c = (unsigned char)*text;
        bool isSpace = c >= '\t' && c <= '\r';
        bool isControl = (c < 0x20 && !isSpace) || c == 0x7f;
        if (isControl)
        {
            memcpy(line + used, "\\x", 2);
            line[used + 2] = digits[c >> 4];
            line[used + 3] = digits[c & 15];
        }
        else
        {
            line[used] = isSpace ? ' ' : *text;
        }
        used += isControl ? 4 : 1;
    }
    line[used] = '\0';
}

static void logList(const swHost* host, swLogLevel level, const char* format, va_list arguments)
{
    if (host->log != NULL)
    {
        char message[SW_LONGEST_MESSAGE], line[SW_LONGEST_MESSAGE];
        vsnprintf(message, sizeof message, format, arguments);
        copyLine(message, line, sizeof line);
        host->log(host->logContext, level, line);
    }
}

void swLog(const swHost* host, swLogLevel level, const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    logList(host, level, format, arguments);
    va_end(arguments);
}

swResult swFail(const swHost* host, swResult result, const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    logList(host, SW_LOG_ERROR, format, arguments);
    va_end(arguments);
    return result;
}

void swTellMisuse(const swHost* host, const char* format, ...)
{
    if (host != NULL && host->internalValue == SW_DEF_COOKIE)
    {
        va_list arguments;
        va_start(arguments, format);
        logList(host, SW_LOG_ERROR, format, arguments);
        va_end(arguments);
    }
}

void swParallelFor(const swHost* host, swTaskFcn task, void* taskContext, int count, int grain)
{
    if (count > 0)
    {
        host->parallelFor(host->taskContext, task, taskContext, count, grain);
    }
}
