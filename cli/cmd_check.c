// SPDX-License-Identifier: MIT
// `seaway check`: reads a scene file and says what is wrong with it.

#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "text.h"
#include "verbs.h"

#define MAX_PROBLEMS 256

typedef struct Problem
{
    swLogLevel level;
    int line; // of the scene file; 0: none
    char code[32];
    char text[5000];
} Problem;

typedef struct ProblemList
{
    const char* path;
    Problem problems[MAX_PROBLEMS];
    int errorCount, warningCount, infoCount; // also of those for which there was no room
} ProblemList;

static int CountProblems(const ProblemList* list)
{
    int count = list->errorCount + list->warningCount + list->infoCount;
    return count < MAX_PROBLEMS ? count : MAX_PROBLEMS;
}

// The library writes "scene.yaml:12: what is wrong; what would be right. [code]" of the scene, and speaks of other
// files without a code.
static void ReadMessage(const char* path, const char* message, Problem* problem)
{
    size_t length = strlen(path);
    if (strncmp(message, path, length) == 0 && message[length] == ':')
    {
        problem->line = atoi(message + length + 1);
    }
    snprintf(problem->text, sizeof(problem->text), "%s", message);
    char* bracket = strrchr(problem->text, '[');
    size_t codeLength = bracket != NULL ? strspn(bracket + 1, "abcdefghijklmnopqrstuvwxyz_") : 0;
    if (codeLength > 0 && codeLength < sizeof(problem->code) && strcmp(bracket + 1 + codeLength, "]") == 0)
    {
        memcpy(problem->code, bracket + 1, codeLength);
        *bracket = 0;
        bracket[-1] = bracket > problem->text && bracket[-1] == ' ' ? 0 : bracket[-1];
    }
}

static void AddProblem(ProblemList* list, swLogLevel level, const char* message)
{
    int count = CountProblems(list);
    *(level == SW_LOG_ERROR     ? &list->errorCount
      : level == SW_LOG_WARNING ? &list->warningCount
                                : &list->infoCount) += 1;
    if (count < MAX_PROBLEMS)
    {
        list->problems[count].level = level;
        ReadMessage(list->path, message, &list->problems[count]);
    }
}

// What the library says while it reads; its information is not about the scene.
static void TakeProblem(void* context, swLogLevel level, const char* message)
{
    if (level != SW_LOG_INFO)
    {
        AddProblem(context, level, message);
    }
}

static const char* GetSeverity(const Problem* problem)
{
    return problem->level == SW_LOG_ERROR ? "error" : problem->level == SW_LOG_WARNING ? "warning" : "info";
}

// Codes of what has none: the file itself, and files that the scene names.
static const char* GetCode(const Problem* problem, swResult result)
{
    return problem->code[0] != 0              ? problem->code
           : problem->level == SW_LOG_WARNING ? "warning"
           : result == SW_SUCCESS             ? "error"
                                              : swResult_GetName(result);
}

static void PrintProblems(const ProblemList* list, swResult result)
{
    static char line[4 * sizeof(list->problems[0].text)];
    for (int i = 0; i < CountProblems(list); ++i)
    {
        const Problem* problem = list->problems + i;
        printf("%s: %s [%s]\n", GetSeverity(problem), CopyPrintable(line, sizeof(line), problem->text),
               GetCode(problem, result));
    }
    printf("%s: ", CopyPrintable(line, sizeof(line), list->path));
    if (list->errorCount + list->warningCount == 0)
    {
        printf("fine\n");
        return;
    }
    printf("%s, %d error%s, %d warning%s\n", list->errorCount > 0 ? "not usable" : "usable", list->errorCount,
           list->errorCount == 1 ? "" : "s", list->warningCount, list->warningCount == 1 ? "" : "s");
}

static void PrintProblemsJson(const ProblemList* list, swResult result)
{
    Json json = OpenJson(stdout);
    JsonOpenObject(&json, NULL);
    JsonText(&json, "scene", list->path);
    JsonText(&json, "result", swResult_GetName(result));
    JsonInteger(&json, "error_count", list->errorCount);
    JsonInteger(&json, "warning_count", list->warningCount);
    JsonInteger(&json, "info_count", list->infoCount);
    JsonOpenArray(&json, "problems");
    for (int i = 0; i < CountProblems(list); ++i)
    {
        const Problem* problem = list->problems + i;
        JsonOpenObject(&json, NULL);
        JsonText(&json, "code", GetCode(problem, result));
        JsonText(&json, "severity", GetSeverity(problem));
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

// Reading has told some of them already.
static bool IsTold(const ProblemList* list, const swSceneRemark* remark)
{
    for (int i = 0; i < CountProblems(list); ++i)
    {
        if (list->problems[i].line == remark->line && strcmp(list->problems[i].code, remark->code) == 0)
        {
            return true;
        }
    }
    return false;
}

static void TakeRemarks(ProblemList* list, const swScene* scene, const swWorld* world)
{
    static swSceneRemark remarks[MAX_PROBLEMS];
    int count = swScene_Check(scene, world, MAX_PROBLEMS, remarks);
    for (int i = 0; i < count && i < MAX_PROBLEMS; ++i)
    {
        char message[sizeof(list->problems[0].text)];
        snprintf(message, sizeof(message), "%s:%d: %s [%s]", list->path, remarks[i].line, remarks[i].text,
                 remarks[i].code);
        if (!IsTold(list, &remarks[i]))
        {
            AddProblem(list, remarks[i].severity, message);
        }
    }
}

// Read the scene and make its world, which checks what single keys cannot show.
static swResult CheckScene(ProblemList* list)
{
    swHost host = MakeHost();
    host.log = TakeProblem;
    host.logContext = list;
    swScene* scene = NULL;
    swWorld* world = NULL;
    swResult result = swReadScene(&host, list->path, &scene);
    if (result == SW_SUCCESS)
    {
        result = swCreateSceneWorld(&host, scene, &world);
    }
    if (result == SW_SUCCESS)
    {
        TakeRemarks(list, scene, world);
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
                       .text = "Read a scene file, make its world, and print every problem with its line, what would\n"
                               "be right, and its code; docs/checks.md lists the codes. Exit code 1 if there is an\n"
                               "error or a warning; information does not change it.",
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
    list.path = path;
    swResult result = CheckScene(&list);
    if (asJson)
    {
        PrintProblemsJson(&list, result);
    }
    else
    {
        PrintProblems(&list, result);
    }
    bool isFine = result == SW_SUCCESS && list.errorCount + list.warningCount == 0;
    return FinishOutput() && isFine ? EXIT_FINE : EXIT_PROBLEM;
}
