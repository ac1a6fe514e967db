// SPDX-License-Identifier: MIT
#include "seaway/base.h"

static const struct
{
    const char* name;
    const char* text;
} results[SW_RESULT_COUNT] = {
#define SW_RESULT(resultName, resultText) {"SW_" #resultName, resultText},
#include "seaway/results.inl"
#undef SW_RESULT
};

const char* swResult_GetName(swResult result)
{
    return (unsigned)result < SW_RESULT_COUNT ? results[result].name : "SW_UNKNOWN";
}

const char* swResult_GetText(swResult result)
{
    return (unsigned)result < SW_RESULT_COUNT ? results[result].text : "unknown result";
}

int swGetVersion(void)
{
    return SW_VERSION_MAJOR * 10000 + SW_VERSION_MINOR * 100 + SW_VERSION_PATCH;
}
