// SPDX-License-Identifier: MIT
// Every layer: SW_LAYER(NAME, name, Maker, ...), and what stands there of swLayerInfo (core/frame/layers.h says what
// each member means). swPlanMaker() and swStepMaker() make the layer on the CPU; lines that follow each other with one
// maker are made by one call of it. Window, scrolling, clock, memory, saving, rewinding and digest follow from the
// line.
SW_LAYER(PLACES, places, Fields, .kind = SW_LAYER_IS_FIELD, .format = SW_TEXEL_RGBA32F, .rest = {1e30f},
         .channels = {"depth", "slope_x", "slope_z", "level"})
SW_LAYER(FLOW, flow, Fields, .kind = SW_LAYER_IS_FIELD, .format = SW_TEXEL_RGBA32F, .channels = {"x", "z"})
SW_LAYER(FLOW_SLOPES, flow_slopes, Fields, .kind = SW_LAYER_IS_FIELD, .format = SW_TEXEL_RGBA16F,
         .channels = {"x_by_x", "x_by_z", "z_by_x", "z_by_z"})
SW_LAYER(DISPLACEMENT, displacement, Slices, .kind = SW_LAYER_IS_LOOK, .format = SW_TEXEL_RGBA32F,
         .channels = {"x", "y", "z"})
SW_LAYER(DERIVATIVES, derivatives, Slices, .kind = SW_LAYER_IS_LOOK, .format = SW_TEXEL_RGBA16F, .isLinear = true,
         .channels = {"gx", "gz", "jacobian"})
SW_LAYER(FOAM, foam, Foam, .kind = SW_LAYER_IS_LOOK, .format = SW_TEXEL_R32F, .isLinear = true, .hasPast = true,
         .rate = SW_FOAM_RATE, .mostSteps = 4, .longestGap = 1, .isExact = true, .isSaved = true, .most = 1.0f)
SW_LAYER(WAKE_FOAM, wake_foam, MadeFoam, .kind = SW_LAYER_IS_LOOK, .format = SW_TEXEL_R32F, .isLinear = true,
         .hasPast = true, .rate = SW_FOAM_RATE, .mostSteps = 4, .longestGap = 1, .isExact = true, .isOnDemand = true,
         .isSaved = true, .most = 1.0f)
SW_LAYER(SHORE_FOAM, shore_foam, MadeFoam, .kind = SW_LAYER_IS_LOOK, .format = SW_TEXEL_R32F, .isLinear = true,
         .hasPast = true, .rate = SW_FOAM_RATE, .mostSteps = 4, .longestGap = 1, .isExact = true, .isOnDemand = true,
         .isSaved = true, .most = 1.0f)
