// SPDX-License-Identifier: MIT
// `seaway`: one program with a verb for each job. Data go to stdout, messages to stderr.

#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "args.h"
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
    {"bake", RunBake, "capture the sea floor of a scene in a file"},
    {"check", RunCheck, "find mistakes in a scene file"},
    {"bench", RunBench, "time steps, queries and passes on this machine"},
    {"devices", RunDevices, "list Vulkan devices and what each lacks"},
};
#define VERB_COUNT ((int)(sizeof(verbs) / sizeof(verbs[0])))

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
