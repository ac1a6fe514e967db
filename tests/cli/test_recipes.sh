#!/bin/sh
# SPDX-License-Identifier: MIT
# docs/recipes.md: every scene on the page is one, and the water in it is what the page says.
# Usage: test_recipes.sh PROGRAM SOURCE_FOLDER. Exit code 77: skipped.
. "$(dirname "$0")/support.sh"

# Scenes become N.yaml with a view, files of the page stand beside them, and questions become lines of N.asks:
# FIELD X Z LEAST MOST.
awk '
    /^<!-- file / { file = $3 }
    /^<!-- ask /  { print $3, $5, $6, $8, $10 > (scene ".asks") }
    /^```/ {
        if (inside) { inside = 0; if (target ~ /yaml$/) print "views: [{name: a, position_m: [0, 90, 0]}]" > target; close(target); file = "" }
        else if ($0 == "```yaml") { inside = 1; scene += 1; target = scene ".yaml" }
        else if ($0 == "```" && file != "") { inside = 1; target = file }
        else { inside = 1; target = "/dev/null" }
        next
    }
    inside { print > target }
' "$source/docs/recipes.md"
scenes=0
asked=0
for scene in *.yaml; do
    scenes=$((scenes + 1))
    run 0 check "$scene"
    out 'fine'
    [ -f "${scene%.yaml}.asks" ] || continue
    while read -r field x z least most; do
        asked=$((asked + 1))
        printf '%s,%s\n' "$x" "$z" >points.csv
        run 0 query "$scene" --points points.csv --fields "$field"
        # The first number of the field, behind time and place.
        awk -F, -v least="$least" -v most="$most" 'NR == 2 { exit !($4 + 0 >= least + 0 && $4 + 0 <= most + 0) }' out ||
            fail "$what, $field at $x $z: not from $least to $most"
    done <"${scene%.yaml}.asks"
done
[ "$scenes" -ge 9 ] || fail "only $scenes scenes were found on the page"
[ "$asked" -ge 12 ] || fail "only $asked questions were found on the page"

finish
