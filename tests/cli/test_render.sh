#!/bin/sh
# SPDX-License-Identifier: MIT
# `seaway render`: pictures, frames and video.
# Usage: test_render.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

run 2 render "$sea"
err '--out is missing'
run 2 render "$sea" --out a.jpg
err 'none of .png, .exr and .mp4'
run 2 render "$sea" --out a.png --size 64
err 'a width and a height'
run 2 render "$sea" --out a.png --frames 3
run 2 render "$sea" --out a.mp4 --size 65x64
err 'even width'
run 2 render "$sea" --out a.png --samples 3
run 2 render "$sea" --out a.png --debug slises
err 'did you mean slices'
run 2 render "$sea" --out a.png --device fast
run 1 render "$sea" --out nosuch/a.png
err 'its folder does not exist'
run 1 render "$sea" --out nosuch/frames/
err 'cannot make the folder'
run 1 render "$sea" --out a.png --view nosuch
err 'has no view "nosuch"'
run 1 render nosuch.yaml --out a.png
hasnot 'a.png*'
hasnot '.a.png*'
needs_device
small='--size 64x48 --warmup 0.1'
run 1 render "$sea" --out a.png $small --device 63
hasnot 'a.png'
run 0 render "$sea" --out a.png $small --validate
has a.png
run 0 render "$sea" --out a.exr $small --samples 4 --debug height
has a.exr
run 0 render "$sea" --out frames $small --frames 2
has frames/frame_00000.png
has frames/frame_00001.png
if command -v ffmpeg >/dev/null; then
    run 0 render "$sea" --out a.mp4 $small --frames 2 --fps 10 --ride
    has a.mp4
fi
mkdir bin
count=$((count + 1))
what='seaway render without ffmpeg'
PATH=$folder/bin "$seaway" render "$sea" --out b.mp4 $small --frames 2 >out 2>err
[ $? -eq 1 ] || fail "$what: not exit code 1"
err 'ffmpeg is not installed'
hasnot 'b.mp4'
what='seaway render to a full disk'
(
    ulimit -f 1
    "$seaway" render "$sea" --out c.png $small --size 256x192 >out 2>err
)
[ $? -eq 1 ] || fail "$what: not exit code 1"
err 'cannot write c.png'
hasnot 'c.png'
hasnot '.c.png*'

finish
