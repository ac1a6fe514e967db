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
# A peak of one bin, before a broad hump nearly as high that goes elsewhere, keeps its period and its direction.
printf '2022 01 01 00 00 9.999 0.2 (0.070) 1.0 (0.080) 0.2 (0.090) 0.9 (0.100) 0.9 (0.110) 0.9 (0.120)\n' >peak.data_spec
printf '2022 01 01 00 00 60 (0.070) 190 (0.080) 60 (0.090) 60 (0.100) 60 (0.110) 60 (0.120)\n' >peak.swdir
printf '2022 01 01 00 00 .9 (0.070) .9 (0.080) .9 (0.090) .9 (0.100) .9 (0.110) .9 (0.120)\n' >peak.swr1
printf 'waves:\n  - spectrum: file\n    file: peak.data_spec\n' >peak.yaml
run 0 stats peak.yaml --seeds 4
out '^Tp  *12\.50  *12\.50'
out '^from, at the peak  *190\.0  *1\(8[89]\|9[012]\)\.'
run 1 stats nosuch.yaml
err 'nosuch.yaml'

finish
