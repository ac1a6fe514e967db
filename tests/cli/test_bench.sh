#!/bin/sh
# SPDX-License-Identifier: MIT
# `seaway bench`.
# Usage: test_bench.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

run 0 bench --cpu-only --json
is_json out
out '"machine":'
out '"step_ms":'
out '"heights_per_s":'
run 2 bench --cpu-only --size 64x48
err '--cpu-only has no effect with --size'
run 2 bench --cpu-only --device 0
needs_device
run 0 bench --json --size 64x48
is_json out
out '"passes":'

finish
