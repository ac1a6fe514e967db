#!/bin/sh
# SPDX-License-Identifier: MIT
# `seaway stats`: what was asked beside what was measured.
# Usage: test_stats.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

run 0 stats "$source/scenes/buoy.yaml" --seeds 1 --duration 60 --json
is_json out
for key in asked measured hs_m tp_s tm01_s tm02_s te_s mean_direction_from_deg peak_direction_from_deg spread_deg \
    mean_square_slope whitecap_fraction standard_error measured_m2_per_hz; do
    out "\"$key\":"
done
# One name for one thing, in the errors too.
! grep -q 'direction_deg' out || fail "$what: a direction has another name than in other verbs"
run 0 stats "$source/scenes/buoy.yaml" --seeds 1 --duration 60 --area 2000 --plot stats.svg
out '^Hs '
out '^share of variance'
has stats.svg
grep -q 'measured on the surface' stats.svg || fail "the plot does not say what was measured"
run 1 stats "$source/scenes/buoy.yaml" --seeds 1 --duration 60 --plot nosuch/plot.svg
err 'its folder does not exist'
# Waves by hand ask for their own variance: 4 sqrt(0.4^2 / 2) m, not that of a wind.
printf 'waves:\n  - components: [{wavelength_m: 60, amplitude_m: 0.4, direction_from_deg: 270}]\n' >hand.yaml
run 0 stats hand.yaml --seeds 1 --duration 60
out '^Hs  *1\.131  *1\.13'
out '^from, mean  *270\.0'
run 1 stats nosuch.yaml
err 'nosuch.yaml'

finish
