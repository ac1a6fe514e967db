#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write what the public headers say of defs, for tests/core/test_fields.c to hold the tables of fields against.

A def's table (include/seaway/field.h) is its truth; the header's prose says the same to people. Of every struct that has a
table this writes each member with the range and the default that its comment names, and the list of all tables.

Usage: scripts/make_field_test.py HEADERS_FOLDER OUTPUT.inl HEADER...
"""
import os
import re
import sys

# What is said in words instead of numbers, each with its reason.
WORDS = {
    "resolution / 4": None,  # hangs on another field
    "infinite": "(double)INFINITY", "inf": "(double)INFINITY", "NAN": "(double)NAN", "pi": "SW_PI",
    "clear ocean": None, "null": None, "NULL": None,
}


def number(text):
    """A C expression of a number in a comment, or None if it is none."""
    text = text.strip().rstrip(".,:;")
    if text in WORDS:
        return WORDS[text]
    degrees = re.fullmatch(r"(-?[\d.e]+) degrees", text)
    if degrees:
        return f"({degrees.group(1)} * (SW_PI / 180.0))"
    power = re.fullmatch(r"(-?\d+)\^(-?\d+)", text)
    if power:
        return repr(float(power.group(1)) ** int(power.group(2)))
    part = re.fullmatch(r"(\d+)/(\d+)", text)
    if part:
        return f"({part.group(1)}.0 / {part.group(2)}.0)"
    if re.fullmatch(r"-?(pi|SW_\w+|INT32_MAX|UINT32_MAX|SIZE_MAX|FLT_MAX|[\d.]+(e-?\d+)?)", text):
        return "(double)(" + text.replace("pi", "SW_PI") + ")"
    return {"true": "1.0", "false": "0.0"}.get(text)


def read_range(text):
    match = re.search(r"[Rr]ange ([\[(])([^,\])]+), ([^\])]+)([\])])", text)
    ends = [number(match.group(2)), number(match.group(3))] if match else [None, None]
    if None in ends:
        return "false, 0.0, 0.0, false, false"
    opens = ["true" if match.group(1) == "(" else "false", "true" if match.group(4) == ")" else "false"]
    return f"true, {ends[0]}, {ends[1]}, {opens[0]}, {opens[1]}"


def read_default(text):
    match = re.search(r"Default (-?[\w./^-]+(?: degrees)?|[\w ]+)", text)
    value = number(match.group(1)) if match else None
    return f"true, {value}" if value else "false, 0.0"


def read_members(body):
    """Pairs of a member and its comment, which stands before it or behind it."""
    comment, was_blank = "", True
    for line in body.splitlines():
        line = line.strip()
        if line.startswith("///<"):
            comment += " " + line[4:]
            continue
        if line.startswith("///"):
            comment += " " + line[3:]
            continue
        if line == "":
            comment = ""
            continue
        behind = re.search(r"///< ?(.*)", line)
        code = re.sub(r"///<.*", "", line).strip().rstrip(";")
        names = re.sub(r"^.*?(\w+(?:\[\w+\])?(?:\s*,\s*\w+)*)$", r"\1", code)
        for name in names.split(","):
            said = re.sub(r"\s+", " ", (behind.group(1) if behind else "") + " " + comment)
            yield re.sub(r"\[.*", "", name.strip()), said
        comment = ""


def main():
    folder, output, headers = sys.argv[1], sys.argv[2], sys.argv[3:]
    text = ""
    for header in headers:
        with open(os.path.join(folder, header + ".h"), encoding="utf-8") as file:
            text += file.read()
    getters = re.findall(r"^SW_API const swFields\* (swGet(\w+)Fields)\(void\);", text, re.M)
    lines = ["// Written by scripts/make_field_test.py; do not edit.", ""]
    rows = []
    for getter, name in getters:
        default = next((f for f in (f"swDefault{name}Def", f"swDefault{name}")
                        if re.search(rf"^SW_API \w+ {f}\(void\);", text, re.M)), None)
        if default:
            kind = re.search(rf"^SW_API (\w+) {default}\(void\);", text, re.M).group(1)
            lines += [f"static void Make{name}(void* def)", "{", f"    {kind} made = {default}();",
                      "    memcpy(def, &made, sizeof made);", "}", ""]
        rows.append(f"    {{{getter}, {'Make' + name if default else 'NULL'}}},")
    lines += ["static const Table tables[] = {"] + rows + ["};", "", "static const Said said[] = {"]
    for name, body in re.findall(r"typedef struct (sw\w+)\n\{\n(.*?)\n\} \1;", text, re.S):
        for member, comment in read_members(body):
            lines.append(f'    {{"{name}", "{member}", {read_range(comment)}, {read_default(comment)}}},')
    lines += ["};", ""]
    with open(output, "w", encoding="utf-8") as file:
        file.write("\n".join(lines))


if __name__ == "__main__":
    main()
