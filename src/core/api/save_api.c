// SPDX-License-Identifier: MIT
// The bytes of a saved world: a mark, a version, the state, and a hash over all of it.

#include <string.h>

#include "core/base/hash.h"
#include "core/base/misuse.h"
#include "core/world/world.h"
#include "seaway/save.h"

#define SAVE_MARK 0x5741534159415753u // "SWAYASAW"
#define SAVE_VERSION 10u
#define HASH_SIZE 8

static uint64_t hashBytes(const uint8_t* data, size_t size)
{
    swHash hash = swBeginHash();
    for (size_t i = 0; i < size; i += 8)
    {
        uint64_t word = 0;
        for (size_t k = 0; k < 8 && i + k < size; ++k)
        {
            word |= (uint64_t)data[i + k] << (8 * k);
        }
        swAddHash(&hash, word);
    }
    swAddHash(&hash, size);
    return swEndHash(&hash);
}

static void streamHead(swStream* stream, uint64_t* mark, uint32_t* version, swWorldDef* def)
{
    swStreamU64(stream, mark);
    swStreamU32(stream, version);
    swStreamDef(stream, &swWorldFields, def);
}

// Writing reads the world only; streams are one for both ways.
static swResult writeWorld(swWorld* world, swStream* stream)
{
    uint64_t mark = SAVE_MARK;
    uint32_t version = SAVE_VERSION;
    swWorldDef def = world->def;
    streamHead(stream, &mark, &version, &def);
    swResult result = swStreamState(world, stream, NULL);
    if (result != SW_SUCCESS || stream->isBroken)
    {
        return swFail(&world->host, SW_ERROR_LIMIT,
                      "the world cannot be saved: after %zu bytes comes a number that a saved world cannot hold",
                      stream->at);
    }
    return SW_SUCCESS;
}

