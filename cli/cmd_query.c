// SPDX-License-Identifier: MIT
// `seaway query`: the surface at points and times, CSV in and CSV out.

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "gpu_answers.h"
#include "progress.h"
#include "verbs.h"

#define MAX_COLUMNS 16
#define BLOCK 65536 // points asked at once

typedef struct PointList
{
    swPosXZ* points;
    double* heights; // y of each point; 0 where the file has none
    bool hasHeights;
    int count, capacity;
} PointList;

typedef struct TimeRange
{
    double begin;
    double step;
    int count;
} TimeRange;

typedef struct Columns
{
    int x, y, z, count; // which column holds what, y -1 if none does; count 0: not known yet
} Columns;

// What is asked for.
typedef enum Question
{
    QUESTION_SURFACE,
    QUESTION_MOTION, // and how the particle there moves
    QUESTION_BELOW   // the water at the points' own heights
} Question;

static const char tooManyTimes[] = "query: --time %s asks for more than a million times";

// "T" or "A:B:STEP".
static bool ParseTimes(const char* text, TimeRange* range)
{
    double value[3] = {0.0, 0.0, 1.0};
    char copy[128];
    int count = 0;
    snprintf(copy, sizeof(copy), "%s", text);
    for (char* part = copy; part != NULL && count < 4; ++count)
    {
        char* colon = strchr(part, ':');
        if (colon != NULL)
        {
            *colon = 0;
        }
        if (count == 3 || !ParseNumber(part, value + count))
        {
            count = 0;
            break;
        }
        part = colon != NULL ? colon + 1 : NULL;
    }
    if (count != 1 && count != 3)
    {
        Complain("query: --time wants seconds, T or A:B:STEP, not \"%s\"", text);
        return false;
    }
    if (count == 1)
    {
        *range = (TimeRange){value[0], 1.0, 1};
        return true;
    }
    if (value[1] < value[0] || value[2] <= 0.0)
    {
        Complain("query: --time %s runs nowhere; it wants A <= B and STEP > 0", text);
        return false;
    }
    double steps = floor((value[1] - value[0]) / value[2] + 1e-9);
    if (steps >= 1e6)
    {
        Complain(tooManyTimes, text);
        return false;
    }
    *range = (TimeRange){value[0], value[2], (int)steps + 1};
    return true;
}

// Cut a line at its commas, blanks around the fields removed. Returns the number of fields.
static int SplitLine(char* line, char** fields)
{
    int count = 0;
    line[strcspn(line, "\r\n")] = 0;
    for (char* part = line; part != NULL; ++count)
    {
        char* comma = strchr(part, ',');
        if (comma != NULL)
        {
            *comma = 0;
        }
        part += strspn(part, " \t");
        for (size_t end = strlen(part); end > 0 && strchr(" \t", part[end - 1]) != NULL; --end)
        {
            part[end - 1] = 0;
        }
        if (count < MAX_COLUMNS)
        {
            fields[count] = part;
        }
        part = comma != NULL ? comma + 1 : NULL;
    }
    return count;
}

// The first line: a header names the columns; without one there are two (x, z) or three (x, y, z).
static bool FindColumns(const char* name, int lineNumber, char** fields, int fieldCount, Columns* columns,
                        bool* isHeader)
{
    double number = 0.0;
    *isHeader = !ParseNumber(fields[0], &number);
    if (!*isHeader)
    {
        *columns = (Columns){.x = 0, .y = fieldCount == 3 ? 1 : -1, .z = fieldCount - 1, .count = fieldCount};
        if (fieldCount != 2 && fieldCount != 3)
        {
            Complain("%s:%d: a line without a header has 2 columns (x,z) or 3 (x,y,z), not %d", name, lineNumber,
                     fieldCount);
            return false;
        }
        return true;
    }
    *columns = (Columns){-1, -1, -1, fieldCount};
    for (int i = 0; i < fieldCount && i < MAX_COLUMNS; ++i)
    {
        columns->x = strcmp(fields[i], "x") == 0 || strcmp(fields[i], "x_m") == 0 ? i : columns->x;
        columns->y = strcmp(fields[i], "y") == 0 || strcmp(fields[i], "y_m") == 0 ? i : columns->y;
        columns->z = strcmp(fields[i], "z") == 0 || strcmp(fields[i], "z_m") == 0 ? i : columns->z;
    }
    if (columns->x < 0 || columns->z < 0)
    {
        Complain("%s:%d: the header names no column %s", name, lineNumber, columns->x < 0 ? "x" : "z");
        return false;
    }
    return true;
}

