// SPDX-License-Identifier: MIT
#include "scene/scene_stale.h"

#include "files/file_text.h"
#include "scene/scene_lists.h"
#include "scene/scene_source.h"
#include "seaway/files.h"

static void keepQuiet(void* context, swLogLevel level, const char* message)
{
    (void)context;
    (void)level;
    (void)message;
}

// The hash of what would be baked now on the file's lattice; 0 if that cannot be told.
static uint64_t hashFloor(const swHost* host, const char* path, const swRasterSource* source)
{
    swScene* scene = NULL;
    swWorld* world = NULL;
    uint64_t hash = 0;
    swResult result = swReadScene(host, path, &scene);
    result = result == SW_SUCCESS ? swCreateSceneWorld(host, scene, &world) : result;
    if (result == SW_SUCCESS)
    {
        swRasterDef def = swDefaultRasterDef();
        def.width = source->width;
        def.height = source->height;
        def.x = source->x;
        def.z = source->z;
        def.spacingX = source->spacingX;
        def.spacingZ = source->spacingZ;
        hash = swWorld_HashFloor(world, &def);
    }
    swDestroyWorld(world);
    swDestroyScene(scene);
    return hash;
}

bool swIsSceneRasterStale(const swScene* scene, int index)
{
    const swSceneRaster* raster = &scene->rasters[index];
    swHost host = scene->host;
    host.log = keepQuiet; // that it is stale is all that is told
    char file[SW_MAX_PATH], madeFrom[SW_MAX_PATH];
    swJoinScenePath(scene->source->folder, raster->file, file);
    swJoinScenePath(scene->source->folder, raster->madeFrom, madeFrom);
    swRasterSource source;
    if (swReadRasterSource(&host, file, &source) != SW_SUCCESS)
    {
        return true;
    }
    uint64_t hash = hashFloor(&host, madeFrom, &source);
    return hash == 0 || hash != source.hash;
}
