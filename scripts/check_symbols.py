#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Hold the layers by symbols: what each object file leaves undefined must be defined in its own module or below it.

scripts/check_layers.py looks at includes. A function that is declared below and defined above is an inversion that
includes do not show; this shows it. Rules, each with a name that its messages carry:
  inversion  an object of src/<half>/<module> uses a symbol that a higher module, or one beside it, defines
  seam       an object of src/gpu uses a symbol of the core that is neither public nor declared in the seam
  circle     files of one module use each other round about

Usage: scripts/check_symbols.py BUILD      the folder of a static build
"""
import os
import re
import subprocess
import sys

from check_layers import COMPANIONS, CORE, GPU, SEAM

# Folders in which no circle of files is left. Others may have one where two files are one idea.
NO_CIRCLES = ("core/world", "core/spectra", "cli", "viewer/panels")


def list_sources(root):
    """Base name of every source, to its path from src/ or from the root for programs."""
    sources = {}
    for folder in ("src", "cli", "viewer"):
        for place, _, names in os.walk(os.path.join(root, folder)):
            for name in names:
                if name.endswith((".c", ".cpp")):
                    path = os.path.relpath(os.path.join(place, name), root)
                    sources.setdefault(path[4:] if path.startswith("src/") else path, path)
    return sources


def list_objects(build):
    for place, folders, names in os.walk(build):
        folders[:] = [f for f in folders if f not in ("tests", "examples", "benchmarks")]
        for name in names:
            if name.endswith((".c.o", ".cpp.o")):
                yield os.path.join(place, name)


def source_of(object_path, sources):
    """The source of build/src/core/CMakeFiles/seaway_core.dir/world/step.c.o is core/world/step.c."""
    inside = re.sub(r"CMakeFiles/[^/]+\.dir/", "", object_path)
    inside = inside.replace("/__/", "/../")
    name = os.path.normpath(inside)[:-2]
    for source in sources:
        if name.endswith("/src/" + source) or name.endswith("/" + source) and not source.startswith(("core", "gpu")):
            return source
    return None


def read_symbols(path):
    text = subprocess.run(["nm", path], check=True, stdout=subprocess.PIPE, text=True).stdout
    defined, undefined = set(), set()
    for line in text.splitlines():
        kind, name = line.split()[-2:]
        if kind in "TDBRCVW":
            defined.add(name)
        elif kind == "U":
            undefined.add(name)
    return defined, undefined


def read_seam(root):
    """Names that headers of the seam and public headers declare."""
    names = set()
    folders = ["include/seaway"] + ["src/" + module for module in SEAM]
    for folder in folders:
        for name in os.listdir(os.path.join(root, folder)):
            if name.endswith(".h"):
                with open(os.path.join(root, folder, name), encoding="utf-8") as file:
                    names.update(re.findall(r"\b(sw\w+)\s*\(", file.read()))
    return names


def module_of(source):
    return "/".join(source.split("/")[:2]) if source.startswith(("core/", "gpu/")) else os.path.dirname(source)


def may_use(user, definer):
    mine, theirs = module_of(user), module_of(definer)
    if mine == theirs:
        return True
    half, their_half = user.split("/")[0], definer.split("/")[0]
    if half == "core":
        table = CORE
    elif half == "gpu" and their_half == "gpu":
        table = GPU
    elif half in COMPANIONS and their_half in COMPANIONS:
        return COMPANIONS[their_half] < COMPANIONS[half]
    else:
        return True
    if their_half != half:
        return False
    return table.get(theirs.split("/")[1], 99) < table.get(mine.split("/")[1], -1)


def find_circles(uses):
    """Groups of files that use each other, by Tarjan's algorithm."""
    index, low, stack, on_stack, groups = {}, {}, [], set(), []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        on_stack.add(node)
        for other in sorted(uses.get(node, ())):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in on_stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            group = []
            while True:
                other = stack.pop()
                on_stack.discard(other)
                group.append(other)
                if other == node:
                    break
            if len(group) > 1:
                groups.append(sorted(group))

    sys.setrecursionlimit(10000)
    for node in sorted(uses):
        if node not in index:
            visit(node)
    return groups


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    build = os.path.abspath(sys.argv[1])
    root = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    sources = list_sources(root)
    defined_by, wants = {}, {}
    for path in sorted(list_objects(build)):
        source = source_of(path, sources)
        if source is None:
            continue
        defined, undefined = read_symbols(path)
        for name in defined:
            defined_by.setdefault(name, set()).add(source)
        wants[source] = undefined
    if not any(source.startswith("core/") for source in wants):
        print(f"check_symbols: {build} holds no objects of the library; build it first", file=sys.stderr)
        return 2
    seam = read_seam(root)
    problems = []
    uses = {}
    for source, names in sorted(wants.items()):
        for name in sorted(names):
            definers = defined_by.get(name, set())
            if not definers or source in definers:
                continue
            definer = sorted(definers)[0]
            if module_of(source) == module_of(definer):
                uses.setdefault(source, set()).add(definer)
            elif source.startswith("gpu/") and definer.startswith("core/"):
                if name not in seam:
                    problems.append(f"{source}: seam: must not use {name}() of {definer}")
            elif not may_use(source, definer):
                problems.append(f"{source}: inversion: must not use {name}() of {definer}")
    for group in find_circles(uses):
        if module_of(group[0]) in NO_CIRCLES:
            problems.append(f"{group[0]}: circle: " + " ".join(group))
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"symbols: {len(wants)} objects, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
