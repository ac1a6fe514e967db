#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: test_cli.sh PART PROGRAM SOURCE_FOLDER
# Runs the program as a user would and checks exit code, standard output and messages. Exit code 77: skipped.
set -u
part=$1
seaway=$2
source=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0
count=0

fail() {
    failures=$((failures + 1))
    echo "FAILED: $1"
    sed 's/^/  out: /' out | head -5
    sed 's/^/  err: /' err | head -5
}

# run CODE ARGUMENTS...: the exit code is CODE.
run() {
    wanted=$1
    shift
    count=$((count + 1))
    what="seaway $*"
    "$seaway" "$@" >out 2>err </dev/null
    code=$?
    [ "$code" -eq "$wanted" ] || fail "$what: exit code $code, not $wanted"
    # A failure is one sentence on stderr, and nothing but the sentence.
    if [ "$wanted" -eq 2 ] && { [ "$(wc -l <err)" -ne 1 ] || [ -s out ]; }; then
        fail "$what: not one sentence on stderr alone"
    fi
}

out() { grep -q -- "$1" out || fail "$what: standard output lacks \"$1\""; }
err() { grep -q -- "$1" err || fail "$what: the message lacks \"$1\""; }
has() { [ -s "$1" ] || fail "$what: there is no $1"; }
hasnot() { ! ls $1 >/dev/null 2>&1 || fail "$what: $1 was left behind"; }

needs_device() {
    "$seaway" devices >out 2>err || {
        echo "skipped: $(cat err)"
        exit 77
    }
}

# is_json FILE, where Python is installed
is_json() {
    command -v python3 >/dev/null || return 0
    python3 -c 'import json, sys; json.load(open(sys.argv[1]))' "$1" 2>err || fail "$what: no JSON"
}

sea=$source/scenes/open_sea.yaml
buoy=$source/scenes/data/harbour_storm.data_spec

test_usage() {
    run 0 --help
    out 'Usage: seaway'
    run 0 --version
    out '^seaway [0-9]'
    "$seaway" >out 2>err
    [ $? -eq 2 ] || fail "no verb is not exit code 2"
    run 2 rendr
    err 'did you mean render'
    run 2 zzzzzzz
    err 'seaway --help'
    for verb in view render query stats spectrum check bench devices; do
        run 0 "$verb" --help
        out "Usage: seaway $verb"
        run 0 help "$verb"
        run 2 "$verb" --no-such-thing
        err 'there is no option --no-such-thing'
    done
    run 2 render "$sea" --out a.png --sise 64x64
    err 'did you mean --size'
    run 2 render
    err 'a scene file is missing'
    run 2 check a b
    err 'one argument too many'
    run 2 stats "$sea" --seeds
    err '--seeds wants a value'
    run 2 stats "$sea" --seeds 0
    err 'outside its range'
    run 2 stats "$sea" --seeds 1.5
    err 'whole number'
    run 2 devices --json=yes
    err 'takes no value'
}

