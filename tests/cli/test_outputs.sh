#!/bin/sh
# SPDX-License-Identifier: MIT
# Whatever is written: devices, FIFOs and links stay what they are, nothing half written is left, and what cannot be written
# is said before the work.
# Usage: test_outputs.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

hand=$folder/hand.yaml
cat >"$hand" <<'END'
waves:
  - components: [{wavelength_m: 60, amplitude_m: 0.4, direction_from_deg: 270}]
views:
  - name: deck
    position_m: [0, 3, 0]
END
fast='--seeds 1 --duration 10'
# Temporary files of its own: other tests run beside this one, and theirs come and go.
TMPDIR=$folder/temporary
export TMPDIR
mkdir "$TMPDIR"
is_svg() { grep -q '</svg>' "$1" || fail "$what: $1 is no picture"; }
no_parts() {
    [ -z "$(find "$folder" -name '.seaway.*.part')" ] ||
        fail "$what: a temporary file was left behind"
}

# A device, a FIFO and standard output are written into.
run 0 stats "$hand" $fast --plot /dev/null
[ -c /dev/null ] || fail "$what: /dev/null is no device any more"
mkfifo pipe.svg
cat pipe.svg >read.svg &
reader=$!
run 0 stats "$hand" $fast --plot pipe.svg
wait "$reader"
[ -p pipe.svg ] || fail "$what: the FIFO is none any more"
is_svg read.svg
run 0 stats "$hand" $fast --plot /dev/stdout
out '^Hs '
is_svg out
count=$((count + 1))
what='seaway stats --plot /dev/stdout to a pipe'
"$seaway" stats "$hand" $fast --plot /dev/stdout 2>err | cat >out
is_svg out
if [ -e /dev/full ]; then
    run 1 stats "$hand" $fast --plot /dev/full
    err 'cannot write /dev/full: No space left on device'
fi
no_parts

# Links are followed: to a file, to what is not there yet, from folder to folder, in a circle.
mkdir there
echo old >there/real.svg
chmod 640 there/real.svg
ln -s there/real.svg link.svg
ln -s link.svg second.svg
run 0 stats "$hand" $fast --plot second.svg
[ -L second.svg ] && [ -L link.svg ] || fail "$what: a link was replaced"
is_svg there/real.svg
[ "$(ls -l there/real.svg | cut -c1-10)" = '-rw-r-----' ] || fail "$what: the file's mode changed"
ln -s there/new.svg dangling.svg
run 0 stats "$hand" $fast --plot dangling.svg
[ -L dangling.svg ] || fail "$what: the link was replaced"
is_svg there/new.svg
ln -s circle.svg circle.svg
run 1 stats "$hand" $fast --plot circle.svg
err 'cannot write circle.svg: '
no_parts

# What cannot be written is said before the work, with the reason.
for verb in stats spectrum; do
    input=$hand
    [ "$verb" = stats ] || input=$buoy
    run 1 "$verb" "$input" --plot nosuch/plot.svg
    err 'its folder does not exist'
    [ ! -s out ] || fail "$what: worked before it looked"
    run 1 "$verb" "$input" --plot "$hand/plot.svg"
    err 'Not a directory'
    mkdir -p folder.svg
    run 1 "$verb" "$input" --plot folder.svg
    err 'it is a folder'
    if [ -d /proc/self ]; then
        run 1 "$verb" "$input" --plot /proc/a.svg
        err 'cannot write /proc/a.svg: its folder takes no new file'
    fi
    run 2 "$verb" "$input" --plot plot.png
    err '--plot writes .svg, and "plot.png" is named otherwise'
    run 2 "$verb" "$input" --plot -
    err 'standard output is /dev/stdout'
    run 2 "$verb" "$input" --plot --json
    err '"--json" looks like an option'
    run 2 "$verb" "$input" --plot ''
    err 'not an empty one'
    long=$(printf '%05000d' 0)
    run 2 "$verb" "$input" --plot "$long.svg"
    err 'has a path of 5004 bytes'
    run 1 "$verb" "$input" --plot "$(printf '%0300d' 0).svg"
    err 'File name too long'
