// SPDX-License-Identifier: MIT

#include "files/netcdf_file.h"

#include <math.h>
#include <netcdf.h>
#include <string.h>

#include "core/base/host.h"
#include "files/netcdf_header.h"

swResult swOpenNetcdfFile(swNetcdfFile* file)
{
    file->id = -1;
    swResult result = swCheckNetcdfFile(file->host, file->name);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    int code = nc_open(file->name, NC_NOWRITE, &file->id);
    if (code != NC_NOERR)
    {
        file->id = -1;
        return swFail(file->host, SW_ERROR_FORMAT, "%s: this is no netCDF file that can be read: %s.", file->name,
                      nc_strerror(code));
    }
    return SW_SUCCESS;
}

void swCloseNetcdfFile(swNetcdfFile* file)
{
    if (file->id >= 0)
    {
        nc_close(file->id);
    }
    file->id = -1;
}

static bool getNumber(const swNetcdfFile* file, int variable, const char* attribute, double* value)
{
    nc_type type = NC_NAT;
    size_t length = 0;
    return nc_inq_att(file->id, variable, attribute, &type, &length) == NC_NOERR && length == 1 && type != NC_CHAR &&
           type != NC_STRING && type <= NC_UINT64 &&
           nc_get_att_double(file->id, variable, attribute, value) == NC_NOERR;
}

// What netCDF itself writes where nothing was put; of floating-point types it is beyond 1e30.
static bool getDefaultFill(const swNetcdfFile* file, int variable, double* fill)
{
    nc_type type = NC_NAT;
    nc_inq_vartype(file->id, variable, &type);
    *fill = type == NC_SHORT ? (double)NC_FILL_SHORT : type == NC_INT ? (double)NC_FILL_INT : 0.0;
    return *fill != 0.0;
}

bool swGetNetcdfVariable(const swNetcdfFile* file, int id, swNetcdfVariable* variable)
{
    memset(variable, 0, sizeof(*variable));
    variable->id = id;
    if (nc_inq_varndims(file->id, id, &variable->dimensionCount) != NC_NOERR ||
        variable->dimensionCount > SW_NETCDF_MAX_DIMENSIONS ||
        nc_inq_vardimid(file->id, id, variable->dimensions) != NC_NOERR)
    {
        return false;
    }
    variable->scale = 1.0;
    getNumber(file, id, "scale_factor", &variable->scale);
    getNumber(file, id, "add_offset", &variable->offset);
    variable->hasFill[0] =
        getNumber(file, id, "_FillValue", &variable->fill[0]) || getDefaultFill(file, id, &variable->fill[0]);
    variable->hasFill[1] = getNumber(file, id, "missing_value", &variable->fill[1]);
    return true;
}

bool swFindNetcdfVariable(const swNetcdfFile* file, const char* name, swNetcdfVariable* variable)
{
    int id = -1;
    memset(variable, 0, sizeof(*variable));
    return nc_inq_varid(file->id, name, &id) == NC_NOERR && swGetNetcdfVariable(file, id, variable);
}

bool swIsOneOf(const char* text, const char* const* texts)
{
    for (; *texts != NULL; ++texts)
    {
        if (strcmp(text, *texts) == 0)
        {
            return true;
        }
    }
    return false;
}

bool swFindNetcdfCoordinate(const swNetcdfFile* file, int dimension, const char* const* names,
                            swNetcdfVariable* variable)
{
    char name[257];
    swGetNetcdfName(file, dimension, name);
    if (swFindNetcdfVariable(file, name, variable) && variable->dimensionCount == 1 &&
        variable->dimensions[0] == dimension)
    {
        return true;
    }
    int count = 0;
    for (int i = 0; nc_inq_nvars(file->id, &count) == NC_NOERR && i < count; ++i)
    {
        swGetNetcdfVariableName(file, i, name);
        if (swIsOneOf(name, names) && swGetNetcdfVariable(file, i, variable) && variable->dimensionCount == 1 &&
            variable->dimensions[0] == dimension)
        {
            return true;
        }
    }
    return false;
}

static void lower(char* text, bool isPlain)
{
    for (; *text != '\0'; ++text)
    {
        *text = *text >= 'A' && *text <= 'Z' ? (char)(*text + 32) : *text;
        *text = isPlain && (*text == '_' || *text == '-') ? ' ' : *text;
    }
}

void swGetNetcdfText(const swNetcdfFile* file, int variable, const char* attribute, bool isPlain, char* text,
                     size_t size)
{
    nc_type type = NC_NAT;
    size_t length = 0;
    memset(text, 0, size);
    if (nc_inq_att(file->id, variable, attribute, &type, &length) != NC_NOERR)
    {
        return;
    }
    if (type == NC_CHAR && length < size)
    {
        nc_get_att_text(file->id, variable, attribute, text);
    }
    else if (type == NC_STRING && length == 1)
    {
        char* string = NULL;
        if (nc_get_att_string(file->id, variable, attribute, &string) == NC_NOERR && string != NULL)
        {
            length = strlen(string);
            memcpy(text, string, length < size ? length : size - 1);
        }
        nc_free_string(1, &string);
    }
    text[size - 1] = '\0';
    if (isPlain)
    {
        lower(text, true);
    }
}

void swGetNetcdfVariableName(const swNetcdfFile* file, int variable, char name[257])
{
    memset(name, 0, 257);
    nc_inq_varname(file->id, variable, name);
    lower(name, false);
}

size_t swGetNetcdfLength(const swNetcdfFile* file, int dimension)
{
    size_t length = 0;
    return nc_inq_dimlen(file->id, dimension, &length) == NC_NOERR ? length : 0;
}

void swGetNetcdfName(const swNetcdfFile* file, int dimension, char name[257])
{
    memset(name, 0, 257);
    nc_inq_dimname(file->id, dimension, name);
}

// The attribute may be a float and the values double, or the other way round.
static bool isFill(const swNetcdfVariable* variable, int which, double value)
{
    double fill = variable->fill[which];
    return variable->hasFill[which] && fabs(value - fill) <= 1e-7 * fabs(fill);
}

swResult swReadNetcdfBlock(const swNetcdfFile* file, const swNetcdfVariable* variable, const size_t* start,
                           const size_t* count, double* values)
{
    size_t total = 1;
    for (int i = 0; i < variable->dimensionCount; ++i)
    {
        total *= count[i];
    }
    nc_type type = NC_NAT;
    if (nc_inq_vartype(file->id, variable->id, &type) != NC_NOERR || type == NC_CHAR || type > NC_UINT64)
    {
        char name[257];
        swGetNetcdfVariableName(file, variable->id, name);
        return swFail(file->host, SW_ERROR_FORMAT, "%s: its variable %s does not hold numbers.", file->name, name);
    }
    int code = nc_get_vara_double(file->id, variable->id, start, count, values);
    if (code != NC_NOERR && code != NC_ERANGE)
    {
        return swFail(file->host, SW_ERROR_FORMAT, "%s: numbers could not be read: %s.", file->name, nc_strerror(code));
    }
    for (size_t i = 0; i < total; ++i)
    {
        bool isGap = isFill(variable, 0, values[i]) || isFill(variable, 1, values[i]) || !(fabs(values[i]) < 1e30);
        values[i] = isGap ? (double)NAN : values[i] * variable->scale + variable->offset;
    }
    return SW_SUCCESS;
}
