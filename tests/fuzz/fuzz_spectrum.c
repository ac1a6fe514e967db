// SPDX-License-Identifier: MIT
// NDBC texts from anywhere: five texts split from one input by the byte '|' (which no NDBC file holds), in the order
// energy, alpha1, alpha2, r1, r2; or, where the first has the heading of one, a summary. What is read must be a
// spectrum.

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz_sea.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const char* parts[5] = {(const char*)data};
    size_t sizes[5] = {size};
    for (int i = 0; i + 1 < 5 && parts[i] != NULL; ++i)
    {
        const char* bar = sizes[i] > 0 ? memchr(parts[i], '|', sizes[i]) : NULL;
        if (bar != NULL)
        {
            parts[i + 1] = bar + 1;
            sizes[i + 1] = sizes[i] - (size_t)(bar + 1 - parts[i]);
            sizes[i] = (size_t)(bar - parts[i]);
        }
    }
    swNdbcTexts texts = {
        .energy = size > 0 ? parts[0] : "",
        .alpha1 = parts[1],
        .alpha2 = parts[2],
        .r1 = parts[3],
        .r2 = parts[4],
        .energySize = sizes[0],
        .alpha1Size = sizes[1],
        .alpha2Size = sizes[2],
        .r1Size = sizes[3],
        .r2Size = sizes[4],
    };
    swHost host = swDefaultHost();
    host.log = CountMessage;
    int messages = 0;
    host.logContext = &messages;
    swMeasuredSea* sea = NULL;
    bool isSummary = swIsNdbcSummary(texts.energy, texts.energySize);
    swResult result = isSummary ? swParseNdbcSummary(&host, texts.energy, texts.energySize, NULL, &sea)
                                : swParseNdbc(&host, &texts, &sea);
    FUZZ_CHECK((result == SW_SUCCESS) == (sea != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (sea != NULL)
    {
        CheckSea(sea);
        for (int i = 0; i < swMeasuredSea_GetCount(sea) && i < 4; ++i)
        {
            FUZZ_CHECK(swMeasuredSea_FindTime(sea, swMeasuredSea_GetRecord(sea, i).time) == i);
        }
    }
    swDestroyMeasuredSea(sea);
    return 0;
}
