// SPDX-License-Identifier: MIT

#include "scene/netcdf_file.h"

#include <math.h>
#include <netcdf.h>
#include <string.h>

#include "core/base/host.h"

static bool getNumber(const swNetcdfFile* file, int variable, const char* attribute, double* value)
{
    nc_type type = NC_NAT;
    size_t length = 0;
    return nc_inq_att(file->id, variable, attribute, &type, &length) == NC_NOERR && length == 1 && type != NC_CHAR &&
           type != NC_STRING && type <= NC_UINT64 &&
           nc_get_att_double(file->id, variable, attribute, value) == NC_NOERR;
}

bool swFindNetcdfVariable(const swNetcdfFile* file, const char* name, swNetcdfVariable* variable)
{
    memset(variable, 0, sizeof(*variable));
    if (nc_inq_varid(file->id, name, &variable->id) != NC_NOERR ||
        nc_inq_varndims(file->id, variable->id, &variable->dimensionCount) != NC_NOERR ||
        variable->dimensionCount > SW_NETCDF_MAX_DIMENSIONS ||
        nc_inq_vardimid(file->id, variable->id, variable->dimensions) != NC_NOERR)
    {
        return false;
    }
    variable->scale = 1.0;
    getNumber(file, variable->id, "scale_factor", &variable->scale);
    getNumber(file, variable->id, "add_offset", &variable->offset);
    variable->hasFill[0] = getNumber(file, variable->id, "_FillValue", &variable->fill[0]);
    variable->hasFill[1] = getNumber(file, variable->id, "missing_value", &variable->fill[1]);
    return true;
}

void swGetNetcdfText(const swNetcdfFile* file, int variable, const char* attribute, char* text, size_t size)
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
    for (; *text != '\0'; ++text)
    {
        *text = *text >= 'A' && *text <= 'Z' ? (char)(*text + 32) : *text == '_' ? ' ' : *text;
    }
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

swResult swReadNetcdfBlock(const swNetcdfFile* file, const swNetcdfVariable* variable, const size_t* start,
                           const size_t* count, double* values)
{
    size_t total = 1;
    for (int i = 0; i < variable->dimensionCount; ++i)
    {
        total *= count[i];
    }
    int code = nc_get_vara_double(file->id, variable->id, start, count, values);
    if (code != NC_NOERR && code != NC_ERANGE)
    {
        return swFail(file->host, SW_ERROR_FORMAT, "%s: numbers could not be read: %s.", file->name, nc_strerror(code));
    }
    for (size_t i = 0; i < total; ++i)
    {
        bool isGap = (variable->hasFill[0] && values[i] == variable->fill[0]) ||
                     (variable->hasFill[1] && values[i] == variable->fill[1]) || !(fabs(values[i]) < 1e30);
        values[i] = isGap ? (double)NAN : values[i] * variable->scale + variable->offset;
    }
    return SW_SUCCESS;
}
