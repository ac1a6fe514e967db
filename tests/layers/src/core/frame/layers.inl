// SPDX-License-Identifier: MIT
//@ end
SW_LAYER(WETNESS, wetness, Wetness, .kind = SW_LAYER_IS_LOOK, .format = SW_TEXEL_R32F, .isLinear = true,
         .hasPast = true, .rate = 20, .mostSteps = 2, .longestGap = 2, .isExact = true, .isSaved = true, .most = 1.0f)
SW_LAYER(INK, ink, Ink, .kind = SW_LAYER_IS_SIMULATED, .format = SW_TEXEL_R32F, .hasPast = true, .rate = 20,
         .mostSteps = 40, .longestGap = 2, .isSaved = true, .most = 1.0f)
