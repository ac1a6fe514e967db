// SPDX-License-Identifier: MIT
// Rasters in files from anywhere: text, PNG, EXR, TIFF, classic netCDF and, by the first byte, numbers without a
// heading; by defs that hang on the bytes. What is read is finite or unknown, and what is refused is told. HDF5, which
// netCDF-4 files are, is left to those who write libhdf5.

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "fuzz.h"
#include "seaway/files.h"

// The same bytes are read in the same way.
static void ChooseDef(const uint8_t* data, size_t size, swRasterFileDef* def)
{
    uint32_t how = (uint32_t)size;
    for (size_t i = 0; i < size; ++i)
    {
        how = 31u * how + data[i];
    }
    if (how % 3 == 0)
    {
        return; // as it is
    }
    def->coordinates = (swRasterCoordinates)(how / 3 % SW_RASTER_COORDINATES_COUNT);
    def->originEast = how / 7 % 4 == 0 ? 179.9 : def->originEast;
    def->originNorth = how / 11 % 4 == 0 ? 88.0 : def->originNorth;
    def->west = how / 13 % 4 == 0 ? -50.0 : def->west;
    def->south = how / 17 % 4 == 0 ? 1e-3 : def->south;
    def->scale = how / 19 % 4 == 0 ? -1e6 : def->scale;
    def->missing = how / 23 % 4 == 0 ? 0.0 : def->missing;
    def->isDepth = how / 29 % 2 == 0;
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    char path[64];
    snprintf(path, sizeof(path), "/tmp/fuzz_raster_%ld.tmp", (long)getpid());
    if (size < 4 || size > 1 << 18 || memcmp(data, "\x89HDF", 4) == 0)
    {
        return 0;
    }
    FILE* file = fopen(path, "wb");
    FUZZ_CHECK(file != NULL && fwrite(data, 1, size, file) == size);
    fclose(file);
    swRasterFileDef def = swDefaultRasterFileDef();
    def.memoryLimit = 1 << 22;
    def.rawWidth = def.rawHeight = data[0] == 'r' ? (int)(data[1] % 16) + 1 : 0;
    def.numbers = (swRasterNumbers)(data[2] % SW_RASTER_NUMBERS_COUNT);
    ChooseDef(data, size, &def);
    swHost host = swDefaultHost();
    int messages = 0;
    host.log = CountMessage;
    host.logContext = &messages;
    swRaster* raster = NULL;
    swResult result = swReadRaster(&host, path, &def, &raster);
    remove(path);
    FUZZ_CHECK((result == SW_SUCCESS) == (raster != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (raster != NULL)
    {
        swRasterInfo info = swRaster_GetInfo(raster);
        const float* values = swRaster_GetValues(raster);
        for (int i = 0; i < info.width * info.height; ++i)
        {
            FUZZ_CHECK(isnan(values[i]) || fabsf(values[i]) <= 1e6f);
        }
    }
    swDestroyRaster(raster);
    return 0;
}