# What rays meet, of both backends. The first goes down where a point asks for the height; the second comes out of the water.
query_rays() {
    printf '10.5,20,-3,0,-2,0,0\n10.5,-20,-3,0,1,0,0\n10.5,20,-3,0,1,0,0\n0,15,0,1,-1,0.5,1.5\n' >rays.csv
    run 0 query "$sea" --points points.csv --time 3
    height=$(tail -1 out | cut -d, -f4)
    run 0 query "$sea" --rays --points rays.csv --time 3
    out '^t_s,x_m,y_m,z_m,dx,dy,dz,radius_m,hit,distance_m,position_x_m,.*,point_z_m,nx,ny,nz,from_below$'
    [ "$(wc -l <out)" -eq 5 ] || fail "four rays are not five lines"
    awk -F, -v height="$height" '
        function near(a, b) { return (a - b) * (a - b) < 4e-6 }
        NF != 20 { exit 1 }
        NR == 2 && !($9 == 1 && near($10, 20 - height) && near($15, height) && $20 == 0) { exit 1 }
        NR == 3 && !($9 == 1 && near($10, 20 + height) && near($15, height) && $20 == 1) { exit 1 }
        NR == 4 && !($9 == 0 && $10 == 1000 && $11 == "" && $20 == "") { exit 1 }
        NR == 5 && !($9 == 1 && near(($11 - $14) ^ 2 + ($12 - $15) ^ 2 + ($13 - $16) ^ 2, 1.5 ^ 2)) { exit 1 }' out ||
        fail "the rays do not meet the water of the points"
    cp out first
    run 0 query "$sea" --rays --points first --time 3
    cmp -s out first || fail "answers read as rays give other answers"
    run 0 query "$sea" --rays --points rays.csv --time 3 --backend gpu
    paste -d, first out | awk -F, 'NR > 1 {
            if ($9 != $29 || $20 != $40) exit 1
            for (i = 10; i <= 19; ++i) { d = $i - $(i + 20); if (d * d > 4e-6) exit 1 }
        }' || fail "the GPU's rays meet other water"
    run 0 query "$sea" --rays --points rays.csv --time 3:4:1 --max-distance 5
    [ "$(grep -c ',0,5,,,,,,,,,,$' out)" -eq 8 ] || fail "rays of 5 m reach the water"
    printf '0,9,0,0,-1,0\n1,9,0,0,0,0\n' >still.csv
    run 1 query "$sea" --rays --points still.csv
    err 'still.csv:2: the direction dx,dy,dz is 0'
    run 1 query "$sea" --rays --points three.csv
    err 'three.csv:1: a line without a header has 6 columns (x,y,z,dx,dy,dz) or 7 (x,y,z,dx,dy,dz,radius), not 3'
    run 1 query "$sea" --rays --points deep.csv
    err 'deep.csv:1: the header names no column dx'
    printf 'x_m,y_m,z_m,dx,dy,dz,radius_m\n0,9,0,0,-1,0,-1\n' >thin.csv
    run 1 query "$sea" --rays --points thin.csv
    err 'thin.csv:2: radius -1 is outside its range of 0 to 100'
    run 2 query "$sea" --rays --points rays.csv --max-distance 2e5
    run 2 query "$sea" --rays --points rays.csv --motion
    err 'leave out --motion and --below'
    run 2 query "$sea" --rays --points rays.csv --below
    run 2 query "$sea" --points points.csv --max-distance 10
    err 'it wants --rays'
}

# A grid of heights is what its points are by themselves.
query_map() {
    run 0 query "$sea" --map 0,-1,1,0.75,0.5 --time 3
    out '^t_s,x_m,z_m,height_m$'
    cp out map
    sed '1d' map | cut -d, -f2,3 >grid.csv
    printf '%s\n' 0,-1 0.5,-1 1,-1 0,-0.5 0.5,-0.5 1,-0.5 0,0 0.5,0 1,0 0,0.5 0.5,0.5 1,0.5 | cmp -s - grid.csv ||
        fail "the map's points are not its grid"
    run 0 query "$sea" --points grid.csv --time 3
    cut -d, -f1-4 out | cmp -s - map || fail "a map has other heights than its points"
    run 0 query "$sea" --map=-1,-1,-1,-1,1 --time 1:2:0.5
    [ "$(wc -l <out)" -eq 4 ] || fail "three times of a map of one point are not four lines"
    run 2 query "$sea" --map 0,0,1,1
    err 'X0,Z0,X1,Z1,STEP'
    run 2 query "$sea" --map 1,0,0,1,1
    err 'holds nothing'
    run 2 query "$sea" --map 0,0,1,1,0
    run 2 query "$sea" --map 0,0,1e6,1e6,1
    err 'a larger STEP'
    run 2 query "$sea" --map 0,0,1,1,1e13
    err 'larger or farther out'
    run 2 query "$sea" --map 0,0,1,1,1 --backend gpu
    err 'answered by the CPU only'
    run 2 query "$sea" --map 0,0,1,1,1 --points points.csv
    err 'leave out --points'
    run 2 query "$sea" --map 0,0,1,1,1 --rays
    err 'leave out --motion, --below and --rays'
}

