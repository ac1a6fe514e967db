// SPDX-License-Identifier: MIT
// Texts of measured seas from anywhere, of whatever format they look like. What is read must be spectra.

#include "fuzz_sea.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    swHost host = swDefaultHost();
    host.log = CountMessage;
    int messages = 0;
    host.logContext = &messages;
    swMeasuredSea* sea = NULL;
    swResult result = swParseMeasuredSea(&host, size > 0 ? (const char*)data : "", size, "2020-01-02T03h04.spt", &sea);
    FUZZ_CHECK((result == SW_SUCCESS) == (sea != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (sea != NULL)
    {
        CheckSea(sea);
    }
    swDestroyMeasuredSea(sea);
    return 0;
}