swResult swWorld_Save(const swWorld* world, void* data, size_t* size)
{
    SW_REQUIRE(world != NULL && size != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swWorld_Save() needs a world and a place for the size");
    swStream stream = {.purpose = SW_STREAM_COUNT};
    size_t room = *size;
    *size = 0;
    swResult result = writeWorld((swWorld*)world, &stream);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    *size = stream.at + HASH_SIZE;
    if (data == NULL)
    {
        return SW_SUCCESS;
    }
    if (room < *size)
    {
        return swFail(&world->host, SW_ERROR_LIMIT, "saving the world takes %zu bytes; there is room for %zu", *size,
                      room);
    }
    stream = (swStream){.purpose = SW_STREAM_WRITE, .data = data, .size = *size};
    result = writeWorld((swWorld*)world, &stream);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    uint64_t hash = hashBytes(data, stream.at);
    swStreamU64(&stream, &hash);
    return SW_SUCCESS;
}

static swResult failFormat(const swHost* host, const char* what)
{
    return swFail(host, SW_ERROR_FORMAT, "the bytes of a saved world %s", what);
}

static swResult checkBytes(const swHost* host, const uint8_t* data, size_t size)
{
    if (size < HASH_SIZE + 12)
    {
        return failFormat(host, "are too few to be one");
    }
    swStream stream = {.purpose = SW_STREAM_READ, .data = (uint8_t*)data, .size = size};
    uint64_t mark, hash;
    uint32_t version;
    swStreamU64(&stream, &mark);
    swStreamU32(&stream, &version);
    if (mark != SAVE_MARK)
    {
        return failFormat(host, "do not begin as one does");
    }
    if (version != SAVE_VERSION)
    {
        return swFail(host, SW_ERROR_FORMAT, "a saved world is of version %u; this library reads version %u", version,
                      SAVE_VERSION);
    }
    stream.at = size - HASH_SIZE;
    swStreamU64(&stream, &hash);
    return hash == hashBytes(data, size - HASH_SIZE) ? SW_SUCCESS : failFormat(host, "are damaged");
}

#define SW_DEF swRestoreDef
static const swField restoreFields[] = {
    SW_CHOICE(isa, swIsaWords, swIsaWords, SW_ISA_BEST, .key = NULL, .label = "instruction set", .use = SW_USE_HERE),
    SW_BYTES(memoryBudget, SW_WITHIN(1.0, (double)SIZE_MAX), 1073741824.0, .key = NULL, .label = "most memory",
             .use = SW_USE_HERE),
    SW_GIVEN(findResource, .key = NULL, .label = "finds resources"),
    SW_GIVEN(resourceContext, .key = NULL, .label = "its context"),
};
#undef SW_DEF

static const swFields restoreDefFields = SW_FIELDS(swRestoreDef, NULL, "restoring", restoreFields, -1);

const swFields* swGetRestoreFields(void)
{
    return &restoreDefFields;
}

swRestoreDef swDefaultRestoreDef(void)
{
    swRestoreDef def;
    swFillDef(&restoreDefFields, &def);
    return def;
}

// Everything after the head into a world that has its def. All that is made counts against the budget.
static swResult readState(swWorld* world, swStream* stream, const swRestoreDef* def)
{
    size_t memoryBudget = def->memoryBudget;
    world->memory.budget = memoryBudget;
    swResult result = SW_SUCCESS;
    if (world->memory.held > memoryBudget)
    {
        world->memory.isOverBudget = true;
        result = swFailMemory(&world->memory, "the world itself");
    }
    result = result == SW_SUCCESS ? swStreamState(world, stream, def) : result;
    world->memory.budget = 0;
    if (result == SW_SUCCESS && stream->at != stream->size)
    {
        result = SW_ERROR_FORMAT;
    }
    return result == SW_ERROR_FORMAT ? failFormat(&world->host, "hold a state that cannot be") : result;
}

swResult swRestoreWorld(const swHost* host, const void* data, size_t size, const swRestoreDef* restoreDef,
                        swWorld** worldOut)
{
    if (worldOut != NULL)
    {
        *worldOut = NULL;
    }
    SW_REQUIRE(swIsHostValid(host), SW_ERROR_INVALID, host, "swRestoreWorld() needs a host made by swDefaultHost()");
    SW_REQUIRE(data != NULL && worldOut != NULL, SW_ERROR_INVALID, host,
               "swRestoreWorld() needs the bytes of a saved world and a place for the world");
    SW_REQUIRE(restoreDef != NULL, SW_ERROR_INVALID, host, "swRestoreWorld() needs a def");
    swResult result = swCheckDef(host, &restoreDefFields, restoreDef);
    result = result == SW_SUCCESS ? checkBytes(host, data, size) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swStream stream = {.purpose = SW_STREAM_READ, .data = (uint8_t*)data, .size = size - HASH_SIZE};
    uint64_t mark;
    uint32_t version;
    swWorldDef def = swDefaultWorldDef();
    streamHead(&stream, &mark, &version, &def);
    def.isa = restoreDef->isa;
    if (stream.isBroken || swCheckDef(host, &swWorldFields, &def) != SW_SUCCESS)
    {
        return failFormat(host, "hold a world that cannot be");
    }
    swWorld* world = NULL;
    result = swCreateWorld(host, &def, &world);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    result = readState(world, &stream, restoreDef);
    if (result != SW_SUCCESS)
    {
        swDestroyWorld(world);
        return result;
    }
    *worldOut = world;
    return SW_SUCCESS;
}

// A world can go back to another foam and wind, but to nothing else of another def.
static bool isSameWorld(const swWorldDef* a, const swWorldDef* b)
{
    swWorldDef other = *b;
    other.foam = a->foam;
    other.wind = a->wind;
    return swIsSameDef(&swWorldFields, a, &other);
}

swResult swWorld_Rewind(swWorld* world, const void* data, size_t size)
{
    SW_REQUIRE(world != NULL && data != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swWorld_Rewind() needs a world and the bytes of a saved one");
    swResult result = checkBytes(&world->host, data, size);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swStream stream = {.purpose = SW_STREAM_READ, .data = (uint8_t*)data, .size = size - HASH_SIZE};
    uint64_t mark;
    uint32_t version;
    swWorldDef def = world->def;
    streamHead(&stream, &mark, &version, &def);
    if (stream.isBroken || swCheckDef(&world->host, &swWorldFields, &def) != SW_SUCCESS)
    {
        return failFormat(&world->host, "hold a world that cannot be");
    }
    if (!isSameWorld(&def, &world->def))
    {
        return swFail(&world->host, SW_ERROR_UNSUPPORTED,
                      "the world cannot go back to a saved state: that is of a world with another def");
    }
    const swFoamDef foam = world->def.foam;
    const swWindDef wind = world->def.wind;
    world->def.foam = world->frame.foam = def.foam;
    world->def.wind = def.wind;
    result = swRewindState(world, &stream);
    if (result != SW_SUCCESS)
    {
        world->def.foam = world->frame.foam = foam;
        world->def.wind = wind;
    }
    return result == SW_ERROR_FORMAT ? failFormat(&world->host, "hold a state that cannot be") : result;
}

int swWorld_GetViewCount(const swWorld* world)
{
    SW_REQUIRE(world != NULL, 0, NULL, "swWorld_GetViewCount() needs a world");
    return world->viewCount;
}

swView* swWorld_GetView(swWorld* world, int index)
{
    SW_REQUIRE(world != NULL && index >= 0 && index < world->viewCount, NULL, swFindHost(world),
               "swWorld_GetView() was asked for the view %d, which the world does not have", index);
    return world->views[index];
}
