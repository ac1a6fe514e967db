// SPDX-License-Identifier: MIT
//@ end
SW_PASS(WETNESS, wetness, "Wetness of all slices")