static bool AppendPoint(PointList* list, swPosXZ point, double y)
{
    if (list->count == list->capacity)
    {
        int capacity = list->capacity > 0 ? 2 * list->capacity : 1024;
        swPosXZ* points = realloc(list->points, (size_t)capacity * sizeof(swPosXZ));
        list->points = points != NULL ? points : list->points;
        double* heights = realloc(list->heights, (size_t)capacity * sizeof(double));
        list->heights = heights != NULL ? heights : list->heights;
        if (points == NULL || heights == NULL)
        {
            Complain("query: no memory for %d points", capacity);
            return false;
        }
        list->capacity = capacity;
    }
    list->heights[list->count] = y;
    list->points[list->count++] = point;
    return true;
}

static bool ReadLine(const char* name, int lineNumber, char* line, Columns* columns, PointList* list)
{
    char* fields[MAX_COLUMNS];
    int fieldCount = SplitLine(line, fields);
    if (fieldCount == 1 && fields[0][0] == 0)
    {
        return true; // an empty line
    }
    if (fieldCount > MAX_COLUMNS)
    {
        Complain("%s:%d: %d columns are more than %d", name, lineNumber, fieldCount, MAX_COLUMNS);
        return false;
    }
    if (columns->count == 0)
    {
        bool isHeader = false;
        if (!FindColumns(name, lineNumber, fields, fieldCount, columns, &isHeader))
        {
            return false;
        }
        if (isHeader)
        {
            return true;
        }
    }
    if (fieldCount != columns->count)
    {
        Complain("%s:%d: %d columns where the lines before have %d", name, lineNumber, fieldCount, columns->count);
        return false;
    }
    swPosXZ point;
    double y = 0.0;
    const int wanted[3] = {columns->x, columns->z, columns->y};
    double* values[3] = {&point.x, &point.z, &y};
    list->hasHeights = columns->y >= 0;
    for (int i = 0; i < (columns->y >= 0 ? 3 : 2); ++i)
    {
        if (!ParseNumber(fields[wanted[i]], values[i]))
        {
            Complain("%s:%d: \"%s\" is no number", name, lineNumber, fields[wanted[i]]);
            return false;
        }
    }
    return AppendPoint(list, point, y);
}

static bool ReadPoints(const char* path, PointList* list)
{
    bool isInput = strcmp(path, "-") == 0;
    const char* name = isInput ? "standard input" : path;
    FILE* file = isInput ? stdin : fopen(path, "r");
    if (file == NULL)
    {
        Complain("cannot read %s: %s", path, strerror(errno));
        return false;
    }
    Columns columns = {0};
    char line[1024];
    int lineNumber = 0;
    bool isFine = true;
    while (isFine && fgets(line, sizeof(line), file) != NULL)
    {
        ++lineNumber;
        if (strlen(line) + 1 == sizeof(line) && strchr(line, '\n') == NULL)
        {
            Complain("%s:%d: the line is longer than %d characters", name, lineNumber, (int)sizeof(line) - 2);
            isFine = false;
            break;
        }
        isFine = ReadLine(name, lineNumber, line, &columns, list);
    }
    if (isFine && ferror(file))
    {
        Complain("cannot read %s: %s", name, strerror(errno));
        isFine = false;
    }
    if (isFine && list->count == 0)
    {
        Complain("%s holds no points", name);
        isFine = false;
    }
    if (!isInput)
    {
        fclose(file);
    }
    return isFine;
}

// Who answers; gpu is NULL if the core does.
typedef struct Source
{
    Question question;
    swWorld* world;
    swSceneSea* sea;
    const swQueryDef* def;
    GpuAnswers* gpu;
} Source;

