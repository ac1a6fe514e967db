// SPDX-License-Identifier: MIT
#pragma once

// Writes small netCDF files for tests: dimensions, variables of numbers, texts. Any failure of the library fails the
// test.

#include "support/cmocka_setup.h"

#include <netcdf.h>
#include <stddef.h>
#include <string.h>

static inline void CheckNetcdf(int code)
{
    if (code != NC_NOERR)
    {
        print_message("%s\n", nc_strerror(code));
    }
    assert_int_equal(code, NC_NOERR);
}

static inline int MakeNetcdf(const char* path, int mode)
{
    int file = 0;
    CheckNetcdf(nc_create(path, mode | NC_CLOBBER, &file));
    return file;
}

static inline int AddDimension(int file, const char* name, size_t length)
{
    int id = 0;
    CheckNetcdf(nc_def_dim(file, name, length, &id));
    return id;
}

static inline int AddVariable(int file, const char* name, nc_type type, int count, const int* dimensions)
{
    int id = 0;
    CheckNetcdf(nc_def_var(file, name, type, count, dimensions, &id));
    return id;
}

// Nothing for a NULL text.
static inline void AddText(int file, int variable, const char* name, const char* text)
{
    if (text != NULL)
    {
        CheckNetcdf(nc_put_att_text(file, variable, name, strlen(text), text));
    }
}

static inline void AddNumber(int file, int variable, const char* name, nc_type type, double value)
{
    CheckNetcdf(nc_put_att_double(file, variable, name, type, 1, &value));
}

// After nc_enddef().
static inline void PutNumbers(int file, int variable, const double* values)
{
    CheckNetcdf(nc_put_var_double(file, variable, values));
}
