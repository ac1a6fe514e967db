// SPDX-License-Identifier: MIT
// `seaway query`: the water at points, along rays and on grids, at any times; CSV in and CSV out.

#include <math.h>
#include <string.h>

#include "args.h"
#include "decimal.h"
#include "progress.h"
#include "query_answers.h"
#include "verbs.h"

#define MOST_TIMES 1e6
#define MOST_MAP_POINTS 1e8

typedef struct TimeRange
{
    double begin;
    double step;
    int count;
} TimeRange;

// The arguments as they came; times and maps are text, and what was not given is NULL, or below 0.
typedef struct QueryArguments
{
    const char* scenePath;
    const char* pointsPath;
    const char* timeText;
    const char* mapText;
    const char* fieldsText;
    double minWavelength, tolerance, maxDistance;
    int backend, stretching;
    bool withMotion, isBelow, withDrift, ofParticles, isRays;
    DeviceName device;
} QueryArguments;

// Numbers with a separator between them: how many, or 0 if there are more than `most` or one is none.
static int ParseNumbers(const char* text, char separator, int most, double* values)
{
    char copy[256];
    int count = 0;
    if (snprintf(copy, sizeof(copy), "%s", text) >= (int)sizeof(copy))
    {
        return 0;
    }
    for (char* part = copy; part != NULL; ++count)
    {
        char* end = strchr(part, separator);
        if (end != NULL)
        {
            *end = 0;
        }
        if (count == most || !ParseNumber(part, values + count))
        {
            return 0;
        }
        part = end != NULL ? end + 1 : NULL;
    }
    return count;
}

// Places from `begin` to `end`, both included if the step divides the way but for the last bits of the two.
static double CountSteps(double begin, double end, double step)
{
    double lastBits = 0x1p-52 * (fabs(begin) + fabs(end)) / step;
    return floor((end - begin) / step + 1e-9 + fmin(lastBits, 0.25)) + 1.0;
}

static bool IsTime(double time)
{
    return fabs(time) <= SW_LARGEST_TIME;
}

