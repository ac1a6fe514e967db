// SPDX-License-Identifier: MIT
// Measured seas in classic netCDF from anywhere. What is read must be spectra. HDF5, which netCDF-4 files are, is left
// to those who write libhdf5.

#include <unistd.h>

#include "fuzz_sea.h"
#include "seaway/files.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    char path[64];
    snprintf(path, sizeof(path), "/tmp/fuzz_netcdf_%ld.nc", (long)getpid());
    if (size < 4 || memcmp(data, "CDF", 3) != 0 || size > 1 << 20)
    {
        return 0;
    }
    FILE* file = fopen(path, "wb");
    FUZZ_CHECK(file != NULL && fwrite(data, 1, size, file) == size);
    fclose(file);
    swHost host = swDefaultHost();
    host.log = CountMessage;
    int messages = 0;
    host.logContext = &messages;
    swMeasuredSea* sea = NULL;
    swResult result = swReadMeasuredSea(&host, path, &sea);
    remove(path);
    FUZZ_CHECK((result == SW_SUCCESS) == (sea != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (sea != NULL)
    {
        CheckSea(sea);
    }
    swDestroyMeasuredSea(sea);
    return 0;
}
