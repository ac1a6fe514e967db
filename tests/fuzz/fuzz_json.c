// SPDX-License-Identifier: MIT
// Measured seas in JSON from anywhere. What is read must be spectra.

#include "fuzz_sea.h"
#include "files/measured_formats.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    swHost host = swDefaultHost();
    host.log = CountMessage;
    int messages = 0;
    host.logContext = &messages;
    swMeasuredSea* sea = NULL;
    swResult result = swReadJsonSea(&host, size > 0 ? (const char*)data : "", size, "fuzz.json", &sea);
    FUZZ_CHECK((result == SW_SUCCESS) == (sea != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (sea != NULL)
    {
        CheckSea(sea);
    }
    swDestroyMeasuredSea(sea);
    return 0;
}
