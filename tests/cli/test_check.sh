#!/bin/sh
# SPDX-License-Identifier: MIT
# `seaway check`: mistakes in scene files.
# Usage: test_check.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

for scene in "$source"/scenes/*.yaml "$source"/scenes/dioramas/*.yaml; do
    # A scene whose files are no part of the project, and may be missing, says so.
    optional=$(grep -c 'is_optional: true' "$scene")
    if [ "$optional" -gt 0 ] && [ ! -d "$source/scenes/data/$(basename "$scene" .yaml)" ]; then
        run 1 check "$scene"
        out "usable, 0 errors, $optional warnings"
        continue
    fi
    run 0 check "$scene"
    out 'fine'
done
printf 'name: Bad\nwaves:\n  - spectrum: jonswop\n' >bad.yaml
run 1 check bad.yaml
out 'bad.yaml:3'
run 1 check bad.yaml --json
is_json out
out '"line": 3'
out '"code": "unknown_word"'
run 1 check nosuch.yaml
out 'SW_ERROR_FILE'
! grep -q ': fine' out || fail "$what: says fine"
# Every mistake, each with its line and code.
printf 'name: Bad\nwaves:\n  - spectrum: jonswap\n    chop: 9\n    fetsh_m: 4\n    duration_h: 3\nsky: {haze: -1}\n' >three.yaml
run 1 check three.yaml
out '^error: three.yaml:4: chop is 9; its range is 0 to 2. \[out_of_range\]$'
out "^error: three.yaml:5: 'fetsh_m' is no key of waves"
out '^error: three.yaml:6: duration_h has no effect.*; remove it. \[no_effect\]$'
out '^error: three.yaml:7: haze is -1'
out '^three.yaml: not usable, 4 errors, 0 warnings$'
run 1 check three.yaml --json
is_json out
[ "$(grep -c '"code":' out)" -eq 4 ] || fail "$what: not four codes"
out '"line": 6'
out '"error_count": 4'
# Seas that are flat, and scenes that nobody can draw, are usable and not fine.
views='views: [{name: a}]'
for flat in 'waves: []' 'waves: [{components: [{wavelength_m: 60, amplitude_m: 0, direction_from_deg: 0}]}]' \
    'waves: [{spectrum: jonswap, weight: 0}]' \
    'waves: [{spectrum: jonswap, wind_speed_mps: 2, fetch_m: 1000, min_wavelength_m: 2000, max_wavelength_m: 4000}]'; do
    printf '%s\n%s\n' "$flat" "$views" >flat.yaml
    run 1 check flat.yaml
    out 'flat; .*\[flat\]$'
    out '^flat.yaml: usable, 0 errors, 1 warning$'
    run 0 stats flat.yaml
    out '^Hs  *0.000  *0.000'
    out 'The sea has no energy'
    run 0 stats flat.yaml --json
    is_json out
    out '"hs_m": 0,'
    out '"tp_s": null'
    run 1 stats flat.yaml --plot flat.svg
    err 'has no waves to plot'
    hasnot flat.svg
done
printf 'waves: [{beaufort: 4}]\n' >blind.yaml
run 1 check blind.yaml
out '^warning: blind.yaml:1: the scene has no views.*\[no_views\]$'
out '^blind.yaml: usable, 0 errors, 1 warning$'
run 1 check blind.yaml --json
out '"code": "no_views"'
# Information is told and does not change the exit code.
printf '%s\nwaves: [{beaufort: 4}]\nsplines: [{name: a, points: [{x_m: 0}, {x_m: 9}]}]\n' "$views" >spare.yaml
run 0 check spare.yaml
out '^info: spare.yaml:3: spline 1 .*\[unused_spline\]$'
out '^spare.yaml: fine$'
run 0 check spare.yaml --json
is_json out
out '"info_count": 1'
out '"severity": "info"'
# What reading has told already is not told twice.
printf '%s\nwaves: [{beaufort: 4}]\nrasters: [{name: a, file: none.asc, is_optional: true}]\n' "$views" >lost.yaml
run 1 check lost.yaml
[ "$(grep -c 'left_out' out)" -eq 1 ] || fail "$what: left_out is told twice"
# What only the world refuses has its line and code.
printf '%s\nwaves: [{beaufort: 4}]\ninputs:\n  - {field: floor, blend: multiply}\n' "$views" >refused.yaml
run 1 check refused.yaml --json
out '"code": "refused"'
out '"line": 4'
# A flat system beside others.
printf 'waves:\n  - {spectrum: jonswap, weight: 0}\n  - components: [{wavelength_m: 60, amplitude_m: 0.4, direction_from_deg: 0}]\n' >both.yaml
run 0 stats both.yaml --seeds 1 --duration 60
out '^Hs  *1\.131'
# Depth costs time by its square: refused before it does.
awk 'BEGIN { for (i = 0; i < 100000; ++i) printf "["; print "" }' >deep.yaml
count=$((count + 1))
what='seaway check of 100,000 brackets'
(ulimit -t 10 && "$seaway" check deep.yaml >out 2>err)
[ $? -eq 1 ] || fail "$what: not exit code 1 within 10 s of the processor"
out 'deep.yaml:1: lists and mappings are nested more than 16 deep.*\[too_large\]$'

finish
