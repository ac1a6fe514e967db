// SPDX-License-Identifier: MIT
#pragma once

// Memory and messages by way of the host.

#include "seaway/base.h"
#include "core/base/seam.h"

#if defined(__GNUC__)
#define SW_PRINTF(text, arguments) __attribute__((format(printf, text, arguments)))
#else
#define SW_PRINTF(text, arguments)
#endif

SW_SEAM_BEGIN

// 64-byte aligned, not cleared; NULL if there is none. size 0 returns NULL.
void* swAllocate(const swHost* host, size_t size);
// The same, cleared.
void* swAllocateZero(const swHost* host, size_t size);
void swFree(const swHost* host, void* memory, size_t size);

void swLog(const swHost* host, swLogLevel level, const char* format, ...) SW_PRINTF(3, 4);
// Logs an error and returns the result, so that failing is one line.
swResult swFail(const swHost* host, swResult result, const char* format, ...) SW_PRINTF(3, 4);

// What every swDefaultXDef() writes into internalValue, so that a def which was never initialized is caught.
#define SW_DEF_COOKIE 0x5ea

// Most workers that a host may have.
#define SW_MAX_WORKERS 64

// Made by swDefaultHost(), complete, and with a sane number of workers.
bool swIsHostValid(const swHost* host);

typedef struct swWorld swWorld;

// A world's host, NULL of no world. Implemented by world/.
const swHost* swFindHost(const swWorld* world);

// The host's parallel loop; nothing for count 0.
void swParallelFor(const swHost* host, swTaskFcn task, void* taskContext, int count, int grain);

SW_SEAM_END
