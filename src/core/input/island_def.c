// SPDX-License-Identifier: MIT
#include "core/input/island.h"

#define SW_DEF swIslandDef

static const swField islandFields[] = {
    SW_NUMBER(seed, "", SW_WITHIN(0.0, 4294967295.0), 1.0, .key = "seed", .label = "seed",
              .tip = "Another seed is another island", SW_KNOB(0.0, 100.0)),
    SW_NUMBER(x, "m", SW_WITHIN(-1e8, 1e8), 0.0, .key = "x_m", .label = "x of its middle"),
    SW_NUMBER(z, "m", SW_WITHIN(-1e8, 1e8), 0.0, .key = "z_m", .label = "z of its middle"),
    SW_NUMBER(radius, "m", SW_WITHIN(50.0, 20000.0), 1000.0, .key = "radius_m", .label = "radius",
              .tip = "From the middle to the coast, on the average", SW_LOG_KNOB(50.0, 20000.0)),
    SW_NUMBER(height, "m", SW_WITHIN(1.0, 4000.0), 300.0, .key = "height_m", .label = "height",
              .tip = "Of its mountain, about", SW_LOG_KNOB(1.0, 4000.0)),
    SW_NUMBER(depth, "m", SW_WITHIN(1.0, 8000.0), 150.0, .key = "depth_m", .label = "depth around",
              SW_LOG_KNOB(1.0, 8000.0)),
    SW_NUMBER(shelfWidth, "m", SW_WITHIN(0.0, 20000.0), 300.0, .key = "shelf_width_m", .label = "width of the shelf",
              .tip = "How far the beach goes on under water", SW_LOG_KNOB(1.0, 5000.0)),
    SW_NUMBER(ruggedness, "", SW_WITHIN(0.0, 1.0), 0.6, .key = "ruggedness", .label = "ruggedness",
              .tip = "Of coast, mountain and floor: 0 is a smooth cone", SW_KNOB(0.0, 1.0)),
    SW_NUMBER(extent, "m", SW_WITHIN(100.0, 200000.0), 6000.0, .key = "extent_m", .label = "extent of the floor",
              .tip = "Side of the square whose floor is known", SW_LOG_KNOB(100.0, 200000.0)),
    SW_NUMBER(cells, "", SW_WITHIN(2.0, 8192.0), 1025.0, .key = "cells", .label = "cells along a side",
              SW_LOG_KNOB(64.0, 8192.0)),
};

const swFields swIslandFields = SW_FIELDS(swIslandDef, "island", "island", islandFields, -1);

const swFields* swGetIslandFields(void)
{
    return &swIslandFields;
}

swIslandDef swDefaultIslandDef(void)
{
    swIslandDef def;
    swFillDef(&swIslandFields, &def);
    return def;
}
