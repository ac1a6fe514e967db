// SPDX-License-Identifier: MIT
// The places of a measured sea, found by name or by name and position: a hash table of open addressing, twice as
// large as it need be. Each place stands in it once with its position and, if it is the first of its name, once
// without: files of a hundred thousand points are read in linear time.

#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "core/records/measured.h"

typedef struct Slot
{
    uint32_t hash;
    int location1; // index plus 1; 0: empty
    bool isByName;
} Slot;

static uint32_t hashBytes(uint32_t hash, const void* bytes, size_t size)
{
    const unsigned char* at = bytes;
    for (size_t i = 0; i < size; ++i)
    {
        hash = (hash ^ at[i]) * 16777619u; // FNV-1a
    }
    return hash;
}

static uint32_t hashPlace(const char* name, double longitude, double latitude, bool isByName)
{
    uint32_t hash = hashBytes(2166136261u, name, strlen(name));
    if (!isByName)
    {
        double position[2] = {longitude + 0.0, latitude + 0.0}; // -0 becomes 0
        hash = hashBytes(hash, position, sizeof(position));
    }
    return hash ^ hash >> 15;
}

static bool isSame(double a, double b)
{
    return a == b || (a != a && b != b);
}

static Slot* getSlots(const swMeasuredSea* sea)
{
    return sea->places.data;
}

// The slot of such a place, or the empty one where it belongs. There must be an empty one.
static Slot* findSlot(const swMeasuredSea* sea, const char* name, double longitude, double latitude, bool isByName)
{
    const swMeasuredLocation* locations = sea->locations.data;
    uint32_t hash = hashPlace(name, longitude, latitude, isByName);
    size_t mask = sea->places.capacity - 1;
    for (size_t i = hash & mask;; i = (i + 1) & mask)
    {
        Slot* slot = &getSlots(sea)[i];
        if (slot->location1 == 0)
        {
            return slot;
        }
        const swMeasuredLocation* known = &locations[slot->location1 - 1];
        if (slot->hash == hash && slot->isByName == isByName && strcmp(known->name, name) == 0 &&
            (isByName || (isSame(known->longitude, longitude) && isSame(known->latitude, latitude))))
        {
            return slot;
        }
    }
}

static void addToSlots(swMeasuredSea* sea, int location, bool isByName)
{
    const swMeasuredLocation* place = (const swMeasuredLocation*)sea->locations.data + location;
    Slot* slot = findSlot(sea, place->name, place->longitude, place->latitude, isByName);
    if (slot->location1 == 0)
    {
        *slot = (Slot){hashPlace(place->name, place->longitude, place->latitude, isByName), location + 1, isByName};
        ++sea->places.count;
    }
}

static bool growSlots(swMeasuredSea* sea)
{
    swArray old = sea->places;
    size_t capacity = old.capacity > 0 ? 2 * old.capacity : 64;
    void* slots = swAllocateZero(&sea->host, capacity * sizeof(Slot));
    if (slots == NULL)
    {
        return false;
    }
    sea->places = (swArray){slots, 0, capacity};
    for (size_t i = 0; i < old.capacity; ++i)
    {
        const Slot* slot = (const Slot*)old.data + i;
        if (slot->location1 > 0)
        {
            addToSlots(sea, slot->location1 - 1, slot->isByName);
        }
    }
    swFreeItems(&sea->host, &old, sizeof(Slot));
    return true;
}

bool swIndexSeaPlace(swMeasuredSea* sea, int location)
{
    if (2 * (sea->places.count + 2) > sea->places.capacity && !growSlots(sea))
    {
        return false;
    }
    addToSlots(sea, location, true);
    addToSlots(sea, location, false);
    return true;
}

void swFreeSeaPlaces(swMeasuredSea* sea)
{
    swFreeItems(&sea->host, &sea->places, sizeof(Slot));
}

int swFindSeaPlace(const swMeasuredSea* sea, const char* name, double longitude, double latitude)
{
    return sea->places.capacity > 0 ? findSlot(sea, name, longitude, latitude, false)->location1 - 1 : -1;
}

int swMeasuredSea_FindLocation(const swMeasuredSea* sea, const char* name)
{
    SW_REQUIRE(sea != NULL, -1, NULL, "swMeasuredSea_FindLocation() needs a sea");
    return name != NULL && sea->places.capacity > 0 ? findSlot(sea, name, 0.0, 0.0, true)->location1 - 1 : -1;
}

swResult swFindSeaPoint(swMeasuredSea* sea, bool isNew, int index, const char* name, double longitude, double latitude,
                        int* location)
{
    const swMeasuredLocation* locations = sea->locations.data;
    *location = -1;
    if (!isNew)
    {
        bool isHere = index < (int)sea->locations.count && strcmp(locations[index].name, name) == 0;
        *location = isHere ? index : swMeasuredSea_FindLocation(sea, name);
    }
    return *location >= 0 ? SW_SUCCESS : swMeasuredSea_AddLocation(sea, name, longitude, latitude, location);
}
