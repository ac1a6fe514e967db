#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `seaway view` on a screen without a monitor: thirty frames with the validation layers, a screenshot, a clean end; and
# one clear sentence with exit code 1 where display, device, scene or view is missing.
# Usage: view_in_xvfb.sh SEAWAY SCENE. Exit code 77: skipped.
set -u
seaway=$1
scene=$2
if ! command -v xvfb-run >/dev/null; then
    echo "skipped: xvfb-run was not found (Debian's package xvfb)"
    exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
# The software device's window code keeps 112 bytes when it is unloaded, which a leak checker cannot name any more.
export ASAN_OPTIONS="${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0"

fail() {
    echo "FAILED: $*"
    sed 's/^/    /' "$folder/stderr"
    failures=$((failures + 1))
}

# in_window SECONDS ARGUMENTS...: run the viewer on a screen of its own; its exit code is left in $code. xvfb-run has an
# exit code and words of its own when it cannot tidy up behind itself, so the viewer's are taken inside.
in_window() {
    code=124
    rm -f "$folder/code"
    timeout "$1" xvfb-run -a -e "$folder/xvfb" -s "-screen 0 1024x768x24" \
        sh -c '"$@" 2>"$0/stderr"; echo $? >"$0/code"' "$folder" "$seaway" view "${@:2}" 2>"$folder/noise"
    [ ! -s "$folder/code" ] || code=$(cat "$folder/code")
}

# Exit code 1, and a sentence on stderr that holds the pattern.
expect_refusal() {
    if [ "$code" -ne 1 ]; then
        fail "$1: exit code $code instead of 1"
    elif ! grep -qiE "$2" "$folder/stderr"; then
        fail "$1: stderr does not say '$2'"
    else
        echo "ok: $1: $(head -n 1 "$folder/stderr")"
    fi
}

picture=$folder/sea.png
in_window 500 "$scene" --device software --size 640x400 --frames 30 --validate --screenshot "$picture"
size=$(od -An -tu1 -j16 -N8 "$picture" 2>/dev/null | tr -s ' ')
bytes=$(stat -c %s "$picture" 2>/dev/null || echo 0)
if [ "$code" -ne 0 ] || [ -s "$folder/stderr" ]; then
    fail "thirty frames: exit code $code, or messages"
elif [ "$size" != " 0 0 2 128 0 0 1 144" ]; then
    fail "the screenshot is not 640 x 400:$size"
elif [ "$bytes" -lt 40000 ]; then
    fail "the screenshot has only $bytes bytes: too little for a sea"
else
    echo "ok: thirty frames and a screenshot of $bytes bytes, no message"
fi

in_window 500 "$scene" --device software --size 320x200 --frames 2 --screenshot "$folder/none/sea.png"
expect_refusal "a screenshot into no folder" "was not written"

cat >"$folder/hand.yaml" <<'SCENE'
waves:
  - components: [{wavelength_m: 60, amplitude_m: 0.5, direction_from_deg: 270}]
view: {slice_count: 2, resolution: 64}
SCENE
in_window 500 "$folder/hand.yaml" --device software --size 640x360 --frames 3 --validate --screenshot "$folder/hand.png"
if [ "$code" -ne 0 ] || [ -s "$folder/stderr" ]; then
    fail "waves by hand in the panel: exit code $code, or messages"
else
    echo "ok: waves by hand in the panel, and a clean end"
fi

ln -s /dev/full "$folder/full.png"
in_window 500 "$scene" --device software --size 320x200 --frames 2 --screenshot "$folder/full.png"
expect_refusal "a screenshot onto a full device" "was not written"
[ -L "$folder/full.png" ] && [ -c /dev/full ] || fail "a screenshot onto a full device: link or device is gone"

in_window 500 "$scene" --device software --size 640x360 --frames 3 --validate --debug slices --ui-scale 1.6 \
    --screenshot "$folder/slices.png"
if [ "$code" -ne 0 ] || [ -s "$folder/stderr" ] || [ ! -s "$folder/slices.png" ]; then
    fail "a debug view and a larger panel: exit code $code, or messages"
else
    echo "ok: a debug view and a larger panel"
fi

# Land that the scene's inputs say, and the layer that holds its depth.
cat >"$folder/sea.yaml" <<'SCENE'
view: {slice_count: 3, resolution: 64}
views: [{name: a, position_m: [0, 8, 40]}]
SCENE
cat "$folder/sea.yaml" - >"$folder/land.yaml" <<'SCENE'
inputs:
  - {field: floor, value: -20}
  - {field: floor, shape: circle, size_m: [60, 0, 60], feather_m: 25, value: 6}
SCENE
for name in sea land layer; do
    more=$([ $name = layer ] && echo --debug layer:places.depth)
    scene_file=$folder/$([ $name = sea ] && echo sea || echo land).yaml
    # shellcheck disable=SC2086 # an option and its value
    in_window 500 "$scene_file" --device software --size 320x200 --frames 3 --no-panel --validate $more \
        --screenshot "$folder/$name.png"
    if [ "$code" -ne 0 ] || [ -s "$folder/stderr" ] || [ ! -s "$folder/$name.png" ]; then
        fail "a picture of $name: exit code $code, or messages"
    fi
done
if cmp -s "$folder/sea.png" "$folder/land.png" || cmp -s "$folder/land.png" "$folder/layer.png"; then
    fail "land, or a layer, is not in the picture"
else
    echo "ok: land and a layer"
fi

in_window 60 "$folder/none.yaml" --device software --frames 1
expect_refusal "no such scene" "none.yaml"

in_window 60 "$scene" --device software --frames 1 --view nowhere
expect_refusal "no such view" "nowhere"

# Names reach the terminal as text.
escape=$(printf '\033')
for arguments in "$folder/a${escape}[31mb.yaml" "$scene --view ${escape}[31mb"; do
    # shellcheck disable=SC2086 # an option and its value
    in_window 60 $arguments --device software --frames 1
    expect_refusal "a control character" 'x1b\[31mb'
    ! grep -q "$escape" "$folder/stderr" || fail "a control character reached the terminal"
done

VK_ICD_FILENAMES=/dev/null VK_DRIVER_FILES=/dev/null in_window 60 "$scene" --frames 1
expect_refusal "no Vulkan device" "vulkan"

env -u DISPLAY -u WAYLAND_DISPLAY "$seaway" view "$scene" --frames 1 2>"$folder/stderr"
code=$?
expect_refusal "no display" "display"

exit $((failures > 0))