static bool Ask(const Source* source, int count, const swPosXZ* points, const swSurfaceSamples* samples)
{
    if (source->gpu != NULL)
    {
        return AskGpu(source->gpu, count, points, samples);
    }
    swWorld_QuerySurface(source->world, source->def, count, points, samples, NULL);
    return true;
}

static bool AskBelow(const Source* source, int count, const swPos* places, const swVolumeSamples* samples)
{
    if (source->gpu != NULL)
    {
        return AskGpuBelow(source->gpu, count, places, samples);
    }
    swWorld_QueryVolume(source->world, source->def, count, places, samples);
    return true;
}

static void PrintVector(swVec3 v)
{
    printf(",%.6g,%.6g,%.6g", (double)v.x, (double)v.y, (double)v.z);
}

// The surface at one time, a block of points at once.
static bool PrintSurface(const Source* source, const PointList* list)
{
    static float height[BLOCK], jacobian[BLOCK], residual[BLOCK];
    static swVec3 displacement[BLOCK], normal[BLOCK], velocity[BLOCK], acceleration[BLOCK];
    swSurfaceSamples samples = {
        .height = height, .displacement = displacement, .normal = normal, .jacobian = jacobian, .residual = residual};
    bool withMotion = source->question == QUESTION_MOTION;
    samples.velocity = withMotion ? velocity : NULL;
    samples.acceleration = withMotion ? acceleration : NULL;
    double time = swWorld_GetTime(source->world);
    for (int begin = 0; begin < list->count; begin += BLOCK)
    {
        int count = list->count - begin < BLOCK ? list->count - begin : BLOCK;
        if (!Ask(source, count, list->points + begin, &samples))
        {
            return false;
        }
        for (int i = 0; i < count; ++i)
        {
            printf("%.10g,%.10g,%.10g,%.7g", time, list->points[begin + i].x, list->points[begin + i].z,
                   (double)height[i]);
            PrintVector(displacement[i]);
            PrintVector(normal[i]);
            printf(",%.6g,%.3g", (double)jacobian[i], (double)residual[i]);
            if (withMotion)
            {
                PrintVector(velocity[i]);
                PrintVector(acceleration[i]);
            }
            putchar('\n');
        }
    }
    return true;
}

// The water at the points' own heights.
static bool PrintBelow(const Source* source, const PointList* list)
{
    static swPos places[BLOCK];
    static float depth[BLOCK], head[BLOCK];
    static swVec3 velocity[BLOCK], acceleration[BLOCK];
    const swVolumeSamples samples = {
        .depth = depth, .velocity = velocity, .acceleration = acceleration, .pressureHead = head};
    double time = swWorld_GetTime(source->world);
    for (int begin = 0; begin < list->count; begin += BLOCK)
    {
        int count = list->count - begin < BLOCK ? list->count - begin : BLOCK;
        for (int i = 0; i < count; ++i)
        {
            places[i] = (swPos){list->points[begin + i].x, list->heights[begin + i], list->points[begin + i].z};
        }
        if (!AskBelow(source, count, places, &samples))
        {
            return false;
        }
        for (int i = 0; i < count; ++i)
        {
            printf("%.10g,%.10g,%.10g,%.10g,%.6g", time, places[i].x, places[i].y, places[i].z, (double)depth[i]);
            PrintVector(velocity[i]);
            PrintVector(acceleration[i]);
            printf(",%.6g\n", (double)head[i]);
        }
    }
    return true;
}

static void PrintHeading(Question question)
{
    if (question == QUESTION_BELOW)
    {
        puts("t_s,x_m,y_m,z_m,depth_m,vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2,pressure_head_m");
        return;
    }
    printf("t_s,x_m,z_m,height_m,dx_m,dy_m,dz_m,nx,ny,nz,jacobian,residual_m%s\n",
           question == QUESTION_MOTION ? ",vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2" : "");
}

