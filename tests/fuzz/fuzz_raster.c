// SPDX-License-Identifier: MIT
// Rasters in files from anywhere: text, PNG, EXR, TIFF and, by the first byte, numbers without a heading. What is read
// is finite or unknown, and what is refused is told. netCDF is left to those who write libhdf5.

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "fuzz.h"
#include "seaway/files.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    char path[64];
    snprintf(path, sizeof(path), "/tmp/fuzz_raster_%ld.tmp", (long)getpid());
    if (size < 4 || size > 1 << 18 || memcmp(data, "CDF", 3) == 0 || memcmp(data, "\x89HDF", 4) == 0)
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
