// SPDX-License-Identifier: MIT
// What a scene that can be read is rarely meant to be: SW_REMARK(NAME, code, severity, what is found, what helps).
// swScene_Check() finds them in this order; scripts/make_check_docs writes docs/checks.md from this list; each has a
// scene in tests/core/test_scene_check.c.
SW_REMARK(NO_VIEWS, "no_views", WARNING, "the scene has no views, so it cannot be drawn", "add one under views")
SW_REMARK(FLAT, "flat", WARNING, "no waves of the scene have energy, so its sea is flat",
          "list some under waves, with a height and a weight")
SW_REMARK(NO_REGION, "no_region", WARNING,
          "no input weighs a local wave system, and no body of water has it, so its waves are nowhere",
          "add an input with the field waves, name it in a body of water, or let it be everywhere")
SW_REMARK(OTHER_WIND, "other_wind", WARNING, "waves are of another wind than the scene's",
          "let them take the wind, or give both the same speed")
SW_REMARK(NO_DIRECTIONS, "no_directions", WARNING,
          "a record of a measured sea has no directions, so that its waves are made around east",
          "name the files with its directions, or another record")
SW_REMARK(FOAM_FILTER, "foam_filter", WARNING,
          "foam counts only waves longer than any of the scene's, so there are no whitecaps",
          "lower the foam's min_wavelength_m")
SW_REMARK(COARSE_VIEW, "coarse_view", WARNING, "slices have so few texels that their borders show",
          "give the view's resolution 128 or more")
SW_REMARK(VIEW_IN_FLOOR, "view_in_floor", WARNING, "a view lies under the sea floor", "move it up")
SW_REMARK(DISABLED_INPUT, "disabled_input", INFO, "an input is disabled", "enable it, or remove it")
SW_REMARK(EMPTY_INPUT, "empty_input", WARNING, "an input says nothing: its weight is 0, or it adds 0",
          "give it a weight and a value, or remove it")
SW_REMARK(TILTED_INPUT, "tilted_input", WARNING,
          "an input is tilted, but its shape is flat, so that only the yaw counts",
          "give it a shape with a height, or set pitch and roll to 0")
SW_REMARK(COVERED_INPUT, "covered_input", WARNING,
          "an input that replaces everything everywhere comes after this one, which is therefore never seen",
          "change their order, or remove it")
SW_REMARK(LEVEL_OVER_BODY, "level_over_body", WARNING,
          "an input of levels everywhere joins after a body of water with a level of its own, and changes that, too",
          "give the body a higher order than the input")
SW_REMARK(FAST_FLOW, "fast_flow", WARNING, "an input gives a current of more than 10 m/s, faster than any at sea",
          "give its value in m/s")
SW_REMARK(FAST_MOTION, "fast_motion", WARNING, "an input moves by more than 50 m/s, faster than any ship",
          "give its velocity in m/s, or its path more time")
SW_REMARK(WIND_OF_QUERIES, "wind_of_queries", INFO,
          "an input of wind changes what queries answer, and neither waves nor whitecaps",
          "list waves that follow a map of the wind under wind_seas")
SW_REMARK(SPARE_CHANNELS, "spare_channels", WARNING,
          "an input's raster has more numbers a cell than its field, so that the last ones are not read",
          "choose another field, or give the raster fewer channels")
SW_REMARK(STANDING_FRAMES, "standing_frames", WARNING,
          "an input's raster has several frames, of which the first alone is seen",
          "let them play by frames_per_s, or give the raster one")
SW_REMARK(TINY_FLOOR, "tiny_floor", WARNING,
          "the raster of a floor is less than 5 m wide, as one is whose degrees are read as metres",
          "say which coordinates it has, or how far its cells are apart")
SW_REMARK(SMALL_BODY, "small_body", WARNING, "a body of water is less than 2 m wide", "give its points in metres")
SW_REMARK(LEFT_OUT, "left_out", WARNING, "an optional file is not there, so what names it is left out",
          "put the file there, or remove what names it")
SW_REMARK(SMALL_RASTER, "small_raster", WARNING, "a raster has fewer than four cells along a side",
          "give it more cells, or use a rectangle")
SW_REMARK(UNKNOWN_RASTER, "unknown_raster", WARNING, "no cell of a raster is known", "look whether it was cropped away")
SW_REMARK(STALE_RASTER, "stale_raster", WARNING,
          "a raster is not what its made_from gives now, or that cannot be known of its file",
          "bake it anew by `seaway bake depth`, or remove made_from")
SW_REMARK(UNUSED_RASTER, "unused_raster", INFO, "no input names a raster", "name it, or remove it")
SW_REMARK(UNUSED_SPLINE, "unused_spline", INFO, "no input names a spline", "name it, or remove it")
SW_REMARK(UPRIGHT_MESH, "upright_mesh", WARNING,
          "nothing of a mesh is seen from above: it is all walls, or all above its highest_m",
          "look which of its axes is up, and how high it lies")
SW_REMARK(UNUSED_MESH, "unused_mesh", INFO, "no input names a mesh", "name it, or remove it")
SW_REMARK(UNUSED_HULL, "unused_hull", INFO, "no input names a hull", "name it, or remove it")
SW_REMARK(UNUSED_LOOK, "unused_look", INFO, "no body of water has a look", "give it to one, or remove it")
SW_REMARK(NARROW_BEND, "narrow_bend", WARNING,
          "a spline bends more narrowly towards its ribbon than that is wide there",
          "move its points apart, or make it narrower")
