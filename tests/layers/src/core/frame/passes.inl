// SPDX-License-Identifier: MIT
// Lines that stand at the end of src/core/frame/passes.inl in the library of these tests.
SW_PASS(WETNESS, wetness, "Wetness of all slices")
