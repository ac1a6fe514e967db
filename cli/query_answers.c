// SPDX-License-Identifier: MIT
#include "query_answers.h"

#include <math.h>
#include <stdlib.h>

#include "decimal.h"
#include "common.h"

#define BLOCK 65536    // points asked at once
#define GPU_REACH 5e10 // no two points are farther apart than swGpuQuery_SetPoints() allows

enum
{
    POINT_X,
    POINT_Y,
    POINT_Z
};

static const CsvColumn pointColumns[] = {
    [POINT_X] = {"x", "x_m", -FARTHEST_POINT, FARTHEST_POINT, false},
    [POINT_Y] = {"y", "y_m", -FARTHEST_POINT, FARTHEST_POINT, true},
    [POINT_Z] = {"z", "z_m", -FARTHEST_POINT, FARTHEST_POINT, false},
};

enum
{
    RAY_X,
    RAY_Y,
    RAY_Z,
    RAY_DX,
    RAY_DY,
    RAY_DZ,
    RAY_RADIUS
};

static const CsvColumn rayColumns[] = {
    [RAY_X] = {"x", "x_m", -FARTHEST_POINT, FARTHEST_POINT, false},
    [RAY_Y] = {"y", "y_m", -FARTHEST_POINT, FARTHEST_POINT, false},
    [RAY_Z] = {"z", "z_m", -FARTHEST_POINT, FARTHEST_POINT, false},
    [RAY_DX] = {.name = "dx"},
    [RAY_DY] = {.name = "dy"},
    [RAY_DZ] = {.name = "dz"},
    [RAY_RADIUS] = {"radius", "radius_m", 0.0, 100.0, true},
};

static const char* CheckRay(const double* row)
{
    bool isZero = row[RAY_DX] == 0.0 && row[RAY_DY] == 0.0 && row[RAY_DZ] == 0.0;
    return isZero ? "the direction dx,dy,dz is 0; a ray needs one, of any length" : NULL;
}

static const CsvFormat pointFormat = {"points", pointColumns, sizeof(pointColumns) / sizeof(pointColumns[0]), NULL};
static const CsvFormat rayFormat = {"rays", rayColumns, sizeof(rayColumns) / sizeof(rayColumns[0]), CheckRay};

const CsvFormat* GetQuestionFormat(Question question)
{
    return question == QUESTION_RAYS ? &rayFormat : &pointFormat;
}

bool AreWithinGpuReach(const Asked* asked)
{
    // x and z are the same columns of both formats.
    _Static_assert((int)POINT_X == (int)RAY_X && (int)POINT_Z == (int)RAY_Z, "points and rays begin alike");
    for (int i = 0; i < asked->numbers.count; ++i)
    {
        const double* row = GetCsvRow(&asked->numbers, i);
        if (fabs(row[POINT_X]) > GPU_REACH || fabs(row[POINT_Z]) > GPU_REACH)
        {
            Complain("query: %.10g,%.10g is beyond the %.0g m that --backend gpu reaches; without it the CPU answers",
                     row[POINT_X], row[POINT_Z], GPU_REACH);
            return false;
        }
    }
    return true;
}

swGpuQueryDef MakeGpuDef(const Asked* asked)
{
    const uint32_t motion = SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION;
    static const swGpuQueryKind kinds[] = {
        [QUESTION_SURFACE] = SW_GPU_QUERY_KIND_SURFACE,
        [QUESTION_MOTION] = SW_GPU_QUERY_KIND_SURFACE,
        [QUESTION_BELOW] = SW_GPU_QUERY_KIND_VOLUME,
        [QUESTION_RAYS] = SW_GPU_QUERY_KIND_RAYS,
    };
    const uint32_t outputs[] = {
        [QUESTION_SURFACE] = SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL,
        [QUESTION_MOTION] = SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL | motion,
        [QUESTION_BELOW] = motion,
        [QUESTION_RAYS] = SW_GPU_QUERY_NORMAL,
    };
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.kind = kinds[asked->question];
    def.outputs = outputs[asked->question];
    def.capacity = asked->numbers.count < BLOCK ? asked->numbers.count : BLOCK;
    def.minWavelength = asked->def.minWavelength;
    def.tolerance = asked->def.tolerance;
    def.maxIterations = asked->def.maxIterations;
    def.stretching = asked->def.stretching;
    return def;
}

