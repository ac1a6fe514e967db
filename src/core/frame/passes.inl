// SPDX-License-Identifier: MIT
// Every pass that both halves run, in order: SW_PASS(NAME, name, text).
// The core module, shaders/**/name.comp, gpu/pass/pass_name.c and tests/parity/parity_name.c go with each line. The GPU
// runs the lines in this order; barriers follow from what they read and write, see gpu/pass/passes.h.
SW_PASS(FIELDS, fields, "Authored fields of all slices, and what shapes waves in each block")
SW_PASS(VOLUME_WAVES, volume_waves, "Waves of this time one by one, for the water below")
SW_PASS(WAVES_ROWS, waves_rows, "Spectra at this time, and the FFT's first axis")
SW_PASS(WAVES_COLUMNS, waves_columns, "The FFT's second axis: tiles of spline coefficients")
SW_PASS(SLICES_SHAPED, slices_shaped, "Waves that authored fields shape, summed up for all slices")
SW_PASS(DETAIL, detail, "Slopes of each tile with mips, for shading")
SW_PASS(SLICES, slices, "Displacement and derivatives of all slices")
SW_PASS(SURFACE_QUERY, surface_query, "Surface at the points of queries")
SW_PASS(RAY_QUERY, ray_query, "What rays meet")
SW_PASS(FOAM, foam, "Foam of all slices")
SW_PASS(MADE_FOAM, made_foam, "Foam that inputs and shores make, of all slices")
SW_PASS(VOLUME_QUERY, volume_query, "The water below at the points of queries")
