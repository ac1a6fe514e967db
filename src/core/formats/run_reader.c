// SPDX-License-Identifier: MIT
// What the readers of all formats have in common: from the text to a finished sea.

#include "core/formats/measured_readers.h"

swResult swJudgeRecord(swSeaReader* reader, swResult result, int line)
{
    return reader->sea->isFull ? result : swJudgeTrial(&reader->trial, result, "line", line);
}

// A sea of which nothing is left is told by what was wrong with its first record.
static swResult finish(const swHost* host, swSeaReader* reader, swResult result)
{
    reader->sea->host = *host; // the trial's ends here
    result = swEndTrial(&reader->trial, result);
    if (result == SW_SUCCESS && reader->sea->records.count == 0 && reader->trial.leftOutCount > 0)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s Nothing else could be read.", reader->trial.first);
    }
    return result == SW_SUCCESS ? swMeasuredSea_Finish(reader->sea) : result;
}

swResult swRunReader(const swHost* host, const char* text, size_t size, const char* name, size_t readerSize,
                     swReadSeaFcn read, swMeasuredSea** sea)
{
    *sea = NULL;
    swSeaReader* reader = swAllocateZero(host, readerSize);
    if (reader == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", name);
    }
    swBeginTrial(&reader->trial, host);
    reader->text = swOpenText(&reader->trial.host, text, size, name);
    swResult result = swCreateMeasuredSea(&reader->trial.host, name, &reader->sea);
    result = result == SW_SUCCESS ? finish(host, reader, read(reader)) : swEndTrial(&reader->trial, result);
    if (result == SW_SUCCESS)
    {
        *sea = reader->sea;
    }
    else
    {
        swDestroyMeasuredSea(reader->sea);
    }
    swFree(host, reader, readerSize);
    return result;
}

swResult swMakeFilledSea(const swHost* host, const char* name, swFillSeaFcn fill, const void* file, swMeasuredSea** sea)
{
    swMeasuredSea* made = NULL;
    swResult result = swCreateMeasuredSea(host, name, &made);
    result = result == SW_SUCCESS ? fill(host, file, made) : result;
    result = result == SW_SUCCESS ? swMeasuredSea_Finish(made) : result;
    if (result != SW_SUCCESS)
    {
        swDestroyMeasuredSea(made);
        return result;
    }
    *sea = made;
    return SW_SUCCESS;
}