done
run 2 render "$sea" --out -
run 2 render "$sea" --out --help
err 'looks like an option'
run 2 render "$sea" --out ''
run 2 render "$sea" --out "$long"
[ ! -e ./- ] && [ ! -e ./--help ] || fail "render made a folder"
if [ -d /proc/self ]; then
    run 1 render "$sea" --out /proc/a.png
    err 'its folder takes no new file'
    run 1 render "$sea" --out /proc/frames/
    err 'takes no other'
fi
run 1 render "$sea" --out nosuch/frames
err 'cannot make the folder nosuch/frames: the folder that it would be in does not exist'
run 1 render "$sea" --out "$hand/"
err 'a file has that name'
run 2 view "$sea" --frames 1 --screenshot s.jpg
err '--screenshot writes .png'
# Long paths work as far as the system takes them.
deep=.
while [ "${#deep}" -lt 1500 ]; do deep=$deep/$(printf '%0100d' 0); done
mkdir -p "$deep"
cp "$hand" "$deep/hand.yaml"
cp "$buoy" "$deep/storm.data_spec"
printf 'waves:\n  - {spectrum: file, file: storm.data_spec}\n' >"$deep/measured.yaml"
run 0 stats "$deep/hand.yaml" $fast --plot "$deep/plot.svg"
is_svg "$deep/plot.svg"
run 0 spectrum "$deep/storm.data_spec" --list
printf '0,0\n' >"$deep/points.csv"
run 0 query "$deep/measured.yaml" --points "$deep/points.csv"

# Control characters of names and of what stands in files do not reach the terminal.
escape=$(printf 'a\033[31mb')
for verb in check stats query; do
    "$seaway" "$verb" "$escape.yaml" >out 2>err </dev/null
    ! LC_ALL=C grep -q "$(printf '\033')" out err || fail "seaway $verb: a control character got through"
done
cp "$buoy" "$escape.data_spec"
printf '\033]0;x\a,1\n' >control.csv
printf '"\\e[31mb": 1\n' >control.yaml
for command in 'check control.yaml' "spectrum $escape.data_spec" "render $hand --view $escape --out a.png" "$escape"; do
    "$seaway" $command >out 2>err </dev/null
    what="seaway $command"
    ! LC_ALL=C grep -q "$(printf '[\033\a]')" out err || fail "$what: a control character got through"
    cat out err | grep -q 'x1b' || fail "$what: does not show the character"
done
run 1 query "$hand" --points control.csv
! LC_ALL=C grep -q "$(printf '[\033\a]')" err || fail "$what: a control character got through"
run 0 spectrum "$escape.data_spec" --json
is_json out
cp "$buoy" "$(printf 'no\377utf8.data_spec')"
run 0 spectrum "$(printf 'no\377utf8.data_spec')" --json
is_json out

# An interrupt leaves nothing behind, whichever it is.
for signal in HUP INT TERM QUIT; do
    rm -f plot.svg
    mkfifo "slow$signal.svg"
    what="seaway stats with SIG$signal"
    count=$((count + 1))
    # It waits for a reader that never comes, with the finished picture beside it.
    "$seaway" stats "$hand" $fast --plot "slow$signal.svg" >out 2>err &
    process=$!
    tries=0
    while [ ! -s "$TMPDIR/.seaway.$process.part" ] && [ "$tries" -lt 200 ]; do
        sleep 0.1
        tries=$((tries + 1))
    done
    [ "$tries" -lt 200 ] || fail "$what: no temporary file came"
    sleep 0.2
    kill -s "$signal" "$process"
    # The shell lets what runs in its background ignore SIGINT and SIGQUIT: then another ends it.
    sleep 0.3
    kill -s TERM "$process" 2>/dev/null
    wait "$process" 2>/dev/null
    [ ! -e "$TMPDIR/.seaway.$process.part" ] || fail "$what: the temporary file was left"
done
no_parts

finish