// "T" or "A:B:STEP".
static bool ParseTimes(const char* text, TimeRange* range)
{
    double value[3] = {0.0, 0.0, 1.0};
    int count = ParseNumbers(text, ':', 3, value);
    if (count != 1 && count != 3)
    {
        Complain("query: --time wants seconds, T or A:B:STEP, not \"%s\"", text);
        return false;
    }
    if (!IsTime(value[0]) || !IsTime(value[1]))
    {
        Complain("query: --time %s goes beyond %.2g s, the largest time of a sea", text, SW_LARGEST_TIME);
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
    double most = fmax(fabs(value[0]), fabs(value[1]));
    if (value[1] > value[0] && most + value[2] == most)
    {
        Complain("query: --time %s has a step that is lost in times so large; a larger STEP is not", text);
        return false;
    }
    double times = CountSteps(value[0], value[1], value[2]);
    if (times > MOST_TIMES)
    {
        Complain("query: --time %s asks for more than a million times", text);
        return false;
    }
    *range = (TimeRange){value[0], value[2], (int)times};
    return true;
}

// "X0,Z0,X1,Z1,STEP".
static bool ParseMap(const char* text, swHeightMapDef* map)
{
    double value[5];
    if (ParseNumbers(text, ',', 5, value) != 5)
    {
        Complain("query: --map wants two corners and a spacing in metres, X0,Z0,X1,Z1,STEP, not \"%s\"", text);
        return false;
    }
    if (value[2] < value[0] || value[3] < value[1] || value[4] <= 0.0)
    {
        Complain("query: --map %s holds nothing; it wants X0 <= X1, Z0 <= Z1 and STEP > 0", text);
        return false;
    }
    double width = CountSteps(value[0], value[2], value[4]), height = CountSteps(value[1], value[3], value[4]);
    double farthest = fmax(width, height) * value[4];
    for (int i = 0; i < 4; ++i)
    {
        farthest = fmax(farthest, fabs(value[i]));
    }
    if (farthest > FARTHEST_POINT)
    {
        Complain("query: --map %s is larger or farther out than %.0g m", text, FARTHEST_POINT);
        return false;
    }
    if (width * height > MOST_MAP_POINTS)
    {
        Complain("query: --map %s asks for %.3g points, more than %.0g; a larger STEP makes them fewer", text,
                 width * height, MOST_MAP_POINTS);
        return false;
    }
    *map = (swHeightMapDef){value[0], value[1], value[4], (int)width, (int)height};
    return true;
}

static int PrintTimes(const Source* source, swWorld* world, swSceneSea* sea, const Asked* asked, TimeRange times)
{
    PrintHeading(asked);
    BeginProgress("times", times.count);
    bool isFine = true;
    for (int i = 0; i < times.count && isFine && !ferror(stdout); ++i)
    {
        double time = StepDecimal(times.begin, times.step, i);
        swWorld_SetTime(world, time);
        swResult result = swSceneSea_Advance(sea, time);
        result = result == SW_SUCCESS ? swWorld_Step(world, 0.0) : result;
        if (result != SW_SUCCESS)
        {
            EndProgress();
            ComplainAboutResult(result, "the sea could not be stepped");
            return EXIT_PROBLEM;
        }
        isFine = PrintAnswers(source, asked);
        UpdateProgress(i + 1);
    }
    EndProgress();
    return isFine && FinishOutput() ? EXIT_FINE : EXIT_PROBLEM;
}

// `device` NULL: the core answers.
static int AnswerTimes(swWorld* world, swSceneSea* sea, const DeviceName* device, const Asked* asked, TimeRange times)
{
    Source source = {.world = world};
    if (device != NULL)
    {
        swGpuQueryDef gpuDef = MakeGpuDef(asked);
        source.gpu = OpenGpuAnswers(device, world, &gpuDef);
        if (source.gpu == NULL)
        {
            return EXIT_PROBLEM;
        }
    }
    int exitCode = PrintTimes(&source, world, sea, asked, times);
    CloseGpuAnswers(source.gpu);
    return exitCode;
}

static const char queryText[] =
    "Ask for the surface above points, the water below it, what rays meet, or a grid of heights. Points come\n"
    "as CSV lines x,z or x,y,z in metres (x east, z south, y up and used by --below only), with or without a\n"
    "header line. The answers go to standard output:\n"
    "  t_s,x_m,z_m,height_m,dx_m,dy_m,dz_m,nx,ny,nz,jacobian,residual_m\n"
    "height above sea level's datum, displacement of the particle there, normal, Jacobian (1 flat, below\n"
    "0 folded over), and how far the answering particle is from the point asked for. The GPU gives the\n"
    "same answers to 0.1 mm, plus what the residuals allow.\n"
    "--motion appends vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2. --below answers with\n"
    "  t_s,x_m,y_m,z_m,depth_m,vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2,pressure_head_m\n"
    "depth below the surface, motion of the water, and dynamic pressure in metres of water; --drift appends\n"
    "drift_x_mps,drift_z_mps. --particles answers for the particles that rest at the points.\n"
    "--rays reads lines x,y,z,dx,dy,dz or x,y,z,dx,dy,dz,radius: where a ray begins, its direction (of any\n"
    "length but 0) and, for a sphere that sweeps along it, a radius up to 100 m. It answers with\n"
    "  t_s,x_m,y_m,z_m,dx,dy,dz,radius_m,hit,distance_m,position_x_m,position_y_m,position_z_m,\n"
    "  point_x_m,point_y_m,point_z_m,nx,ny,nz,from_below\n"
    "on one line: hit 1 or 0, distance along the ray, position of the sphere's centre then, point of the\n"
    "water that it touches, normal there, and 1 if it came out of the water. Without a hit the distance is\n"
    "how far was looked, and the fields after it are empty. --map answers with t_s,x_m,z_m,height_m.\n"
    "--fields takes a list of depth, floor, level, flow, clip, body, wind, foam, albedo, shadow and\n"
    "displacement, with commas between, and answers with t_s,x_m,z_m and the columns of each. They are\n"
    "functions of the place: no wave is looked for. Depth is that of still water, inf without a floor.";

static ParseResult ParseQuery(int argumentCount, char** arguments, QueryArguments* given)
{
    static const char* const backends[] = {"cpu", "gpu", NULL};
    static const char* const stretchings[] = {"wheeler", "linear", NULL};
    static const char* const ofParticles[] = {"particles", NULL};
    const Option options[] = {
        {.name = "points",
         .kind = OPTION_TEXT,
         .value = &given->pointsPath,
         .placeholder = "FILE",
         .help = "CSV of points or rays, - for standard input (default)"},
        {.name = "time",
         .kind = OPTION_TEXT,
         .value = &given->timeText,
         .placeholder = "T",
         .help = "seconds up to 2.7e11, or A:B:STEP for many times (default: the scene's time)"},
        {.name = "min-wavelength",
         .kind = OPTION_NUMBER,
         .value = &given->minWavelength,
         .placeholder = "L",
         .help = "leave out octaves of shorter waves, m (default 0)",
         .max = 1e4},
        {.name = "tolerance",
         .kind = OPTION_NUMBER,
         .value = &given->tolerance,
         .placeholder = "M",
         .help = "largest horizontal error of the search, m (default 0.0005)",
         .min = 1e-5,
         .max = 10.0,
         .without = ofParticles},
        {.name = "motion",
         .kind = OPTION_FLAG,
         .value = &given->withMotion,
         .help = "also velocity and acceleration of the particle there"},
        {.name = "below",
         .kind = OPTION_FLAG,
         .value = &given->isBelow,
         .help = "the water at the points' own heights y instead of the surface above them"},
        {.name = "drift",
         .kind = OPTION_FLAG,
         .value = &given->withDrift,
         .help = "of --below: also Stokes drift at the points' heights, summed wave by wave"},
        {.name = "particles",
         .kind = OPTION_FLAG,
         .value = &given->ofParticles,
         .help = "the particles that rest at the points, as a moored buoy feels them; no search, CPU only"},
        {.name = "rays",
         .kind = OPTION_FLAG,
         .value = &given->isRays,
         .help = "what rays or swept spheres meet; the CSV holds rays"},
        {.name = "max-distance",
         .kind = OPTION_NUMBER,
         .value = &given->maxDistance,
         .placeholder = "M",
         .help = "of --rays: how far they go, m (default 1000)",
         .max = 1e5},
        {.name = "map",
         .kind = OPTION_TEXT,
         .value = &given->mapText,
         .placeholder = "X0,Z0,X1,Z1,STEP",
         .help = "heights on a grid from one corner to the other, STEP m apart; reads no CSV, CPU only"},
        {.name = "fields",
         .kind = OPTION_TEXT,
         .value = &given->fieldsText,
         .placeholder = "LIST",
         .help = "what inputs say at the points, such as depth,level,flow; CPU only"},
        {.name = "stretching",
         .kind = OPTION_CHOICE,
         .value = &given->stretching,
         .placeholder = "wheeler",
         .help = "of --below: how linear theory meets the surface, wheeler or linear (default wheeler)",
         .choices = stretchings,
         .needs = "below"},
        {.name = "backend",
         .kind = OPTION_CHOICE,
         .value = &given->backend,
         .placeholder = "cpu",
         .help = "who answers: cpu, or gpu for many points (default cpu)",
         .choices = backends},
        {.name = "device",
         .kind = OPTION_DEVICE,
         .value = &given->device,
         .placeholder = "D",
         .help = "of --backend gpu: auto, gpu, software, or a number of `seaway devices`",
         .needs = "backend"},
    };
    const Verb verb = {.name = "query",
                       .synopsis = "SCENE [--points FILE | --map X0,Z0,X1,Z1,STEP] [--time T|A:B:STEP] [options]",
                       .text = queryText,
                       .options = options,
                       .optionCount = sizeof(options) / sizeof(options[0]),
                       .positionalMin = 1,
                       .positionalMax = 1,
                       .positionalName = "a scene file",
                       .positionals = &given->scenePath};
    return ParseArguments(&verb, argumentCount, arguments);
}

// What does not go together.
static const char* FindConflict(const QueryArguments* given)
{
    bool isMap = given->mapText != NULL;
    if (given->fieldsText != NULL &&
        (isMap || given->withMotion || given->isBelow || given->isRays || given->ofParticles))
    {
        return "--fields is a question of its own; leave out --map, --motion, --below, --rays and --particles";
    }
    if (given->fieldsText != NULL && given->backend == 1)
    {
        return "--fields are answered by the CPU only; leave out --backend gpu";
    }
    if (isMap && (given->withMotion || given->isBelow || given->isRays))
    {
        return "--map has heights only; leave out --motion, --below and --rays";
    }
    if (isMap && given->pointsPath != NULL)
    {
        return "--map makes its own points; leave out --points";
    }
    if (isMap && given->backend == 1)
    {
        return "--map is answered by the CPU only; leave out --backend gpu";
    }
    if (given->isRays && (given->withMotion || given->isBelow))
    {
        return "--rays is a question of its own; leave out --motion and --below";
    }
    if (given->withMotion && given->isBelow)
    {
        return "--below has the motion already; leave out --motion";
    }
    if (given->withDrift && !given->isBelow)
    {
        return "--drift is of the water at a depth; it wants --below";
    }
    if (given->ofParticles && (isMap || given->isRays || given->isBelow))
    {
        return "--particles are those of the surface; leave out --map, --rays and --below";
    }
    if (given->ofParticles && given->backend == 1)
    {
        return "--particles are answered by the CPU only; leave out --backend gpu";
    }
    if (given->maxDistance >= 0.0 && !given->isRays)
    {
        return "--max-distance is how far rays go; it wants --rays";
    }
    return NULL;
}

static Question GetQuestion(const QueryArguments* given)
{
    return given->mapText != NULL      ? QUESTION_MAP
           : given->fieldsText != NULL ? QUESTION_FIELDS
           : given->isRays             ? QUESTION_RAYS
           : given->isBelow            ? QUESTION_BELOW
           : given->withMotion         ? QUESTION_MOTION
                                       : QUESTION_SURFACE;
}

static bool ReadQuestionNumbers(const QueryArguments* given, Asked* asked)
{
    const char* path = given->pointsPath != NULL ? given->pointsPath : "-";
    if (!ReadCsvNumbers(path, GetQuestionFormat(asked->question), &asked->numbers))
    {
        return false;
    }
    if (asked->question == QUESTION_BELOW && !asked->numbers.hasOptional)
    {
        Complain("query: --below needs points x,y,z; y is the height above the scene's datum, m");
        return false;
    }
    return given->backend == 0 || AreWithinGpuReach(asked);
}

// `times` NULL: the scene's time.
static int AnswerScene(const swHost* host, swScene* scene, const QueryArguments* given, const Asked* asked,
                       const TimeRange* times)
{
    const DeviceName* device = given->backend == 1 ? &given->device : NULL;
    const TimeRange own = {scene->time, 1.0, 1};
    swWorld* world = NULL;
    swSceneSea sea = {0};
    scene->world.enableQueries = device == NULL;
    scene->world.enableVelocity = scene->world.enableAcceleration =
        device == NULL && asked->question == QUESTION_MOTION;
    int exitCode = EXIT_PROBLEM;
    swResult result = swOpenScene(host, scene, &world, &sea);
    if (result == SW_SUCCESS)
    {
        exitCode = AnswerTimes(world, &sea, device, asked, times != NULL ? *times : own);
    }
    else
    {
        ComplainAboutResult(result, given->scenePath);
    }
    swDestroySceneSea(&sea);
    swDestroyWorld(world);
    return exitCode;
}

// The scene comes first: nobody types points for one that is not there.
static int QueryScene(const QueryArguments* given, Asked* asked, const TimeRange* times)
{
    swHost host = MakeHost();
    swTaskPool* pool = AttachThreads(&host, 0);
    swScene* scene = NULL;
    int exitCode = EXIT_PROBLEM;
    swResult result = swReadScene(&host, given->scenePath, &scene);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, given->scenePath);
    }
    else if (asked->question == QUESTION_MAP || ReadQuestionNumbers(given, asked))
    {
        exitCode = AnswerScene(&host, scene, given, asked, times);
    }
    swDestroyScene(scene);
    swDestroyTaskPool(pool);
    return exitCode;
}

