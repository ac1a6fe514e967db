#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Copies of the library's files with what made-up layers add to them.

A file below tests/layers with marks, `//@ before LINE` or `//@ end`, holds pieces for the library's file of the same
path: each goes before the first line that begins with LINE, or to the end. A mark that is not found is an error, so the
pieces follow the library. Public headers are copied all, as they include each other by their folder.

Usage: make_tree.py SOURCE_ROOT OUTPUT_FOLDER; prints the patched files, one a line
"""
import os
import sys

MARK = "//@ "
FOLDERS = ("include", "src")  # what the library includes from


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read().splitlines()


def write(path, lines):
    text = "\n".join(lines) + "\n"
    os.makedirs(os.path.dirname(path), exist_ok=True)
    if not os.path.exists(path) or open(path, encoding="utf-8").read() != text:  # keeps times of what stays
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


def list_pieces(path):
    """(mark, lines) of each piece; none of a file of its own."""
    pieces = []
    for line in read(path):
        if line.startswith(MARK):
            pieces.append((line[len(MARK):], []))
        elif pieces:
            pieces[-1][1].append(line)
    return pieces


def patch(path, pieces):
    lines = read(path)
    for mark, piece in pieces:
        if mark == "end":
            lines += piece
            continue
        target = mark.removeprefix("before ").strip()
        found = [i for i, line in enumerate(lines) if line.strip().startswith(target)]
        if not found:
            sys.exit(f"{path}: no line begins with '{target}', before which a made-up layer has something to say")
        lines[found[0]:found[0]] = piece
    return lines


def main():
    root, out = sys.argv[1], sys.argv[2]
    overlay = os.path.dirname(os.path.abspath(__file__))
    headers = os.path.join(root, "include", "seaway")
    for name in os.listdir(headers):
        write(os.path.join(out, "seaway", name), read(os.path.join(headers, name)))
    for folder in FOLDERS:
        for path, _, names in os.walk(os.path.join(overlay, folder)):
            for name in sorted(names):
                own = os.path.join(path, name)
                pieces = list_pieces(own)
                if pieces:
                    below = os.path.relpath(own, os.path.join(overlay, folder))
                    original = os.path.join(root, folder, below)
                    write(os.path.join(out, below), patch(original, pieces))
                    print(original)


if __name__ == "__main__":
    main()
