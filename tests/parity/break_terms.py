#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Shows that parity_everything can fail: takes each feature's term out of the core, builds, and expects a failure.

    tests/parity/break_terms.py BUILD [NAME...]

BUILD is a build folder. The GPU's half stays as it is, so the two halves must differ. Sources are put back after each
break, also when the script is interrupted. With names, only those breaks are made.
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLACES = "src/core/surface/input_places.c"
SHAPED = "src/core/surface/evaluate_shaped.c"
BLOCK = "src/core/surface/places.c"
CARRY = "src/core/surface/carry.c"
DISPLACED = "src/core/input/sample_inputs.c"
HEIGHTS = "src/core/surface/displace.c"

# Name, feature of parity_everything, file, text, and what stands there instead.
BREAKS = [
    ("depth", "depth", PLACES, "places->depth = hasFloor ? findDepth : NULL;", "places->depth = NULL;"),
    ("slope of the depth", "depth", BLOCK, "slope * block->depthGradients[i][0]", "0.0f * block->depthGradients[i][0]"),
    ("level under depths", "level, tide, dam", PLACES, "bool hasLevel = swHasInputs(set, SW_INPUT_LEVEL);",
     "bool hasLevel = false;"),
    ("level", "level, tide, dam", PLACES, "places->level = swHasInputs(set, SW_INPUT_LEVEL) ? findLevel : NULL;",
     "places->level = NULL;"),
    ("slope of the level", "level, tide, dam", BLOCK, "g[4] += slopes[i][0] * (1.0f + g[0])", "g[4] += 0.0f * g[0]"),
    ("bed and level of a river", "river", PLACES, "places->depth = hasFloor ? findDepth : NULL;", "places->depth = NULL;"),
    ("weights of systems", "regions of waves", PLACES,
     "places->weight = swHasInputs(set, SW_INPUT_WAVES) ? findWeight : NULL;", "places->weight = NULL;"),
    ("slope of weights", "regions of waves", BLOCK, "copy->alongX[i] = isWeighted ? block->weightGradients[i][0] : 0.0f;",
     "copy->alongX[i] = 0.0f;"),
    ("slope of weights along z", "regions of waves", BLOCK,
     "copy->alongZ[i] = isWeighted ? block->weightGradients[i][1] : 0.0f;", "copy->alongZ[i] = 0.0f;"),
    ("waves along splines", "waves along splines", PLACES,
     "places->warps = set->ribbonSystems != 0 ? findWarps : NULL;", "places->warps = NULL;"),
    ("turn of sideways motion", "waves along splines", SHAPED, "float c = warp->cosine, s = warp->sine;",
     "float c = 1.0f, s = 0.0f;"),
    ("turn from place to place", "waves along splines", SHAPED, "own->alongZ[z] = zz + warp->turnZ * valueX;",
     "own->alongZ[z] = zz;"),
    ("slopes of a ribbon's coordinates", "waves along splines", SHAPED, "chain(copy->way[i], own);", "(void)chain;"),
    ("slope of a ribbon's weight", "waves along splines", BLOCK, "copy->alongX[i] = block->isAsked[i] ? warps[i].alongX : 0.0f;",
     "copy->alongX[i] = 0.0f;"),
    ("flow", "flow", PLACES, "places->flow = places->water != NULL && set->hasOtherFlows ? findFlow : NULL;",
     "places->flow = NULL;"),
    ("even flow beside others", "flow", PLACES, "velocities[i][0] = swGetCarriedSpeed(velocities[i][0], set->evenX);",
     "(void)set;"),
    ("likeness of carried copies", "flow", CARRY, "rho[first + i] = sums[i].value[1] + sums[i].value[5];",
     "rho[first + i] = 0.0f;"),
    ("slopes of carried copies", "flow", CARRY, "first->way[i][g] = way - seconds[0] * gradient;",
     "first->way[i][g] = way;"),
    ("way of carried copies", "flow", CARRY, "first->source[i].x = source.x - (double)(seconds[0] * v[0]);",
     "first->source[i].x = source.x;"),
    ("slope of their likeness", "flow", CARRY,
     "float factorX = slope * (likeness->alongX[i] * g[0] + likeness->alongZ[i] * g[2]);",
     "float factorX = 0.0f;"),
    ("flow in a ribbon's axes", "all", CARRY, "velocity[0] = c * u[0] + s * u[1];", "velocity[0] = u[0];"),
    ("flow in velocities", "flow", BLOCK, "velocities[first + i][0] += flow[i][0];", "(void)flow;"),
    ("displacement with the waves", "displacement", DISPLACED, "    *waves = displaced.waves;", "    (void)waves;"),
    ("displacement of heights", "displacement", DISPLACED, "    *height = displaced.height;", "    (void)height;"),
    ("slopes of displacement", "displacement", HEIGHTS, "putWaves(&waves, out->displacement[i], g);",
     "putWaves(&waves, out->displacement[i], NULL);"),
    ("slopes of displaced heights", "displacement", HEIGHTS, "g[4] += alongX * (1.0f + g[0]) + alongZ * g[2];",
     "(void)alongZ;"),
    ("scale of velocities", "displacement", HEIGHTS, "putWaves(&waves, rates[i], NULL);", "(void)waves;"),
    ("holes", "holes", "src/core/input/sample_clip.c", "if (!swHasInputs(set, SW_INPUT_CLIP))", "if (true)"),
    ("levels of bodies", "bodies of water", PLACES, "places->level = swHasInputs(set, SW_INPUT_LEVEL) ? findLevel : NULL;",
     "places->level = NULL;"),
    ("waves of bodies", "bodies of water", PLACES,
     "places->weight = swHasInputs(set, SW_INPUT_WAVES) ? findWeight : NULL;", "places->weight = NULL;"),
    ("floors of other shapes", "floors of all shapes", PLACES, "places->depth = hasFloor ? findDepth : NULL;",
     "places->depth = NULL;"),
]


def run(command):
    return subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def try_break(build, name, feature, path, text, instead):
    """Returns whether the test failed with the break."""
    file = ROOT / path
    before = file.read_text()
    if before.count(text) != 1:
        print(f"{name}: '{text}' is not once in {path}: mend this script")
        return False
    try:
        file.write_text(before.replace(text, instead))
        made = run(["cmake", "--build", build, "--target", "parity_everything"])
        if made.returncode != 0:
            print(f"{name}: does not build\n{made.stdout[-2000:]}")
            return False
        tried = run([f"{build}/bin/parity_everything", "200", feature, "queries"])
        why = [line.strip() for line in tried.stdout.splitlines() if "FAILED" in line]
        print(f"{name}: {'found: ' + why[0] if why else 'NOT FOUND'}", flush=True)
        return tried.returncode == 1 and bool(why)
    finally:
        file.write_text(before)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    names = sys.argv[2:]
    chosen = [row for row in BREAKS if not names or row[0] in names]
    missed = sum(not try_break(sys.argv[1], *row) for row in chosen)
    run(["cmake", "--build", sys.argv[1], "--target", "parity_everything"])
    print(f"{len(chosen) - missed} of {len(chosen)} breaks were found")
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
