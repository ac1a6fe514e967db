// SPDX-License-Identifier: MIT
// `seaway check`: reads a scene file and says what is wrong with it.

#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "text.h"
#include "verbs.h"

#define MAX_PROBLEMS 64

typedef struct Problem
{
    swLogLevel level;
    int line; // 0: none
    char text[1024];
} Problem;

typedef struct ProblemList
{
    Problem problems[MAX_PROBLEMS];
    int count, errorCount;
} ProblemList;

// The library writes "file:line: what is wrong".
static int FindLine(const char* message)
{
    for (const char* colon = strchr(message, ':'); colon != NULL; colon = strchr(colon + 1, ':'))
    {
        char* end = NULL;
        long line = strtol(colon + 1, &end, 10);
        if (end != colon + 1 && *end == ':' && line > 0)
        {
            return (int)line;
        }
    }
    return 0;
}

static void TakeProblem(void* context, swLogLevel level, const char* message)
{
    ProblemList* list = context;
    if (level == SW_LOG_INFO || list->count == MAX_PROBLEMS)
    {
        return;
    }
    Problem* problem = list->problems + list->count++;
    problem->level = level;
    problem->line = FindLine(message);
    snprintf(problem->text, sizeof(problem->text), "%s", message);
    list->errorCount += level == SW_LOG_ERROR;
}

static void PrintProblems(const char* path, const ProblemList* list, swResult result, bool asJson)
{
    char line[4 * sizeof(list->problems[0].text)];
    for (int i = 0; i < list->count && !asJson; ++i)
    {
        printf("%s: %s\n", list->problems[i].level == SW_LOG_ERROR ? "error" : "warning",
               CopyPrintable(line, sizeof(line), list->problems[i].text));
    }
    if (!asJson)
    {
        printf("%s: %s\n", CopyPrintable(line, sizeof(line), path),
               result == SW_SUCCESS ? "fine" : swResult_GetName(result));
        return;
    }
    Json json = OpenJson(stdout);
    JsonOpenObject(&json, NULL);
    JsonText(&json, "scene", path);
    JsonText(&json, "result", swResult_GetName(result));
    JsonOpenArray(&json, "problems");
    for (int i = 0; i < list->count; ++i)
    {
        const Problem* problem = list->problems + i;
        JsonOpenObject(&json, NULL);
        JsonText(&json, "code", problem->level == SW_LOG_ERROR ? swResult_GetName(result) : "SW_WARNING");
        JsonText(&json, "severity", problem->level == SW_LOG_ERROR ? "error" : "warning");
        if (problem->line > 0)
        {
            JsonInteger(&json, "line", problem->line);
        }
        else
        {
            JsonNull(&json, "line");
        }
        JsonText(&json, "message", problem->text);
        JsonCloseObject(&json);
    }
    JsonCloseArray(&json);
    JsonCloseObject(&json);
}

// Read the scene and make its world, which checks what single keys cannot show.
static swResult CheckScene(const char* path, ProblemList* list)
{
    swHost host = MakeHost();
    host.log = TakeProblem;
    host.logContext = list;
    swScene* scene = NULL;
    swWorld* world = NULL;
    swResult result = swReadScene(&host, path, &scene);
    if (result == SW_SUCCESS)
    {
        result = swCreateSceneWorld(&host, scene, &world);
    }
    if (result == SW_SUCCESS && scene->viewCount == 0)
    {
        TakeProblem(list, SW_LOG_WARNING, "the scene has no views, so `seaway render` cannot draw it");
    }
    if (result != SW_SUCCESS && list->errorCount == 0)
    {
        TakeProblem(list, SW_LOG_ERROR, swResult_GetText(result));
    }
    swDestroyWorld(world);
    swDestroyScene(scene);
    return result;
}

int RunCheck(int argumentCount, char** arguments)
{
    bool asJson = false;
    const char* path = NULL;
    const Option options[] = {{.name = "json", .kind = OPTION_FLAG, .value = &asJson, .help = "print JSON"}};
    const Verb verb = {.name = "check",
                       .synopsis = "SCENE [--json]",
                       .text = "Read a scene file, make its world, and print every problem with its code and line.\n"
                               "Exit code 1 if there is one.",
                       .options = options,
                       .optionCount = 1,
                       .positionalMin = 1,
                       .positionalMax = 1,
                       .positionalName = "a scene file",
                       .positionals = &path};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    static ProblemList list;
    swResult result = CheckScene(path, &list);
    PrintProblems(path, &list, result, asJson);
    return FinishOutput() && result == SW_SUCCESS && list.count == 0 ? EXIT_FINE : EXIT_PROBLEM;
}