int RunQuery(int argumentCount, char** arguments)
{
    QueryArguments given = {.tolerance = 0.0005, .maxDistance = -1.0, .device = {.choice = SW_DEVICE_AUTO}};
    ParseResult parsed = ParseQuery(argumentCount, arguments, &given);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    const char* conflict = FindConflict(&given);
    if (conflict != NULL)
    {
        Complain("query: %s", conflict);
        return EXIT_USAGE;
    }
    Asked asked = {.question = GetQuestion(&given), .def = swDefaultQueryDef()};
    asked.maxDistance = given.maxDistance >= 0.0 ? (float)given.maxDistance : 1000.0f;
    asked.ofParticles = given.ofParticles;
    asked.withDrift = given.withDrift;
    asked.def.minWavelength = (float)given.minWavelength;
    asked.def.tolerance = (float)given.tolerance;
    asked.def.stretching = (swStretching)given.stretching;
    TimeRange times;
    if ((given.timeText != NULL && !ParseTimes(given.timeText, &times)) ||
        (given.mapText != NULL && !ParseMap(given.mapText, &asked.map)) ||
        (given.fieldsText != NULL && !ParseFieldList(given.fieldsText, &asked.fields)))
    {
        return EXIT_USAGE;
    }
    int exitCode = QueryScene(&given, &asked, given.timeText != NULL ? &times : NULL);
    FreeCsvNumbers(&asked.numbers);
    return exitCode;
}
