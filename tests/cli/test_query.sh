#!/bin/sh
# SPDX-License-Identifier: MIT
# `seaway query`: points, rays and maps, of both backends.
# Usage: test_query.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

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
# A place that is not known spoils no other, whoever answers.
printf '0,0\nnan,7\n10.5,-3\n' >unknown.csv
for backend in cpu gpu; do
    run 0 query "$sea" --points unknown.csv --time 3 --backend "$backend"
    err 'warning: unknown.csv: 1 of 3 points have a "nan"'
    out '^3,nan,7,nan,'
    sed '3d' out >others
    run 0 query "$sea" --points points.csv --time 3 --backend "$backend"
    cmp -s out others || fail "$backend: one bad point changes the others"
done
printf '\357\273\277x,z\n0,0\n10.5,-3\n' >bom.csv
run 0 query "$sea" --points bom.csv --time 3
cmp -s out first || fail "a byte order mark gives other answers"
printf 'x,z,x\n1,2,3\n' >twice.csv
run 1 query "$sea" --points twice.csv
err 'twice.csv:1: the header names several columns x'
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
run 1 query missing.yaml # before anything is read from standard input
err 'missing.yaml'
mkfifo endless
count=$((count + 1))
what='seaway query of a missing scene, with nobody who types points'
(exec 3<>endless && timeout 20 "$seaway" query missing.yaml <&3 >out 2>err)
[ $? -eq 1 ] || fail "$what: does not leave with exit code 1"
run 2 query "$sea" --time 1:0:1
run 2 query "$sea" --time 1e12
err 'goes beyond 2.7e+11 s, the largest time'
run 2 query "$sea" --time 0:1e12:1e12
err 'goes beyond'
run 2 query "$sea" --time=-1e12:0:1e12
err 'goes beyond'
run 2 query "$sea" --time 1e11:1.0000000001e11:1e-6
err 'lost in times so large'
run 0 query "$sea" --points points.csv --time 1700000000:1700000000.05:0.01
[ "$(cut -d, -f1 out | sort -u | wc -l)" -eq 7 ] || fail "Unix times 0.01 s apart look equal"
out '^1700000000.05,'
run 0 query "$sea" --points points.csv --time 0:0.5:0.1
out '^0.3,'
run 0 query "$sea" --points points.csv --time 12345678901.25
out '^12345678901.25,10.5,-3,'
printf '123456789.0123456,-0.1\n' >exact.csv
run 0 query "$sea" --points exact.csv --time 3
out '^3,123456789.0123456,-0.1,'
run 2 query "$sea" --points points.csv --device 0
err '--device has no effect without --backend gpu'
run 2 query "$sea" --points points.csv --device 0 --backend cpu
run 2 query "$sea" --points points.csv --stretching linear
err '--stretching has no effect without --below'
run 2 query "$sea" --points points.csv --particles --tolerance 0.1
err '--tolerance has no effect with --particles'
run 2 query "$sea" --time soon
err 'T or A:B:STEP'
run 0 query "$sea" --points points.csv --time 3 --backend gpu
paste -d, first out | awk -F, 'NR > 1 { for (i = 4; i <= 7; ++i) { d = $i - $(i + 12); if (d * d > 4e-6) exit 1 } }' ||
    fail "the GPU gives other answers"
[ "$(wc -l <out)" -eq 3 ] || fail "the GPU gives two points other than three lines"
run 0 query "$sea" --points points.csv --time 3 --motion --tolerance 1e-5
cp out first
run 0 query "$sea" --points points.csv --time 3 --motion --tolerance 1e-5 --backend gpu
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

# What inputs say at the points.
cat >inputs.yaml <<'SCENE'
waves: [{beaufort: 3}]
inputs:
  - {field: level, shape: circle, size_m: [20, 0, 20], value: 2, blend: replace}
  - {field: floor, value: -30}
  - {field: flow, value: [0.5, -1]}
SCENE
printf 'x,z\n0,0\n100,0\n' >fields.csv
run 0 query inputs.yaml --points fields.csv --fields depth,level,flow,body
out '^t_s,x_m,z_m,depth_m,level_m,flow_x_mps,flow_z_mps,body$'
out '^0,0,0,32,2,0.5,-1,-1$'
out '^0,100,0,30,0,0.5,-1,-1$'
run 2 query inputs.yaml --points fields.csv --fields depth,heat
err "no 'heat'"
run 2 query inputs.yaml --points fields.csv --fields depth,depth
err 'depth twice'
run 2 query inputs.yaml --points fields.csv --fields depth --below
err 'question of its own'

# Lines may end in CR alone.
printf 'x,z\n0,0\n10,5\n' >lf.csv
printf 'x,z\r0,0\r10,5\r' >cr.csv
printf '\357\273\277x,z\r\n0,0\r\n10,5' >crlf.csv
run 0 query "$sea" --points lf.csv
mv out wanted
for ends in cr crlf; do
    run 0 query "$sea" --points $ends.csv
    cmp -s out wanted || fail "$what: other answers than with LF"
done

finish
