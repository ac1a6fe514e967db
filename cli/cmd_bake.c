// SPDX-License-Identifier: MIT
// `seaway bake depth`: the floor of a scene on a lattice, kept with a hash of what it was made from.

#include <string.h>

#include "args.h"
#include "seaway/files.h"
#include "verbs.h"

typedef struct Bake
{
    const char *what, *scenePath, *outPath;
    double x, z, width, height, spacing;
    bool onlyStale, isCheck;
} Bake;

static swRasterDef MakeLattice(const Bake* bake)
{
    swRasterDef def = swDefaultRasterDef();
    def.name = bake->outPath;
    def.spacingX = def.spacingZ = bake->spacing;
    def.width = (int)(bake->width / bake->spacing) + 1;
    def.height = (int)(bake->height / bake->spacing) + 1;
    def.x = bake->x - 0.5 * bake->spacing * (def.width - 1);
    def.z = bake->z - 0.5 * bake->spacing * (def.height - 1);
    return def;
}

static bool FitsLattice(const Bake* bake)
{
    double across = bake->width / bake->spacing + 1.0, down = bake->height / bake->spacing + 1.0;
    bool fits = across < SW_MAX_RASTER_SIDE + 1.0 && down < SW_MAX_RASTER_SIDE + 1.0;
    if (!fits)
    {
        Complain("bake: %g x %g m with cells of %g m would be %.0f x %.0f cells; at most %d a side are made, so raise "
                 "--spacing",
                 bake->width, bake->height, bake->spacing, across, down, SW_MAX_RASTER_SIDE);
    }
    return fits;
}

static void Silence(void* context, swLogLevel level, const char* message)
{
    (void)context;
    (void)level;
    (void)message;
}

// Whether the file holds what would be baked now. A file that cannot be read holds nothing.
static bool IsFresh(const Bake* bake, uint64_t hash)
{
    swHost host = swDefaultHost();
    host.log = Silence;
    swRasterSource source;
    return swReadRasterSource(&host, bake->outPath, &source) == SW_SUCCESS && source.hash == hash;
}

static int Write(const swHost* host, const Bake* bake, const swWorld* world, const swRasterDef* def, uint64_t hash)
{
    swRaster* raster = NULL;
    char source[SW_MAX_RASTER_SOURCE];
    snprintf(source, sizeof(source), "floor of %s", bake->scenePath);
    swResult result = swBakeFloor(world, def, &raster);
    if (result == SW_SUCCESS && swRaster_GetInfo(raster).unknownCount == (size_t)def->width * (size_t)def->height)
    {
        Complain("bake: %s has no sea floor around %g, %g; choose another --x, --z, --width and --height",
                 bake->scenePath, bake->x, bake->z);
        swDestroyRaster(raster);
        return EXIT_PROBLEM;
    }
    result = result != SW_SUCCESS ? result : swWriteRaster(host, bake->outPath, raster, source, hash);
    swDestroyRaster(raster);
    return result == SW_SUCCESS ? EXIT_FINE : EXIT_PROBLEM;
}

static int BakeScene(const Bake* bake)
{
    swHost host = MakeHost();
    swScene* scene = NULL;
    swWorld* world = NULL;
    swResult result = swReadScene(&host, bake->scenePath, &scene);
    result = result != SW_SUCCESS ? result : swCreateSceneWorld(&host, scene, &world);
    int code = EXIT_PROBLEM;
    if (result == SW_SUCCESS)
    {
        swRasterDef def = MakeLattice(bake);
        uint64_t hash = swWorld_HashFloor(world, &def);
        bool isFresh = (bake->isCheck || bake->onlyStale) && IsFresh(bake, hash);
        if (bake->isCheck)
        {
            printf("%s is %s\n", bake->outPath, isFresh ? "up to date" : "stale");
        }
        code = isFresh ? EXIT_FINE : bake->isCheck ? EXIT_PROBLEM : Write(&host, bake, world, &def, hash);
    }
    swDestroyWorld(world);
    swDestroyScene(scene);
    return code;
}

int RunBake(int argumentCount, char** arguments)
{
    static const char* const endings[] = {".exr", NULL};
    Bake bake = {.width = 4096.0, .height = 4096.0, .spacing = 8.0};
    const char* positionals[2] = {NULL, NULL};
    const Option options[] = {
        {.name = "out",
         .kind = OPTION_OUTPUT,
         .value = &bake.outPath,
         .placeholder = "FILE",
         .choices = endings,
         .help = "the EXR image to write"},
        {.name = "x",
         .kind = OPTION_NUMBER,
         .value = &bake.x,
         .placeholder = "M",
         .min = -1e8,
         .max = 1e8,
         .help = "middle of the area, m (default 0)"},
        {.name = "z",
         .kind = OPTION_NUMBER,
         .value = &bake.z,
         .placeholder = "M",
         .min = -1e8,
         .max = 1e8,
         .help = "likewise"},
        {.name = "width",
         .kind = OPTION_NUMBER,
         .value = &bake.width,
         .placeholder = "M",
         .min = 1.0,
         .max = 1e6,
         .help = "of the area along x, m (default 4096)"},
        {.name = "height",
         .kind = OPTION_NUMBER,
         .value = &bake.height,
         .placeholder = "M",
         .min = 1.0,
         .max = 1e6,
         .help = "along z, m (default 4096)"},
        {.name = "spacing",
         .kind = OPTION_NUMBER,
         .value = &bake.spacing,
         .placeholder = "M",
         .min = 0.01,
         .max = 1e5,
         .help = "from cell to cell, m (default 8)"},
        {.name = "if-stale",
         .kind = OPTION_FLAG,
         .value = &bake.onlyStale,
         .help = "write only if the file does not hold that already"},
        {.name = "check",
         .kind = OPTION_FLAG,
         .value = &bake.isCheck,
         .help = "write nothing; exit code 1 if the file is stale or missing"},
    };
    const Verb verb = {
        .name = "bake",
        .synopsis = "depth SCENE --out FILE [options]",
        .text = "Capture the sea floor of a scene, all its rasters, meshes and shapes together, on a lattice,\n"
                "and write it as an EXR image of 32-bit floats. Its header says where it lies and holds a hash\n"
                "of what it was made from, so that a file that is out of date is found. Scenes read it as they\n"
                "read any raster.",
        .options = options,
        .optionCount = (int)(sizeof(options) / sizeof(options[0])),
        .positionalMin = 2,
        .positionalMax = 2,
        .positionalName = "'depth' and a scene file",
        .positionals = positionals};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    bake.what = positionals[0];
    bake.scenePath = positionals[1];
    if (strcmp(bake.what, "depth") != 0)
    {
        Complain("bake: '%s' cannot be baked; only depth can", bake.what);
        return EXIT_USAGE;
    }
    if (bake.outPath == NULL)
    {
        Complain("bake: --out names the file to write");
        return EXIT_USAGE;
    }
    return FitsLattice(&bake) ? BakeScene(&bake) : EXIT_USAGE;
}
