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
hasnot '.*.part'
# What would do nothing is refused.
run 2 render "$sea" --out a.png --ease
err '--ease has no effect without --to-view'
run 2 render "$sea" --out a.png --frame-format exr
err 'without a folder'
run 2 render "$sea" --out a.png --exr-float
err 'without .exr'
run 2 render "$sea" --out a.exr --exposure 1
err 'before exposure'
run 2 render "$sea" --out a.png --exposure 1 --debug height
err 'no effect with --debug'
# Layers: names, slices and ranges.
run 2 render "$sea" --out a.png --debug layer:depth
err 'there is no layer "depth"; the layers are places, '
run 2 render "$sea" --out a.png --debug layer
err 'did you mean layer:NAME'
run 2 render "$sea" --out a.png --debug layer:
err 'the layers are places'
run 2 render "$sea" --out a.png --debug layer:displacement.w
err 'it has x, y, z'
run 2 render "$sea" --out a.png --debug layer:foam:15
err 'is no slice'
run 2 render "$sea" --out a.png --layer-range 0:1
err 'no effect without --debug'
run 2 render "$sea" --out a.png --debug height --layer-range 0:1
err 'no effect without --debug layer'
run 2 render "$sea" --out a.png --debug layer:foam --layer-range 1:0
err 'the lower first'
run 2 render "$sea" --out a.png --debug layer:foam --samples 4
err 'no effect on a layer'
run 2 render "$sea" --out a.png --debug layer:foam --exposure 1
err 'no effect with --debug'
# Lines over the picture.
run 2 render "$sea" --out a.png --show rays
err 'a list of queries, ray, tiles and inputs'
run 2 render "$sea" --out a.exr --show ray
err 'no effect on .exr'
run 2 render "$sea" --out a.png --show ray --debug layer:foam
err 'no effect on a layer'
run 2 render "$sea" --out a.png --fps 10
err 'on a single picture'
run 2 render "$sea" --out a.png --fps 10 --fps 20
err 'given twice'
run 2 render "$sea" --out a.png --time 1e12
err 'outside its range'
run 2 render "$sea" --out a.png --time 2.7e11 --warmup 10
err 'the largest of a sea'
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
# A layer: a pixel for each texel, its range as it is or as it was asked for, and EXR with the numbers themselves.
run 0 render "$sea" --out layer.png --warmup 0 --debug layer:displacement:1 --validate
out '^displacement.y at 0 s: slice 1 of .* least -[0-9.]*, greatest [0-9.]*, shown from -'
side=$(sed -n 's/.* of \([0-9]*\) x .*/\1/p' out)
[ "$(od -An -tu1 -j16 -N8 layer.png | awk '{print 256 * $3 + $4, 256 * $7 + $8}')" = "$side $((side + 20))" ] ||
    fail "$what: not $side pixels wide"
run 0 render "$sea" --out layer.png --warmup 0 --debug layer:displacement:1 --layer-range -9:9
out 'shown from -9 to 9'
run 0 render "$sea" --out layers.exr --exr-float --warmup 0 --debug layer:places
out 'slices 0 to .* least nan, greatest nan, .* texels hold nothing'
run 1 render "$sea" --out other.png --warmup 0 --debug layer:foam:14
err 'There is no slice 14'
hasnot 'other.png'
for marks in queries ray tiles queries,ray,tiles,inputs; do
    run 0 render "$sea" --out marks.png $small --show $marks --validate
    ! cmp -s a.png marks.png || fail "$what: there are no lines"
done
# Unix times a hundredth of a second apart are two seas.
run 0 render "$sea" --out a.png --size 64x48 --warmup 0 --time 1700000000.01
run 0 render "$sea" --out b.png --size 64x48 --warmup 0 --time 1700000000.51
! cmp -s a.png b.png || fail "$what: half a second changes nothing"
mkdir there
ln -s there/real.png link.png
run 0 render "$sea" --out link.png --size 64x48 --warmup 0
[ -L link.png ] || fail "$what: the link was replaced"
has there/real.png
run 0 render "$sea" --out /dev/null --size 64x48 --warmup 0
[ -c /dev/null ] || fail "$what: /dev/null is no device any more"
if command -v ffmpeg >/dev/null; then
    run 0 render "$sea" --out a.mp4 $small --frames 2 --fps 10 --ride
    has a.mp4
    mkdir pipe:1
    run 0 render "$sea" --out pipe:1/a.mp4 --size 64x48 --frames 2 --warmup 0
    has pipe:1/a.mp4
    # Full at any place: in the frames, in the index at the end, while the index moves to the front.
    size=$(($(wc -c <a.mp4) / 512))
    for blocks in 1 $((size / 2)) $((size - 1)) "$size"; do
        count=$((count + 1))
        what="seaway render of a video to a disk of $blocks blocks"
        (
            ulimit -f "$blocks"
            "$seaway" render "$sea" --out full.mp4 $small --frames 2 --fps 10 --ride >out 2>err
        )
        [ $? -eq 1 ] || fail "$what: not exit code 1"
        err 'cannot write full.mp4: ffmpeg failed'
        hasnot full.mp4
        hasnot '.*.part'
    done
    what='seaway render of a video, interrupted'
    count=$((count + 1))
    "$seaway" render "$sea" --out cut.mp4 --size 64x48 --frames 100000 --warmup 0 >out 2>err &
    process=$!
    tries=0
    while [ ! -e ".seaway.$process.part" ] && [ "$tries" -lt 100 ]; do
        sleep 0.1
        tries=$((tries + 1))
    done
    sleep 1
    kill -s HUP "$process"
    wait "$process" 2>/dev/null
    sleep 0.5
    hasnot cut.mp4
    hasnot '.*.part'
fi
mkdir bin
count=$((count + 1))
what='seaway render without ffmpeg'
PATH=$folder/bin "$seaway" render "$sea" --out b.mp4 $small --frames 2 >out 2>err
[ $? -eq 1 ] || fail "$what: not exit code 1"
err 'ffmpeg is not installed'
PATH=$folder/bin "$seaway" render "$sea" --out b.mp4 --frames 2 --warmup 600 --device 63 >out 2>err
err 'ffmpeg is not installed' # before the sea is made, and before the device is looked for
hasnot 'b.mp4'
what='seaway render to a full disk'
(
    ulimit -f 1
    "$seaway" render "$sea" --out c.png --size 256x192 --warmup 0.1 >out 2>err
)
[ $? -eq 1 ] || fail "$what: not exit code 1"
err 'cannot write c.png'
hasnot 'c.png'
hasnot '.*.part'

finish