static int PrintTimes(const Source* source, const PointList* list, TimeRange times)
{
    PrintHeading(source->question);
    BeginProgress("times", times.count);
    for (int i = 0; i < times.count; ++i)
    {
        double time = times.begin + times.step * i;
        swWorld_SetTime(source->world, time);
        swResult result = swSceneSea_Advance(source->sea, time);
        result = result == SW_SUCCESS ? swWorld_Step(source->world, 0.0) : result;
        if (result != SW_SUCCESS)
        {
            EndProgress();
            ComplainAboutResult(result, "the sea could not be stepped");
            return EXIT_PROBLEM;
        }
        bool isPrinted = source->question == QUESTION_BELOW ? PrintBelow(source, list) : PrintSurface(source, list);
        if (!isPrinted)
        {
            EndProgress();
            return EXIT_PROBLEM;
        }
        if (ferror(stdout))
        {
            break;
        }
        UpdateProgress(i + 1);
    }
    EndProgress();
    return FinishOutput() ? EXIT_FINE : EXIT_PROBLEM;
}

static swGpuQueryDef MakeGpuDef(const swQueryDef* def, Question question, int capacity)
{
    swGpuQueryDef gpuDef = swDefaultGpuQueryDef();
    gpuDef.capacity = capacity;
    bool isBelow = question == QUESTION_BELOW;
    gpuDef.kind = isBelow ? SW_GPU_QUERY_KIND_VOLUME : SW_GPU_QUERY_KIND_SURFACE;
    gpuDef.outputs = isBelow ? 0 : SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL;
    gpuDef.outputs |= question != QUESTION_SURFACE ? SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION : 0;
    gpuDef.minWavelength = def->minWavelength;
    gpuDef.tolerance = def->tolerance;
    gpuDef.maxIterations = def->maxIterations;
    gpuDef.stretching = def->stretching;
    return gpuDef;
}

// `device` NULL: the core answers.
static int AnswerPoints(swWorld* world, swSceneSea* sea, const swQueryDef* def, const DeviceName* device,
                        Question question, const PointList* list, TimeRange times)
{
    Source source = {.world = world, .sea = sea, .def = def, .question = question};
    if (device != NULL)
    {
        swGpuQueryDef gpuDef = MakeGpuDef(def, question, list->count < BLOCK ? list->count : BLOCK);
        source.gpu = OpenGpuAnswers(device, world, &gpuDef);
        if (source.gpu == NULL)
        {
            return EXIT_PROBLEM;
        }
    }
    int exitCode = PrintTimes(&source, list, times);
    CloseGpuAnswers(source.gpu);
    return exitCode;
}

static int QueryScene(const char* scenePath, const char* timeText, const swQueryDef* def, const DeviceName* device,
                      Question question, const PointList* list)
{
    swHost host = MakeHost();
    swTaskPool* pool = AttachThreads(&host, 0);
    swScene* scene = NULL;
    swWorld* world = NULL;
    swSceneSea sea = {0};
    int exitCode = EXIT_PROBLEM;
    swResult result = swReadScene(&host, scenePath, &scene);
    if (result == SW_SUCCESS)
    {
        scene->world.enableQueries = device == NULL;
        scene->world.enableVelocity = scene->world.enableAcceleration = device == NULL && question == QUESTION_MOTION;
        result = swOpenScene(&host, scene, &world, &sea);
    }
    if (result == SW_SUCCESS)
    {
        TimeRange times = {scene->time, 1.0, 1};
        bool isFine = timeText == NULL || ParseTimes(timeText, &times);
        exitCode = isFine ? AnswerPoints(world, &sea, def, device, question, list, times) : EXIT_USAGE;
    }
    else
    {
        ComplainAboutResult(result, scenePath);
    }
    swDestroySceneSea(&sea);
    swDestroyWorld(world);
    swDestroyScene(scene);
    swDestroyTaskPool(pool);
    return exitCode;
}

