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

# Every debug mode that a verb takes stands in its help.
for verb in view render; do
    "$seaway" $verb --help >help
    "$seaway" $verb "$sea" --debug qqqqqqqqqqqq 2>modes
    what="seaway $verb --debug"
    modes=$(sed -n 's/.*is one of none, \(.*\), not .*/\1/p' modes | tr -d ',')
    [ -n "$modes" ] || fail "$what: the modes were not listed: $(cat modes)"
    for mode in $modes; do
        grep -q "[^a-z]$mode[^a-z]" help || fail "$what: $mode is not in the help"
    done
done

run 2 view "$sea" --ui-scale 9
err 'ui-scale'

finish
