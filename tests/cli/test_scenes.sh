#!/bin/sh
# SPDX-License-Identifier: MIT
# The scenes of the gallery: what each puts into the sea is there, at the places that its comments speak of.
# Usage: test_scenes.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

# ask SCENE X,Z COLUMN LEAST MOST: a column of a field's answer, or of the height.
ask() {
    case $3 in
    height_m) fields= ;;
    flow_*) fields='--fields flow' ;;
    *) fields="--fields $(echo "$3" | sed 's/^light$/shadow/; s/_.*//')" ;;
    esac
    echo "$2" >points.csv
    run 0 query "$source/scenes/$1.yaml" --points points.csv $fields
    awk -F, -v column="$3" -v least="$4" -v most="$5" '
        NR == 1 { for (i = 1; i <= NF; ++i) if ($i == column) at = i }
        NR == 2 { found = at > 0 && $at + 0 >= least + 0 && $at + 0 <= most + 0 }
        END { exit !found }' out || fail "$what: $3 at $2 is not from $4 to $5"
}

ask harbour 150,-128 clip 0.9 1
ask harbour -45,-86 clip 0.9 1
ask harbour -120,-86 clip 0 0.1
ask harbour 0,0 level_m -0.01 0.01
ask main 60,420 depth_m -200 -20
ask main 42,39 depth_m 5 45
ask strait 0,0 flow_x_mps 3.19 3.21
ask strait 0,0 depth_m 8 20
ask strait 0,-600 depth_m -200 -1
ask whirlpool 0,0 level_m -20 -19.9
ask whirlpool 5,0 flow_z_mps -9.5 -8.5
ask whirlpool 80,0 flow_x_mps 0 0
ask shore_waves 0,0 depth_m 4 9
ask shore_waves 0,-160 depth_m -40 -2
# Swell of the spline: higher before the beach than on the open sea, where it is not.
"$seaway" query "$source/scenes/shore_waves.yaml" --map -60,20,60,140,6 >map.csv
"$seaway" query "$source/scenes/shore_waves.yaml" --map -60,1500,60,1620,6 >sea.csv
count=$((count + 2))
spread() { awk -F, 'NR > 1 { sum += $4; square += $4 * $4; ++n } END { print sqrt(square / n - (sum / n) ^ 2) }' "$1"; }
awk -v shore="$(spread map.csv)" -v open="$(spread sea.csv)" 'BEGIN { exit !(shore > 2 * open) }' ||
    fail "shore_waves: heights deviate by $(spread map.csv) m before the beach and $(spread sea.csv) m on the open sea"

ask dioramas/flow_past_spheres 0,30 flow_x_mps 1.99 2.01
ask dioramas/flow_past_spheres -5,-8 flow_x_mps 0.49 0.51
ask dioramas/flow_past_spheres -16,-8 depth_m -5 -3
ask dioramas/foam_and_shadow -22,13 foam_per_s 0.4 0.5
ask dioramas/foam_and_shadow -22,0 foam_per_s 0 0
ask dioramas/foam_and_shadow 24,14 light 0 0.2
ask dioramas/foam_and_shadow 24,0 light 1 1
ask dioramas/particles_and_trails -22,-4 foam_per_s 1.19 1.21
ask dioramas/particles_and_trails 24,17 foam_per_s 0.63 0.65
ask dioramas/push_down 14,0 height_m -2.51 -2.49
ask dioramas/push_down -24,-4 clip 0.9 1
ask dioramas/scale_waves -30,10 height_m 0 0
ask dioramas/scale_waves -30,0 height_m -1.51 -1.49
ask dioramas/scale_waves 30,0 height_m 0 0
ask dioramas/varying_level -40,0 level_m 4.99 5.01
ask dioramas/varying_level 40,0 level_m -2.61 -2.59
ask dioramas/varying_level 0,0 depth_m -7 -6
ask dioramas/river 18,0 level_m 1.99 2.01
ask dioramas/river 18,0 depth_m 0.99 1.01
ask dioramas/river 18,0 flow_x_mps 2 2.5
ask dioramas/river 108,4 level_m -0.01 0.01
ask dioramas/wave_particle 0,-12 height_m 5 6
ask dioramas/wave_particle 14,14 height_m -1.8 -0.8
ask dioramas/clipping -4.5,0 clip 0.9 1
ask dioramas/clipping 0,0 clip 0 0.1
ask dioramas/logo -8.2,0 albedo_red 0.84 0.86
ask dioramas/logo 0,40 albedo_cover 0 0
"$seaway" query "$source/scenes/dioramas/wave_patch.yaml" --map -10,-30,10,10,4 >in.csv
"$seaway" query "$source/scenes/dioramas/wave_patch.yaml" --map 390,-30,410,10,4 >off.csv
count=$((count + 2))
awk -v inside="$(spread in.csv)" -v off="$(spread off.csv)" 'BEGIN { exit !(inside > 4 * off) }' ||
    fail "wave_patch: heights deviate by $(spread in.csv) m in the patch and $(spread off.csv) m outside"
# Both halves have the same sea, statistically.
"$seaway" query "$source/scenes/dioramas/fft_and_gerstner.yaml" --map -460,-200,-60,200,12 >west.csv
"$seaway" query "$source/scenes/dioramas/fft_and_gerstner.yaml" --map 60,-200,460,200,12 >east.csv
count=$((count + 2))
awk -v west="$(spread west.csv)" -v east="$(spread east.csv)" \
    'BEGIN { exit !(west > 0.2 && west < 1.25 * east && east < 1.25 * west) }' ||
    fail "fft_and_gerstner: heights deviate by $(spread west.csv) m in the west and $(spread east.csv) m in the east"

finish
