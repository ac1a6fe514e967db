# SPDX-License-Identifier: MIT
# What the tests of the program share: run it as a user would, and check exit code, standard output and messages.
# Read by test_X.sh PROGRAM SOURCE_FOLDER, which ends with `finish`.
set -u
seaway=$1
source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0
count=0
what=nothing
sea=$source/scenes/open_sea.yaml
buoy=$source/scenes/data/harbour_storm.data_spec

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

finish() {
    echo "${0##*/}: $count runs, $failures failures"
    [ "$failures" -eq 0 ]
    exit
}
