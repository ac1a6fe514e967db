// SPDX-License-Identifier: MIT
// Places of a netCDF file: names, and where they lie. WAVEWATCH III gives latitude and longitude by time and station,
// ERA5 as the coordinates of a grid, CDIP as numbers of the whole file, a drifting buoy by time: it is where it was
// first.

#include <math.h>
#include <netcdf.h>
#include <string.h>

#include "files/netcdf_axes.h"

#define MAX_TRIES ((size_t)16) // times that are looked at for a place's first position

static bool findOne(const swNetcdfFile* file, const char* const* names, swNetcdfVariable* variable)
{
    for (; *names != NULL; ++names)
    {
        if (swFindNetcdfVariable(file, *names, variable))
        {
            return true;
        }
    }
    return false;
}

// The first value that is one; before it a buoy may not have known where it is.
static double readPosition(const swNetcdfAxes* axes, const swNetcdfVariable* variable, size_t* start)
{
    double value = (double)NAN;
    bool moves = false;
    for (int i = 0; i < variable->dimensionCount && axes->timeAt >= 0; ++i)
    {
        moves = moves || variable->dimensions[i] == axes->main.dimensions[axes->timeAt];
    }
    size_t tries = !moves ? 1 : axes->timeCount < MAX_TRIES ? axes->timeCount : MAX_TRIES;
    for (size_t i = 0; i < tries && value != value; ++i)
    {
        if (axes->timeAt >= 0)
        {
            start[axes->timeAt] = i;
        }
        value = swReadNetcdfAt(axes, variable, start);
    }
    return value;
}

void swFindNetcdfPlace(const swNetcdfAxes* axes, size_t place, size_t start[SW_NETCDF_MAX_DIMENSIONS])
{
    for (int i = axes->main.dimensionCount - 1; i >= 0; --i)
    {
        bool isPlace = axes->roles[i] == SW_NETCDF_PLACE;
        start[i] = isPlace ? place % axes->lengths[i] : 0;
        place /= isPlace ? axes->lengths[i] : 1;
    }
}

// Index along the main variable's dimension that a variable shares; 0 if it shares none.
static size_t findIndex(const swNetcdfAxes* axes, const swNetcdfVariable* variable, const size_t* start)
{
    size_t index = 0;
    for (int j = 0; j < axes->main.dimensionCount && variable->dimensionCount > 0; ++j)
    {
        index = variable->dimensions[0] == axes->main.dimensions[j] ? start[j] : index;
    }
    return index;
}

// station_name(station, string16), or of strings station_name(station), or one name for the whole file.
static void readName(const swNetcdfAxes* axes, const size_t* start, char name[64])
{
    static const char* const names[] = {"station_name", "station_id", "platform_name", "metaStationName", NULL};
    const swNetcdfFile* file = &axes->file;
    swNetcdfVariable variable;
    nc_type type = NC_NAT;
    memset(name, 0, 64);
    if (!findOne(file, names, &variable) || nc_inq_vartype(file->id, variable.id, &type) != NC_NOERR ||
        variable.dimensionCount > 2)
    {
        return;
    }
    size_t at[2] = {findIndex(axes, &variable, start), 0}, count[2] = {1, 1};
    if (type == NC_CHAR && variable.dimensionCount > 0)
    {
        int last = variable.dimensionCount - 1;
        size_t length = swGetNetcdfLength(file, variable.dimensions[last]);
        at[last] = 0;
        count[last] = length < 63 ? length : 63;
        if (nc_get_vara_text(file->id, variable.id, at, count, name) != NC_NOERR)
        {
            name[0] = '\0';
        }
    }
    char* string = NULL;
    if (type == NC_STRING && variable.dimensionCount < 2 &&
        nc_get_var1_string(file->id, variable.id, at, &string) == NC_NOERR && string != NULL)
    {
        size_t length = strlen(string);
        memcpy(name, string, length < 63 ? length : 63);
        nc_free_string(1, &string);
    }
}

// A buoy's number may stand in an attribute of the file.
static void readNameOfFile(const swNetcdfAxes* axes, char name[64])
{
    static const char* const attributes[] = {"station", "platform_code", "wmo_id", "id", NULL};
    for (const char* const* attribute = attributes; *attribute != NULL && name[0] == '\0'; ++attribute)
    {
        swGetNetcdfText(&axes->file, NC_GLOBAL, *attribute, false, name, 64);
    }
}

static void trim(char* name)
{
    for (size_t length = strlen(name); length > 0 && name[length - 1] == ' '; --length)
    {
        name[length - 1] = '\0';
    }
}

swResult swAddNetcdfPlaces(const swNetcdfAxes* axes, swMeasuredSea* sea)
{
    static const char* const longitudes[] = {
        "longitude",         "lon", "LONGITUDE", "Longitude", "metaDeployLongitude", "metaStationLongitude",
        "PRECISE_LONGITUDE", "Lon", NULL};
    static const char* const latitudes[] = {
        "latitude",         "lat", "LATITUDE", "Latitude", "metaDeployLatitude", "metaStationLatitude",
        "PRECISE_LATITUDE", "Lat", NULL};
    swNetcdfVariable longitude, latitude;
    bool isSomewhere = findOne(&axes->file, longitudes, &longitude) && findOne(&axes->file, latitudes, &latitude);
    swResult result = SW_SUCCESS;
    for (size_t place = 0; place < axes->placeCount && result == SW_SUCCESS; ++place)
    {
        char name[64];
        size_t start[SW_NETCDF_MAX_DIMENSIONS];
        swFindNetcdfPlace(axes, place, start);
        readName(axes, start, name);
        if (axes->placeCount == 1)
        {
            readNameOfFile(axes, name);
        }
        trim(name);
        double x = isSomewhere ? readPosition(axes, &longitude, start) : (double)NAN;
        double y = isSomewhere ? readPosition(axes, &latitude, start) : (double)NAN;
        result = swMeasuredSea_AddLocation(sea, name, x, y, NULL);
    }
    return result;
}
