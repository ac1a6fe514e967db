// SPDX-License-Identifier: MIT
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// @file
/// Export macros, version, result codes, and the host: the memory, log and worker threads that Seaway may use.
/// The library has no globals and starts no thread that the host did not give it.
///
/// The contract of the API. Misuse is what the caller could have known: NULL where nothing says that it may be, a def
/// that was not made by its swDefaultXDef(), a handle that is stale, an enumerator that does not exist, a number that
/// is NaN or out of its range. Then
///   - the host's log receives a sentence that names the call and what is wrong, wherever a host is at hand: given, or
///     that of an object which was made with one;
///   - where asserts are on, the program stops there, but for a def's fields that are out of range;
///   - where they are off (NDEBUG), the call does nothing, and nothing of what it was given has changed. It returns
///     SW_ERROR_INVALID if it returns a swResult. An object that was to be made is NULL; what would have been answered
///     is 0, NULL, false, an empty struct, or NaN where a query asked for numbers.
/// What the caller cannot have known (a device, a file, memory) is a swResult and a sentence in every build. One bad
/// element of a batch is neither: it is answered with NaN and counted. `tests/misuse` holds the whole API to this.

#if defined(_WIN32) && defined(SEAWAY_SHARED)
#if defined(SEAWAY_EXPORTS)
#define SW_EXPORT __declspec(dllexport)
#else
#define SW_EXPORT __declspec(dllimport)
#endif
#elif defined(__GNUC__) && defined(SEAWAY_SHARED)
#define SW_EXPORT __attribute__((visibility("default")))
#else
#define SW_EXPORT
#endif

#ifdef __cplusplus
#define SW_API extern "C" SW_EXPORT
#else
#define SW_API extern SW_EXPORT
#endif

#define SW_VERSION_MAJOR 0
#define SW_VERSION_MINOR 1
#define SW_VERSION_PATCH 0

/// What a call returns that may be refused or depends on the outside world. The host's log receives a full sentence
/// beside it.
typedef enum swResult
{
#define SW_RESULT(name, text) SW_##name,
#include "results.inl"
#undef SW_RESULT
    SW_RESULT_COUNT
} swResult;

/// "SW_ERROR_FILE" and the like. Never NULL.
SW_API const char* swResult_GetName(swResult result);

/// A short English text for the result. Never NULL.
SW_API const char* swResult_GetText(swResult result);

/// Version of the linked library as major * 10000 + minor * 100 + patch.
SW_API int swGetVersion(void);

typedef enum swLogLevel
{
    SW_LOG_INFO,
    SW_LOG_WARNING,
    SW_LOG_ERROR
} swLogLevel;

/// Return `size` bytes aligned to `alignment` (a power of two of at most 64), or NULL. Any thread.
typedef void* (*swAllocFcn)(void* context, size_t size, size_t alignment);

/// Give back what swAllocFcn returned; `size` is the size that was asked for. `memory` may be NULL. Any thread.
typedef void (*swFreeFcn)(void* context, void* memory, size_t size);

/// Receives one sentence without a line break. Any thread.
typedef void (*swLogFcn)(void* context, swLogLevel level, const char* message);

/// One part of a parallel loop: the items [begin, end). `worker` is below swHost::workerCount and no two parts with the
/// same worker run at once.
typedef void (*swTaskFcn)(void* taskContext, int begin, int end, int worker);

/// Run task over [0, count) in parts of at least `grain` items and return when all are done.
/// How items are grouped and ordered never changes a result.
typedef void (*swParallelForFcn)(void* context, swTaskFcn task, void* taskContext, int count, int grain);

/// What the host provides. Copied by every object that is created with it; the contexts must outlive those objects.
/// Must be initialized with swDefaultHost().
typedef struct swHost
{
    /// Memory. Default: the C library's aligned_alloc and free.
    swAllocFcn allocate;
    swFreeFcn free;
    void* memoryContext;

    /// Messages. Default: warnings and errors to stderr. NULL is silence.
    swLogFcn log;
    void* logContext;

    /// Parallel loops. Default: a plain call on the calling thread, with workerCount 1.
    swParallelForFcn parallelFor;
    void* taskContext;
    int workerCount;

    /// Set by swDefaultHost().
    int internalValue;
} swHost;

/// The C library's memory, messages to stderr, everything on the calling thread.
SW_API swHost swDefaultHost(void);

/// A small pool of worker threads for hosts that have none of their own.
typedef struct swTaskPool swTaskPool;

/// Start `threadCount` workers beside the calling thread (0 is allowed: everything runs on the caller).
/// Range [0, 63]. Not for hosts with a job system: give that as swHost::parallelFor instead.
/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, or SW_ERROR_LIMIT if the system starts no more threads
SW_API swResult swCreateTaskPool(const swHost* host, int threadCount, swTaskPool** pool);

/// Let `host` run its parallel loops on the pool. The pool must outlive every object created with that host.
SW_API void swTaskPool_Attach(swTaskPool* pool, swHost* host);

/// Join all workers and free the pool. NULL is allowed.
SW_API void swDestroyTaskPool(swTaskPool* pool);