void PrintHeading(const Asked* asked)
{
    static const char* const headings[] = {
        [QUESTION_SURFACE] = "t_s,x_m,z_m,height_m,dx_m,dy_m,dz_m,nx,ny,nz,jacobian,residual_m",
        [QUESTION_MOTION] = "t_s,x_m,z_m,height_m,dx_m,dy_m,dz_m,nx,ny,nz,jacobian,residual_m,vx_mps,vy_mps,vz_mps,"
                            "ax_mps2,ay_mps2,az_mps2",
        [QUESTION_BELOW] = "t_s,x_m,y_m,z_m,depth_m,vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2,pressure_head_m",
        [QUESTION_RAYS] = "t_s,x_m,y_m,z_m,dx,dy,dz,radius_m,hit,distance_m,position_x_m,position_y_m,position_z_m,"
                          "point_x_m,point_y_m,point_z_m,nx,ny,nz,from_below",
        [QUESTION_FIELDS] = "t_s,x_m,z_m",
        [QUESTION_MAP] = "t_s,x_m,z_m,height_m",
    };
    printf("%s%s", headings[asked->question], asked->withDrift ? ",drift_x_mps,drift_z_mps" : "");
    PrintFieldColumns(&asked->fields);
    putchar('\n');
}

// What was asked, as it was asked.
static void PrintExact(double value)
{
    char text[DECIMAL_SIZE];
    fputs(FormatExact(text, value), stdout);
}

static void PrintVector(swVec3 v)
{
    printf(",%.6g,%.6g,%.6g", (double)v.x, (double)v.y, (double)v.z);
}

static void PrintPlace(swPos place)
{
    printf(",%.10g,%.10g,%.10g", place.x, place.y, place.z);
}

static void PrintAsked(double time, const double* values, int count)
{
    PrintExact(time);
    for (int i = 0; i < count; ++i)
    {
        putchar(',');
        PrintExact(values[i]);
    }
}

