// SPDX-License-Identifier: MIT
#pragma once

// A file for the tests of raster readers: each test program writes, reads and removes one of its own.

#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <seaway/files.h>

static char s_path[64];

static inline int MakePath(void** state)
{
    (void)state;
    snprintf(s_path, sizeof(s_path), "raster_%ld.tmp", (long)getpid());
    return 0;
}

static inline int RemovePath(void** state)
{
    (void)state;
    remove(s_path);
    return 0;
}

static inline swRaster* Read(const swRasterFileDef* def)
{
    swHost host = MakeHost();
    swRaster* raster = NULL;
    if (swReadRaster(&host, s_path, def, &raster) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    return raster;
}

static inline void CheckRefused(const swRasterFileDef* def, swResult expected, const char* words)
{
    swHost host = MakeHost();
    swRaster* raster = NULL;
    assert_int_equal(swReadRaster(&host, s_path, def, &raster), expected);
    assert_null(raster);
    if (strstr(s_messages, words) == NULL)
    {
        fail_msg("\"%s\" does not say \"%s\"", s_messages, words);
    }
}
