// SPDX-License-Identifier: MIT
#pragma once

// Attributes by which an EXR image of ours says where its cells lie (of the north-western one the middle, m of the
// world), and what it was made from.

#define SW_EXR_X "seawayX"
#define SW_EXR_Z "seawayZ"
#define SW_EXR_SPACING_X "seawaySpacingX"
#define SW_EXR_SPACING_Z "seawaySpacingZ"
#define SW_EXR_SOURCE "seawaySource"
#define SW_EXR_SOURCE_HASH "seawaySourceHash"
