#!/bin/sh
# SPDX-License-Identifier: MIT
# `seaway devices`.
# Usage: test_devices.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

needs_device
run 0 devices
run 0 devices --json
is_json out
out '"usable": true'

finish