// The surface, a block of points at once.
static bool PrintSurface(const Source* source, const Asked* asked, int begin, int count)
{
    static swPosXZ points[BLOCK];
    static float height[BLOCK], jacobian[BLOCK], residual[BLOCK];
    static swVec3 displacement[BLOCK], normal[BLOCK], velocity[BLOCK], acceleration[BLOCK];
    swSurfaceSamples samples = {
        .height = height, .displacement = displacement, .normal = normal, .jacobian = jacobian, .residual = residual};
    bool withMotion = asked->question == QUESTION_MOTION;
    samples.velocity = withMotion ? velocity : NULL;
    samples.acceleration = withMotion ? acceleration : NULL;
    for (int i = 0; i < count; ++i)
    {
        const double* row = GetCsvRow(&asked->numbers, begin + i);
        points[i] = (swPosXZ){row[POINT_X], row[POINT_Z]};
    }
    if (asked->ofParticles)
    {
        swMoment_QueryParticles(swWorld_GetMoment(source->world), &asked->def, count, points, &samples, NULL, NULL);
    }
    else if (source->gpu == NULL)
    {
        swMoment_QuerySurface(swWorld_GetMoment(source->world), &asked->def, count, points, &samples, NULL);
    }
    else if (!AskGpu(source->gpu, count, points, &samples))
    {
        return false;
    }
    double time = swWorld_GetTime(source->world);
    for (int i = 0; i < count; ++i)
    {
        PrintAsked(time, (const double[]){points[i].x, points[i].z}, 2);
        printf(",%.7g", (double)height[i]);
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
    return true;
}

static void PrintDrift(const swWorld* world, double y)
{
    swVec2 drift = swMoment_GetStokesDrift(swWorld_GetMoment(world), fmax(swWorld_GetSeaLevel(world) - y, 0.0));
    printf(",%.6g,%.6g", (double)drift.x, (double)drift.y);
}

// The water at the points' own heights.
static bool PrintBelow(const Source* source, const Asked* asked, int begin, int count)
{
    static swPos places[BLOCK];
    static float depth[BLOCK], head[BLOCK];
    static swVec3 velocity[BLOCK], acceleration[BLOCK];
    const swVolumeSamples samples = {
        .depth = depth, .velocity = velocity, .acceleration = acceleration, .pressureHead = head};
    for (int i = 0; i < count; ++i)
    {
        const double* row = GetCsvRow(&asked->numbers, begin + i);
        places[i] = (swPos){row[POINT_X], row[POINT_Y], row[POINT_Z]};
    }
    if (source->gpu == NULL)
    {
        swMoment_QueryVolume(swWorld_GetMoment(source->world), &asked->def, count, places, &samples, NULL);
    }
    else if (!AskGpuBelow(source->gpu, count, places, &samples))
    {
        return false;
    }
    double time = swWorld_GetTime(source->world);
    for (int i = 0; i < count; ++i)
    {
        PrintAsked(time, (const double[]){places[i].x, places[i].y, places[i].z}, 3);
        printf(",%.6g", (double)depth[i]);
        PrintVector(velocity[i]);
        PrintVector(acceleration[i]);
        printf(",%.6g", (double)head[i]);
        if (asked->withDrift)
        {
            PrintDrift(source->world, places[i].y);
        }
        putchar('\n');
    }
    return true;
}

// The library squares directions in floats: of any length here, they are brought near one.
static swRay MakeRay(const double* row, float maxDistance)
{
    double longest = fmax(fmax(fabs(row[RAY_DX]), fabs(row[RAY_DY])), fabs(row[RAY_DZ]));
    swVec3 direction = {(float)(row[RAY_DX] / longest), (float)(row[RAY_DY] / longest), (float)(row[RAY_DZ] / longest)};
    swRay ray = swDefaultRay((swPos){row[RAY_X], row[RAY_Y], row[RAY_Z]}, direction);
    ray.maxDistance = maxDistance;
    ray.radius = (float)row[RAY_RADIUS];
    return ray;
}

// Without a hit there is nowhere to speak of: those fields stay empty.
static void PrintHit(double time, const double* row, const swRayHit* hit)
{
    PrintAsked(time, (const double[]){row[RAY_X], row[RAY_Y], row[RAY_Z]}, 3);
    printf(",%.9g,%.9g,%.9g,%.9g,%d,%.9g", row[RAY_DX], row[RAY_DY], row[RAY_DZ], row[RAY_RADIUS], hit->isHit ? 1 : 0,
           (double)hit->distance);
    if (!hit->isHit)
    {
        puts(",,,,,,,,,,");
        return;
    }
    PrintPlace(hit->position);
    PrintPlace(hit->point);
    PrintVector(hit->normal);
    printf(",%d\n", hit->fromBelow ? 1 : 0);
}

static bool PrintRays(const Source* source, const Asked* asked, int begin, int count)
{
    static swRay rays[BLOCK];
    static swRayHit hits[BLOCK];
    for (int i = 0; i < count; ++i)
    {
        rays[i] = MakeRay(GetCsvRow(&asked->numbers, begin + i), asked->maxDistance);
    }
    if (source->gpu == NULL)
    {
        swMoment_CastRays(swWorld_GetMoment(source->world), &asked->def, count, rays, hits, NULL);
    }
    else if (!AskGpuRays(source->gpu, count, rays, hits))
    {
        return false;
    }
    double time = swWorld_GetTime(source->world);
    for (int i = 0; i < count; ++i)
    {
        PrintHit(time, GetCsvRow(&asked->numbers, begin + i), hits + i);
    }
    return true;
}

static bool PrintFields(const Source* source, const Asked* asked, int begin, int count)
{
    double time = swWorld_GetTime(source->world);
    for (int first = 0; first < count; first += FIELD_BLOCK)
    {
        swPosXZ points[FIELD_BLOCK];
        int some = count - first < FIELD_BLOCK ? count - first : FIELD_BLOCK;
        for (int i = 0; i < some; ++i)
        {
            const double* row = GetCsvRow(&asked->numbers, begin + first + i);
            points[i] = (swPosXZ){row[POINT_X], row[POINT_Z]};
        }
        const FieldAnswers* answers = AskFields(source->world, some, points);
        for (int i = 0; i < some; ++i)
        {
            PrintAsked(time, (const double[]){points[i].x, points[i].z}, 2);
            PrintFieldRow(&asked->fields, answers, i);
            putchar('\n');
        }
    }
    return true;
}

static bool PrintMap(const Source* source, const Asked* asked)
{
    const swHeightMapDef* map = &asked->map;
    float* heights = malloc((size_t)map->width * (size_t)map->height * sizeof(float));
    if (heights == NULL)
    {
        Complain("query: no memory for a map of %d x %d points", map->width, map->height);
        return false;
    }
    swMoment_QueryHeightMap(swWorld_GetMoment(source->world), &asked->def, map, heights, NULL);
    double time = swWorld_GetTime(source->world);
    for (int j = 0; j < map->height; ++j)
    {
        const float* row = heights + (size_t)j * (size_t)map->width;
        for (int i = 0; i < map->width; ++i)
        {
            const double place[] = {StepDecimal(map->originX, map->spacing, i),
                                    StepDecimal(map->originZ, map->spacing, j)};
            PrintAsked(time, place, 2);
            printf(",%.7g\n", (double)row[i]);
        }
    }
    free(heights);
    return true;
}

bool PrintAnswers(const Source* source, const Asked* asked)
{
    typedef bool PrintFcn(const Source*, const Asked*, int, int);
    static PrintFcn* const printers[] = {
        [QUESTION_SURFACE] = PrintSurface, [QUESTION_MOTION] = PrintSurface, [QUESTION_BELOW] = PrintBelow,
        [QUESTION_RAYS] = PrintRays,       [QUESTION_FIELDS] = PrintFields,
    };
    if (asked->question == QUESTION_MAP)
    {
        return PrintMap(source, asked);
    }
    bool isFine = true;
    for (int begin = 0; begin < asked->numbers.count && isFine; begin += BLOCK)
    {
        int count = asked->numbers.count - begin < BLOCK ? asked->numbers.count - begin : BLOCK;
        isFine = printers[asked->question](source, asked, begin, count);
    }
    return isFine;
}
