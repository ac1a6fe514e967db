#!/bin/sh
# SPDX-License-Identifier: MIT
# `seaway view` without a display; tests/viewer shows it a screen.
# Usage: test_view.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

run 2 view "$sea" --screenshot a.png
err '--frames'
DISPLAY='' WAYLAND_DISPLAY='' "$seaway" view "$sea" --frames 1 >out 2>err
[ $? -eq 1 ] || fail "a missing display is not exit code 1"
what='seaway view without a display'
[ "$(wc -l <err)" -eq 1 ] || fail "$what: not one sentence"

finish