int RunQuery(int argumentCount, char** arguments)
{
    static const char* const backends[] = {"cpu", "gpu", NULL};
    static const char* const stretchings[] = {"wheeler", "linear", NULL};
    const char* scenePath = NULL;
    const char* pointsPath = "-";
    const char* timeText = NULL;
    double minWavelength = 0.0, tolerance = 0.0005;
    int backend = 0, stretching = 0;
    bool withMotion = false, isBelow = false;
    DeviceName device = {.choice = SW_DEVICE_AUTO};
    const Option options[] = {
        {.name = "points",
         .kind = OPTION_TEXT,
         .value = &pointsPath,
         .placeholder = "FILE",
         .help = "CSV of points, - for standard input (default)"},
        {.name = "time",
         .kind = OPTION_TEXT,
         .value = &timeText,
         .placeholder = "T",
         .help = "seconds, or A:B:STEP for many times (default: the scene's time)"},
        {.name = "min-wavelength",
         .kind = OPTION_NUMBER,
         .value = &minWavelength,
         .placeholder = "L",
         .help = "leave out octaves of shorter waves, m (default 0)",
         .max = 1e4},
        {.name = "tolerance",
         .kind = OPTION_NUMBER,
         .value = &tolerance,
         .placeholder = "M",
         .help = "largest horizontal error of the search, m (default 0.0005)",
         .min = 1e-5,
         .max = 10.0},
        {.name = "motion",
         .kind = OPTION_FLAG,
         .value = &withMotion,
         .help = "also velocity and acceleration of the particle there"},
        {.name = "below",
         .kind = OPTION_FLAG,
         .value = &isBelow,
         .help = "the water at the points' own heights y instead of the surface above them"},
        {.name = "stretching",
         .kind = OPTION_CHOICE,
         .value = &stretching,
         .placeholder = "wheeler",
         .help = "of --below: how linear theory meets the surface, wheeler or linear (default wheeler)",
         .choices = stretchings},
        {.name = "backend",
         .kind = OPTION_CHOICE,
         .value = &backend,
         .placeholder = "cpu",
         .help = "who answers: cpu, or gpu for many points (default cpu)",
         .choices = backends},
        {.name = "device",
         .kind = OPTION_DEVICE,
         .value = &device,
         .placeholder = "D",
         .help = "of --backend gpu: auto, gpu, software, or a number of `seaway devices`"},
    };
    const Verb verb = {
        .name = "query",
        .synopsis = "SCENE [--points FILE] [--time T|A:B:STEP] [options]",
        .text =
            "Ask for the surface above points. The points come as CSV lines x,z or x,y,z in metres (x east, z\n"
            "south, y up and used by --below only), with or without a header line. The answers go to standard output:\n"
            "  t_s,x_m,z_m,height_m,dx_m,dy_m,dz_m,nx,ny,nz,jacobian,residual_m\n"
            "height above sea level's datum, displacement of the particle there, normal, Jacobian (1 flat, below\n"
            "0 folded over), and how far the answering particle is from the point asked for. The GPU gives the\n"
            "same answers to 0.1 mm, plus what the residuals allow.\n"
            "--motion appends vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2. --below answers with\n"
            "  t_s,x_m,y_m,z_m,depth_m,vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2,pressure_head_m\n"
            "depth below the surface, motion of the water, and dynamic pressure in metres of water.",
        .options = options,
        .optionCount = sizeof(options) / sizeof(options[0]),
        .positionalMin = 1,
        .positionalMax = 1,
        .positionalName = "a scene file",
        .positionals = &scenePath};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    TimeRange ignored;
    if (timeText != NULL && !ParseTimes(timeText, &ignored))
    {
        return EXIT_USAGE;
    }
    swQueryDef def = swDefaultQueryDef();
    def.minWavelength = (float)minWavelength;
    def.tolerance = (float)tolerance;
    def.stretching = (swStretching)stretching;
    if (withMotion && isBelow)
    {
        Complain("query: --below has the motion already; leave out --motion");
        return EXIT_USAGE;
    }
    Question question = isBelow ? QUESTION_BELOW : withMotion ? QUESTION_MOTION : QUESTION_SURFACE;
    PointList list = {0};
    const DeviceName* answering = backend == 1 ? &device : NULL;
    bool isRead = ReadPoints(pointsPath, &list);
    if (isRead && isBelow && !list.hasHeights)
    {
        Complain("query: --below needs points x,y,z; y is the height above the scene's datum, m");
        isRead = false;
    }
    int exitCode = isRead ? QueryScene(scenePath, timeText, &def, answering, question, &list) : EXIT_PROBLEM;
    free(list.points);
    free(list.heights);
    return exitCode;
}
