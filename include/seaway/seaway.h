// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// The core: everything that a server without a GPU needs. gpu.h, layers.h and draw.h are included by name.

#include "base.h"
#include "clock.h"
#include "field.h"
#include "hull.h"
#include "island.h"
#include "id.h"
#include "input.h"
#include "math.h"
#include "measured.h"
#include "mesh.h"
#include "moment.h"
#include "query.h"
#include "raster.h"
#include "replay.h"
#include "save.h"
#include "sea.h"
#include "spectrum.h"
#include "spline.h"
#include "view.h"
#include "water_body.h"
#include "waves.h"
#include "wind.h"
#include "wind_sea.h"
#include "world.h"