query_particles_and_drift() {
    run 0 query "$sea" --points points.csv --time 3 --particles --motion
    sed '1d' out | awk -F, '{ printf "%.9g,%.9g\n", $2 + $5, $3 + $7; print $4 > "heights" }' >moved.csv
    run 0 query "$sea" --points moved.csv --time 3
    sed '1d' out | cut -d, -f4 | paste -d, - heights |
        awk -F, '{ d = $1 - $2; if (d > 2e-3 || d < -2e-3) exit 1 }' || fail "particles are not where the surface is"
    run 2 query "$sea" --points points.csv --particles --below
    err 'leave out --map, --rays and --below'
    run 2 query "$sea" --points points.csv --particles --backend gpu
    err 'by the CPU only'
    printf '0,-1,0\n0,-20,0\n' >places.csv
    run 0 query "$sea" --points places.csv --below --drift
    out ',pressure_head_m,drift_x_mps,drift_z_mps$'
    sed '1d' out | awk -F, '{ d[NR] = $13 * $13 + $14 * $14 } END { exit !(NR == 2 && d[1] > d[2] && d[1] > 0) }' ||
        fail "drift does not fade with depth"
    run 2 query "$sea" --points points.csv --drift
    err 'wants --below'
}

test_query() {
    printf '0,0\n10.5,-3\n' >points.csv
    run 0 query "$sea" --points points.csv --time 3
    out '^t_s,x_m,z_m,height_m,dx_m,dy_m,dz_m,nx,ny,nz,jacobian,residual_m$'
    [ "$(wc -l <out)" -eq 3 ] || fail "two points are not three lines"
    cp out first
    printf 'z,name,x\n0,a,0\n-3,b,10.5\n' >named.csv
    run 0 query "$sea" --points named.csv --time 3
    cmp -s out first || fail "named columns give other answers"
    printf '0,99,0\n10.5,99,-3\n' >three.csv
    run 0 query "$sea" --points three.csv --time 3
    cmp -s out first || fail "x,y,z gives other answers"
    "$seaway" query "$sea" --time 3 <points.csv >out 2>err
    cmp -s out first || fail "standard input gives other answers"
    run 0 query "$sea" --points points.csv --time 3 --motion
    grep -q 'residual_m,vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2$' out || fail "query --motion has no columns of motion"
    printf 'x,y,z\n1,-8,2\n' >deep.csv
    run 0 query "$sea" --points deep.csv --time 3 --below --stretching linear
    grep -q '^3,1,-8,2,' out || fail "query --below does not answer at the point's height"
    run 1 query "$sea" --points points.csv --below
    run 2 query "$sea" --points deep.csv --below --motion
    run 0 query "$sea" --points points.csv --time 1:2:0.5
    [ "$(wc -l <out)" -eq 7 ] || fail "three times of two points are not seven lines"
    out '^1.5,10.5,-3,'
    printf '0,0\n1,oops\n' >bad.csv
    run 1 query "$sea" --points bad.csv
    err 'bad.csv:2: "oops" is no number'
    printf '0,0\n1,2,3\n' >ragged.csv
    run 1 query "$sea" --points ragged.csv
    err 'ragged.csv:2:'
    printf 'a,b\n1,2\n' >header.csv
    run 1 query "$sea" --points header.csv
    err 'header.csv:1: the header names no column x'
    run 1 query "$sea" --points nosuch.csv
    err 'cannot read nosuch.csv'
    run 1 query "$sea"
    err 'holds no points'
    printf '0,0\n6e10,0\n' >far.csv
    run 0 query "$sea" --points far.csv
    printf '0,2e12\n' >farther.csv
    run 1 query "$sea" --points farther.csv
    err 'farther.csv:1: z 2e12 is outside its range'
    run 1 query nosuch.yaml --points points.csv
    err 'nosuch.yaml'
    run 2 query "$sea" --time 1:0:1
    run 2 query "$sea" --time soon
    err 'T or A:B:STEP'
    run 0 query "$sea" --points points.csv --time 3 --backend gpu
    paste -d, first out | awk -F, 'NR > 1 { for (i = 4; i <= 7; ++i) { d = $i - $(i + 12); if (d * d > 4e-6) exit 1 } }' ||
        fail "the GPU gives other answers"
    [ "$(wc -l <out)" -eq 3 ] || fail "the GPU gives two points other than three lines"
    run 0 query "$sea" --points points.csv --time 3 --motion
    cp out first
    run 0 query "$sea" --points points.csv --time 3 --motion --backend gpu
    paste -d, first out | awk -F, 'NR > 1 { for (i = 13; i <= 18; ++i) { d = $i - $(i + 18); if (d * d > 4e-4) exit 1 } }' ||
        fail "the GPU gives other motion"
    run 0 query "$sea" --points deep.csv --time 3 --below
    cp out first
    run 0 query "$sea" --points deep.csv --time 3 --below --backend gpu
    paste -d, first out | awk -F, 'NR > 1 { for (i = 5; i <= 12; ++i) { d = $i - $(i + 12); if (d * d > 4e-6) exit 1 } }' ||
        fail "the GPU gives other water below"
    run 1 query "$sea" --points far.csv --backend gpu
    err 'beyond the 5e+10 m'
    run 2 query "$sea" --points points.csv --backend gpu --device 99
    err 'seaway devices'
    query_rays
    query_map
    query_particles_and_drift
    [ ! -e /dev/full ] || {
        "$seaway" query "$sea" --points points.csv >/dev/full 2>err
        [ $? -eq 1 ] || fail "a full disk is not exit code 1"
    }
}

