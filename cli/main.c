// SPDX-License-Identifier: MIT
// `seaway`: one program with a verb for each job. Data go to stdout, messages to stderr.

#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "args.h"
#include "progress.h"
#include "text.h"
#include "verbs.h"

typedef struct VerbEntry
{
    const char* name;
    VerbFcn* run;
    const char* summary;
} VerbEntry;

static const VerbEntry verbs[] = {
    {"view", RunView, "look at a sea in a window"},
    {"render", RunRender, "make a picture, numbered frames or a video, without a window"},
    {"query", RunQuery, "heights, displacements and normals at points, as CSV"},
    {"stats", RunStats, "measure the sea state of a scene beside what was asked"},
    {"spectrum", RunSpectrum, "read, print and plot a measured sea state"},
    {"check", RunCheck, "find mistakes in a scene file"},
    {"bench", RunBench, "time steps, queries and passes on this machine"},
    {"devices", RunDevices, "list Vulkan devices and what each lacks"},
};
#define LONGEST_MESSAGE 10000 // two paths and a sentence
#define VERB_COUNT ((int)(sizeof(verbs) / sizeof(verbs[0])))

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

double GetSeconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
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

static void PrintUsage(FILE* file)
{
    fprintf(file, "Usage: seaway VERB [arguments]\n\nAn ocean, from a measured sea to a picture.\n\n");
    for (int i = 0; i < VERB_COUNT; ++i)
    {
        fprintf(file, "  %-10s %s\n", verbs[i].name, verbs[i].summary);
    }
    fprintf(file, "\n`seaway VERB --help` tells more; `seaway --version` prints the version.\n"
                  "Exit codes: 0 fine, 1 ran and found problems, 2 wrong arguments.\n");
}

static int RunVerb(int argumentCount, char** arguments)
{
    const char* names[VERB_COUNT + 1];
    for (int i = 0; i < VERB_COUNT; ++i)
    {
        if (strcmp(arguments[0], verbs[i].name) == 0)
        {
            return verbs[i].run(argumentCount, arguments);
        }
        names[i] = verbs[i].name;
    }
    names[VERB_COUNT] = NULL;
    const char* nearest = FindNearestName(arguments[0], names);
    if (nearest != NULL)
    {
        Complain("there is no verb \"%s\"; did you mean %s?", arguments[0], nearest);
    }
    else
    {
        Complain("there is no verb \"%s\"; `seaway --help` lists them", arguments[0]);
    }
    return EXIT_USAGE;
}

int main(int argumentCount, char** arguments)
{
    signal(SIGXFSZ, SIG_IGN); // a file that may not grow is an error of write(), with a sentence, not a crash
    if (argumentCount < 2)
    {
        PrintUsage(stderr);
        return EXIT_USAGE;
    }
    const char* first = arguments[1];
    if (strcmp(first, "--version") == 0)
    {
        int version = swGetVersion();
        printf("seaway %d.%d.%d\n", version / 10000, version / 100 % 100, version % 100);
        return FinishOutput() ? EXIT_FINE : EXIT_PROBLEM;
    }
    bool isHelp = strcmp(first, "--help") == 0 || strcmp(first, "-h") == 0 || strcmp(first, "help") == 0;
    if (isHelp && argumentCount < 3)
    {
        PrintUsage(stdout);
        return FinishOutput() ? EXIT_FINE : EXIT_PROBLEM;
    }
    if (isHelp)
    {
        char help[] = "--help";
        char* helpArguments[] = {arguments[2], help, NULL};
        return RunVerb(2, helpArguments);
    }
    return RunVerb(argumentCount - 1, arguments + 1);
}
