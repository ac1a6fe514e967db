#!/bin/sh
# SPDX-License-Identifier: MIT
# What every verb says of itself, and arguments that are wrong.
# Usage: test_usage.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

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

finish