test_spectrum() {
    run 0 spectrum "$buoy"
    out 'Hs  '
    run 0 spectrum "$buoy" --json --plot plot.svg
    is_json out
    out '"hs_m":'
    out '"mean_direction_from_deg":'
    has plot.svg
    grep -q '</svg>' plot.svg || fail "the plot has no end"
    run 0 spectrum "$buoy" --list
    run 0 spectrum "$buoy" --list --json
    is_json out
    run 0 spectrum "$buoy" --at 2024-11-16T06:50Z
    run 2 spectrum "$buoy" --at yesterday
    err 'wants a time'
    run 1 spectrum nosuch.data_spec
    err 'nosuch.data_spec'
    echo 'this is no spectrum' >text.data_spec
    run 1 spectrum text.data_spec
    err 'text.data_spec:1'
    echo 'neither this' >text.txt
    run 1 spectrum text.txt
    err 'SWAN'
    err 'ERA5'
    cat >swan.spec <<'END'
SWAN 1
LONLAT
2
  4.5 52.0
  4.6 52.1
AFREQ
2
0.1
0.2
NDIR
4
0
90
180
270
QUANT
1
VaDens
m2/Hz/degr
-99
FACTOR
1e-3
1 2 3 4
1 1 1 1
FACTOR
1e-2
1 2 3 4
1 1 1 1
END
    run 0 spectrum swan.spec
    out 'location 2 of 2'
    run 0 spectrum swan.spec --location 1 --json
    is_json out
    out '"longitude_deg": 4.5'
    run 0 spectrum swan.spec --list
    out 'location'
    run 2 spectrum swan.spec --location 3
    err 'number from 1 to 2'
    run 1 spectrum "$buoy" --plot nosuch/plot.svg
    err 'its folder does not exist'
}

