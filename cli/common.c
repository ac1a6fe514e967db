// SPDX-License-Identifier: MIT
#include "common.h"

#include <math.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <string.h>
#include <unistd.h>

#include "progress.h"
#include "text.h"

#define LONGEST_MESSAGE 10000 // two paths and a sentence

static atomic_int errorCount; // messages of the library at error level

void Complain(const char* format, ...)
{
    char text[LONGEST_MESSAGE], line[LONGEST_MESSAGE + 16] = "seaway: ";
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof(text), format, arguments);
    va_end(arguments);
    CopyPrintable(line + 8, sizeof(line) - 8, text);
    WriteTerminalLine(line);
}

static void LogFromLibrary(void* context, swLogLevel level, const char* message)
{
    (void)context;
    errorCount += level == SW_LOG_ERROR;
    if (level != SW_LOG_INFO)
    {
        Complain("%s%s", level == SW_LOG_WARNING ? "warning: " : "", message);
    }
}

swHost MakeHost(void)
{
    swHost host = swDefaultHost();
    host.log = LogFromLibrary;
    return host;
}

void ComplainAboutResult(swResult result, const char* what)
{
    if (errorCount == 0)
    {
        Complain("%s: %s", what, swResult_GetText(result));
    }
}

swTaskPool* AttachThreads(swHost* host, int threadCount)
{
    long online = threadCount > 0 ? threadCount : sysconf(_SC_NPROCESSORS_ONLN);
    int extra = online < 2 ? 0 : online > 64 ? 63 : (int)online - 1;
    swTaskPool* pool = NULL;
    if (extra == 0 || swCreateTaskPool(host, extra, &pool) != SW_SUCCESS)
    {
        return NULL; // one thread does the same, only slower
    }
    swTaskPool_Attach(pool, host);
    return pool;
}

void GetMachineName(char* name, size_t size)
{
    snprintf(name, size, "unknown");
    FILE* file = fopen("/proc/cpuinfo", "r");
    if (file == NULL)
    {
        return;
    }
    char line[256];
    while (fgets(line, sizeof(line), file) != NULL)
    {
        char* colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) == 0 && colon != NULL)
        {
            colon[1 + strcspn(colon + 1, "\n")] = 0;
            snprintf(name, size, "%s", colon + 1 + strspn(colon + 1, " "));
            break;
        }
    }
    fclose(file);
}

bool FinishOutput(void)
{
    if (fflush(stdout) != 0 || ferror(stdout))
    {
        Complain("the output could not be written; is the disk full?");
        return false;
    }
    return true;
}

double BearingFrom(double direction)
{
    double degrees = fmod(direction * (180.0 / SW_PI) - 90.0, 360.0);
    degrees = degrees < 0.0 ? degrees + 360.0 : degrees;
    return degrees >= 360.0 ? 0.0 : degrees;
}

void WriteSeaState(Json* json, const swSeaState* state)
{
    JsonNumber(json, "hs_m", (double)state->significantHeight);
    JsonNumber(json, "tp_s", (double)state->peakPeriod);
    JsonNumber(json, "tm01_s", (double)state->periodTm01);
    JsonNumber(json, "tm02_s", (double)state->periodTm02);
    JsonNumber(json, "te_s", (double)state->energyPeriod);
    JsonNumber(json, "mean_direction_from_deg", BearingFrom((double)state->meanDirection));
    JsonNumber(json, "peak_direction_from_deg", BearingFrom((double)state->peakDirection));
    JsonNumber(json, "spread_deg", (double)state->spread * (180.0 / SW_PI));
    JsonNumber(json, "mean_square_slope", (double)state->meanSquareSlope);
}
