#!/bin/sh
# SPDX-License-Identifier: MIT
# `seaway check`: mistakes in scene files.
# Usage: test_check.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

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

finish
