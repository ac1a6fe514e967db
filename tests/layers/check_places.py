#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Hold docs/adding_a_simulation.md against foam and the made-up layers.

The page lists at most 8 places. Each must exist and speak of foam. Wetness, which is all that a layer can be, must have
every one of them; ink has a part; and below tests/layers there must be no file that is none of the places.

Usage: check_places.py SOURCE_ROOT
"""
import os
import re
import sys

MOST_PLACES = 8
FOLDERS = ("include", "src", "shaders")


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def list_places(page):
    table = page.split("<!-- places -->")[1].split("<!-- end of places -->")[0]
    rows = re.findall(r"^\| \d+ \| (.*?) \|", table, re.M)
    return [re.findall(r"`([^`]+)`", row) for row in rows]


def list_files(overlay):
    found = set()
    for folder in FOLDERS:
        for path, _, names in os.walk(os.path.join(overlay, folder)):
            found |= {os.path.relpath(os.path.join(path, name), overlay) for name in names}
    return found


def speaks_of(path, name):
    return os.path.isfile(path) and (name in os.path.basename(path) or name in read(path).lower())


def main():
    root = sys.argv[1]
    overlay = os.path.dirname(os.path.abspath(__file__))
    places = list_places(read(os.path.join(root, "docs", "adding_a_simulation.md")))
    problems = []
    if not 0 < len(places) <= MOST_PLACES:
        problems.append(f"the page lists {len(places)} places; a layer must have 1 to {MOST_PLACES}")
    listed = [path for row in places for path in row]
    allowed = set()
    for path in listed:
        if not speaks_of(os.path.join(root, path), "foam"):
            problems.append(f"{path} is listed, and is not there or does not speak of foam")
        wet = path.replace("foam", "wetness")
        if not speaks_of(os.path.join(overlay, wet), "wetness"):
            problems.append(f"{path} is listed, but wetness does without: tests/layers/{wet}")
        allowed |= {wet, path.replace("foam", "ink")}
    for path in sorted(list_files(overlay) - allowed):
        problems.append(f"tests/layers/{path} is none of the places that the page lists")
    ink = [row for row in places if any(speaks_of(os.path.join(overlay, p.replace("foam", "ink")), "ink") for p in row)]
    for problem in problems:
        print(problem)
    print(f"places: {len(places)} listed, wetness has {len(places)}, ink {len(ink)}; {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
