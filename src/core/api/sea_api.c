// SPDX-License-Identifier: MIT
#include <string.h>

#include "core/base/misuse.h"
#include "core/world/world.h"
#include "seaway/sea.h"

// Bits of the golden section: multiples of an odd number are all different.
#define SEED_STEP 0x9e3779b9u

// Part of the peak's wavelength down to which a swell has waves: four times its frequency.
#define SHORTEST_PART 0.0625f

#define SW_DEF swSeaDef
static const swField seaFields[] = {
    SW_PART(windSea, &swWaveSystemFields, .key = NULL, .label = "wind sea"),
    SW_SWITCH(enableWindSea, true, .key = NULL, .label = "wind sea"),
    SW_NUMBER(swellCount, "", SW_WITHIN(0.0, SW_MAX_SWELLS), 0.0, .key = NULL, .label = "swells",
              SW_KNOB(0.0, SW_MAX_SWELLS)),
    SW_PARTS(swells, &swSpectrumFields, .key = NULL, .label = "swells"),
};
#undef SW_DEF

static const swFields seaDefFields = SW_FIELDS(swSeaDef, NULL, "sea", seaFields, -1);

const swFields* swGetSeaFields(void)
{
    return &seaDefFields;
}

swSeaDef swDefaultSeaDef(void)
{
    swSeaDef def;
    swFillDef(&seaDefFields, &def);
    def.windSea = swDefaultWaveSystemDef();
    for (int i = 0; i < SW_MAX_SWELLS; ++i)
    {
        def.swells[i] = swDefaultSpectrumDef();
    }
    return def;
}

// What a swell shares with the wind sea, and what it does not.
static swWaveSystemDef makeSwell(const swWorld* world, const swSeaDef* def, int index)
{
    swWaveSystemDef swell = def->windSea;
    swell.spectrum = def->swells[index];
    swell.takesWind = false; // a swell has left its wind behind
    swell.seed += SEED_STEP * (uint32_t)(index + 1);
    swSeaState seaState;
    if (swell.spectrum.kind != SW_SPECTRUM_TABLE &&
        swSpectrum_GetSeaState(&swell.spectrum, 0.0f, 0.0f, &seaState) == SW_SUCCESS)
    {
        float shortest = SHORTEST_PART * world->def.gravity * seaState.peakPeriod * seaState.peakPeriod / 6.2831853f;
        bool isShorter = shortest > swell.minWavelength && shortest < swell.maxWavelength;
        swell.minWavelength = isShorter ? shortest : swell.minWavelength;
    }
    return swell;
}

swResult swCreateSea(swWorld* world, const swSeaDef* def, swSea* sea)
{
    if (sea != NULL)
    {
        memset(sea, 0, sizeof(*sea));
    }
    SW_REQUIRE(world != NULL && sea != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swCreateSea() needs a world and a place for the sea's handles");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swCreateSea() needs a def made by swDefaultSeaDef()");
    swResult result = swCheckDef(&world->host, &seaDefFields, def);
    if (result == SW_SUCCESS && def->enableWindSea)
    {
        result = swCreateWaveSystem(world, &def->windSea, &sea->windSea);
    }
    for (int i = 0; i < def->swellCount && result == SW_SUCCESS; ++i)
    {
        swWaveSystemDef swell = makeSwell(world, def, i);
        result = swCreateWaveSystem(world, &swell, &sea->swells[i]);
        sea->swellCount = result == SW_SUCCESS ? i + 1 : i;
    }
    if (result != SW_SUCCESS)
    {
        swDestroySea(world, sea);
    }
    return result;
}

void swDestroySea(swWorld* world, swSea* sea)
{
    SW_REQUIRE_VOID(world != NULL && sea != NULL, swFindHost(world),
                    "swDestroySea() needs a world and the sea's handles");
    for (int i = 0; i < SW_MAX_SWELLS; ++i)
    {
        if (swWaveSystem_IsValid(world, sea->swells[i]))
        {
            swDestroyWaveSystem(world, sea->swells[i]);
        }
    }
    if (swWaveSystem_IsValid(world, sea->windSea))
    {
        swDestroyWaveSystem(world, sea->windSea);
    }
    memset(sea, 0, sizeof(*sea));
}