test_stats() {
    run 0 stats "$source/scenes/buoy.yaml" --seeds 1 --duration 60 --json
    is_json out
    for key in asked measured hs_m tp_s tm01_s tm02_s te_s mean_direction_from_deg peak_direction_from_deg spread_deg \
        mean_square_slope whitecap_fraction standard_error measured_m2_per_hz; do
        out "\"$key\":"
    done
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
}

test_check() {
    for scene in "$source"/scenes/*.yaml; do
        run 0 check "$scene"
        out 'fine'
    done
    printf 'name: Bad\nwaves:\n  - spectrum: jonswop\n' >bad.yaml
    run 1 check bad.yaml
    out 'bad.yaml:3'
    run 1 check bad.yaml --json
    is_json out
    out '"line": 3'
    out '"code": "SW_ERROR_FORMAT"'
    run 1 check nosuch.yaml
    out 'SW_ERROR_FILE'
}

test_devices() {
    needs_device
    run 0 devices
    run 0 devices --json
    is_json out
    out '"usable": true'
}

test_render() {
    run 2 render "$sea"
    err '--out is missing'
    run 2 render "$sea" --out a.jpg
    err 'none of .png, .exr and .mp4'
    run 2 render "$sea" --out a.png --size 64
    err 'a width and a height'
    run 2 render "$sea" --out a.png --frames 3
    run 2 render "$sea" --out a.mp4 --size 65x64
    err 'even width'
    run 2 render "$sea" --out a.png --samples 3
    run 2 render "$sea" --out a.png --debug slises
    err 'did you mean slices'
    run 2 render "$sea" --out a.png --device fast
    run 1 render "$sea" --out nosuch/a.png
    err 'its folder does not exist'
    run 1 render "$sea" --out nosuch/frames/
    err 'cannot make the folder'
    run 1 render "$sea" --out a.png --view nosuch
    err 'has no view "nosuch"'
    run 1 render nosuch.yaml --out a.png
    hasnot 'a.png*'
    hasnot '.a.png*'
    needs_device
    small='--size 64x48 --warmup 0.1'
    run 1 render "$sea" --out a.png $small --device 63
    hasnot 'a.png'
    run 0 render "$sea" --out a.png $small --validate
    has a.png
    run 0 render "$sea" --out a.exr $small --samples 4 --debug height
    has a.exr
    run 0 render "$sea" --out frames $small --frames 2
    has frames/frame_00000.png
    has frames/frame_00001.png
    if command -v ffmpeg >/dev/null; then
        run 0 render "$sea" --out a.mp4 $small --frames 2 --fps 10 --ride
        has a.mp4
    fi
    mkdir bin
    count=$((count + 1))
    what='seaway render without ffmpeg'
    PATH=$folder/bin "$seaway" render "$sea" --out b.mp4 $small --frames 2 >out 2>err
    [ $? -eq 1 ] || fail "$what: not exit code 1"
    err 'ffmpeg is not installed'
    hasnot 'b.mp4'
    what='seaway render to a full disk'
    (
        ulimit -f 1
        "$seaway" render "$sea" --out c.png $small --size 256x192 >out 2>err
    )
    [ $? -eq 1 ] || fail "$what: not exit code 1"
    err 'cannot write c.png'
    hasnot 'c.png'
    hasnot '.c.png*'
}

test_bench() {
    run 0 bench --cpu-only --json
    is_json out
    out '"machine":'
    out '"step_ms":'
    out '"heights_per_s":'
    needs_device
    run 0 bench --json --size 64x48
    is_json out
    out '"passes":'
}

test_view() {
    run 2 view "$sea" --screenshot a.png
    err '--frames'
    DISPLAY='' WAYLAND_DISPLAY='' "$seaway" view "$sea" --frames 1 >out 2>err
    [ $? -eq 1 ] || fail "a missing display is not exit code 1"
    what='seaway view without a display'
    [ "$(wc -l <err)" -eq 1 ] || fail "$what: not one sentence"
}

"test_$part"
echo "$part: $count runs, $failures failures"
[ "$failures" -eq 0 ]
