#!/bin/sh
# SPDX-License-Identifier: MIT
# `seaway spectrum`: measured seas, printed, listed and drawn.
# Usage: test_spectrum.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

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
run 2 spectrum "$buoy" --at '2031-01-01 00:00'
err 'which run from 2024-11-16 04:50 to 2024-11-16 06:50 (UTC)'
run 0 spectrum "$buoy" --at '2024-11-16 07:10'
err 'warning: .*outside its records; the nearest record, of 2024-11-16 06:50'
run 1 spectrum "$buoy" --directions to
err 'laid down by its format'
run 2 spectrum "$buoy" --directions up
# netCDF whose directions have no label: read, with a warning, and the assumption is seen.
unlabelled="$source/tests/fuzz/seeds/netcdf/unlabelled.nc"
if "$seaway" spectrum "$unlabelled" 2>&1 | grep -q 'built without NetCDF'; then
    echo "netCDF is not read: its directions are not tested"
else
    run 0 spectrum "$unlabelled" --json
    err 'warning: .*unlabelled.nc: it does not say .*--directions from or to'
    is_json out
    out '"directions": "from"'
    out '"directions_assumed": true'
    out '"directions_known_by": "wavespectra"'
    run 0 spectrum "$unlabelled" --directions to --json
    out '"directions": "to"'
    out '"directions_assumed": false'
    [ -s err ] && fail "what is asked for needs no warning"
    run 2 spectrum "$unlabelled" --directions from --at 2021-01-01
    err 'run from 2020-01-01 00:00 to 2020-01-01 00:00'
fi
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
run 0 spectrum swan.spec --latitude 52.11 --longitude 4.61 --json
is_json out
out '"location": 2'
out '"distance_km": 1.3'
out '"directions": "by_format"'
out '"directions_assumed": false'
run 0 spectrum swan.spec --latitude=52.11 --longitude=4.61
out 'km from the point that was asked for'
run 2 spectrum swan.spec --latitude -52 --longitude 4.6
err 'km away; at most 100 km are bridged'
run 2 spectrum swan.spec --latitude 52
err 'give both'
run 2 spectrum swan.spec --latitude 52 --longitude 4.6 --location 1
err 'keep one of them'
run 1 spectrum "$buoy" --plot nosuch/plot.svg
err 'its folder does not exist'
run 2 spectrum "$buoy" --list --at 2024-11-16T06:50Z
err '--list has no effect with --at'
run 2 spectrum "$buoy" --list --plot plot.svg
err '--list has no effect with --plot'

# What was not measured is null, or said in words.
printf '#YY MM DD hh mm Sep_Freq < spec_1 (freq_1) ... >\n2022 01 01 00 00 9.999 0.2 (0.070) 1.0 (0.080) 0.2 (0.090)\n' >alone.data_spec
run 0 spectrum alone.data_spec --json
out '"has_directions": false' && out '"mean_direction_from_deg": null' && out '"peak_direction_from_deg": null'
out '"spread_deg": null' && out '"peak_r1": null' && out '"peak_spread_deg": null'
out '"direction_from_deg": \[ null, null, null\]' && out '"r1": \[ null, null, null\]'
err 'has no file of directions'
is_json out
run 0 spectrum alone.data_spec --list --json
out '"has_directions": false' && out '"mean_direction_from_deg": null' && out '"spread_deg": null'
run 0 spectrum alone.data_spec
out 'from   not measured' && out 'spread not measured'
run 0 spectrum alone.data_spec --list
out '2022-01-01 00:00 .* -$'
run 0 spectrum "$buoy" --json
out '"has_directions": true' && out '"density_m2_per_hz": \[' && out '"direction_from_deg": \[' && out '"r1": \['
out '"directional_spread_deg": \[' && out '"peak_r1": 0' && out '"peak_spread_deg": [1-9]' && out '"peak_frequency_hz": 0'
# A gap in the directions stays one.
printf '#YY MM DD hh mm alpha1_1 (freq_1) ... >\n2022 01 01 00 00 90 (0.070) 999.0 (0.080) 100 (0.090)\n' >alone.swdir
run 0 spectrum alone.data_spec --json
out '"direction_from_deg": \[ 90, null, 100\]' && out '"r1": \[ null, null, null\]'
out '"mean_direction_from_deg": [0-9]' && out '"spread_deg": null'
run 0 spectrum alone.data_spec
out 'spread not measured; one was assumed'
run 1 spectrum alone.swdir
err 'not energies: name the file of energies, alone.data_spec'
# Energies that are all missing.
printf '2022 01 01 00 00 9.999 0.2 (0.070) 1.0 (0.080)\n2022 01 01 01 00 9.999 999 (0.070) MM (0.080)\n' >gap.data_spec
run 0 spectrum gap.data_spec --list
err '1 of 2 records have no energies'
# A scene of a sea without directions says so.
rm alone.swdir
printf 'waves:\n  - spectrum: file\n    file: alone.data_spec\n' >alone.yaml
"$seaway" check alone.yaml >out 2>err
out 'has no directions: its waves are made around east'
# Negative densities: each frequency keeps its energy, and how much there was is told.
printf 'SWAN 1\nLOCATIONS\n1\n0 0\nAFREQ\n2\n0.1\n0.2\nNDIR\n4\n0\n90\n180\n270\nQUANT\n1\nVaDens\nm2/Hz/degr\n-99\n' >negative.spc
printf 'FACTOR\n0.001\n 10 -4 3 7\n 0 5 -99 -1\n' >>negative.spc
run 0 spectrum negative.spc
out '2 densities were negative, 25 % of the energy'
err 'warning: .*1 of 1 records hold negative densities'
run 0 spectrum negative.spc --json
is_json out
out '"negative_count": 2' && out '"added_fraction": 0'
# A calm has no periods and no directions.
printf 'time,hs_m,tp_s\n2022-01-01,0,0\n' >calm.csv
run 0 spectrum calm.csv --json
out '"hs_m": 0' && out '"tp_s": null' && out '"mean_direction_from_deg": null'

finish
