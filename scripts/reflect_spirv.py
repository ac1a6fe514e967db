#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write a C header that names what a shader binds, from its SPIR-V.

A pipeline is made of one compute shader, or of a vertex and a fragment shader that share one set of bindings. Of each
the build makes two texts of SPIR-V words with glslc -mfmt=c: the optimised one, which is embedded and has lost its
names, and one that is not optimised and has them. The header holds, for a pipeline called `foam`:

    typedef struct swFoamBindings { swBinding slices, sources; ... } swFoamBindings;  one member a binding, by name
    typedef struct swFoamConstants { uint32_t size; ... } swFoamConstants;            specialisation constants, by id
    #define SW_FOAM_PUSH_SIZE 4                                                       bytes of push constants
    static const swShader swFoamShader = ...                                          words, numbers and types
    static inline void swBindFoam(gpu, commands, pipeline, &bindings, &push)          binds by these types

A block without an instance name is called as its type is, with a small first letter. Everything that the library's
pipelines cannot hold is refused here, with the shader's name: another set than 0, arrays of bindings, constants that
are not 32 bits, two stages that disagree about a binding.

Usage: scripts/reflect_spirv.py NAME HEADER WORDS NAMED [WORDS NAMED]
"""
import os
import re
import sys

MAGIC = 0x07230203
OP_NAME, OP_MEMBER_NAME, OP_ENTRY_POINT = 5, 6, 15
OP_TYPE_BOOL, OP_TYPE_INT, OP_TYPE_FLOAT, OP_TYPE_VECTOR, OP_TYPE_MATRIX = 20, 21, 22, 23, 24
OP_TYPE_IMAGE, OP_TYPE_SAMPLER, OP_TYPE_SAMPLED_IMAGE, OP_TYPE_ARRAY, OP_TYPE_STRUCT, OP_TYPE_POINTER = \
    25, 26, 27, 28, 30, 32
OP_CONSTANT, OP_SPEC_TRUE, OP_SPEC_FALSE, OP_SPEC_CONSTANT, OP_SPEC_COMPOSITE = 43, 48, 49, 50, 51
OP_VARIABLE, OP_DECORATE, OP_MEMBER_DECORATE, OP_EXECUTION_MODE_ID = 59, 71, 72, 331
SPEC_ID, BUILT_IN, BINDING, DESCRIPTOR_SET, OFFSET, BLOCK, ARRAY_STRIDE, MATRIX_STRIDE = 1, 11, 33, 34, 35, 2, 6, 7
UNIFORM_CONSTANT, UNIFORM, PUSH_CONSTANT, STORAGE_BUFFER = 0, 2, 9, 12
WORKGROUP_SIZE, LOCAL_SIZE_ID = 25, 38
STAGES = {0: "VK_SHADER_STAGE_VERTEX_BIT", 4: "VK_SHADER_STAGE_FRAGMENT_BIT", 5: "VK_SHADER_STAGE_COMPUTE_BIT"}
SUFFIXES = {0: "Vertex", 4: "Fragment", 5: "Shader"}
MOST_BINDINGS, MOST_CONSTANTS, MOST_PUSH_BYTES = 25, 16, 128  # of gpu/vk/vk_pipeline.h, which asserts the same


class Refused(Exception):
    """A sentence about a shader that the library's pipelines cannot hold."""


def read_text(words, at):
    """A literal string of an instruction, and the index after it."""
    out = bytearray()
    while True:
        four = words[at].to_bytes(4, "little")
        at += 1
        if 0 in four:
            return (bytes(out) + four[:four.index(0)]).decode("utf-8"), at
        out += four


class Module:
    """What a module declares: everything that a pipeline's layout needs."""

    def __init__(self, words):
        if len(words) < 5 or words[0] != MAGIC:
            raise Refused("is no SPIR-V")
        self.names, self.types, self.variables, self.constants = {}, {}, [], {}
        self.decorations, self.members, self.local_size, self.composites = {}, {}, [], {}
        self.spec, self.stage = [], None
        at = 5
        while at < len(words):
            count, op = words[at] >> 16, words[at] & 0xffff
            if count == 0 or at + count > len(words):
                raise Refused("is cut off")
            self.take(op, words[at + 1:at + count])
            at += count

    def take(self, op, w):
        if op == OP_NAME:
            self.names[w[0]] = read_text(w, 1)[0]
        elif op == OP_ENTRY_POINT:
            self.stage = w[0]
        elif OP_TYPE_BOOL <= op <= OP_TYPE_STRUCT or op == OP_TYPE_POINTER:
            self.types[w[0]] = (op, w[1:])
        elif op == OP_VARIABLE:
            self.variables.append((w[1], w[0], w[2]))
        elif op == OP_CONSTANT:
            self.constants[w[1]] = w[2]
        elif op in (OP_SPEC_TRUE, OP_SPEC_FALSE, OP_SPEC_CONSTANT):
            self.spec.append((w[1], w[0]))
        elif op == OP_SPEC_COMPOSITE:
            self.composites[w[1]] = w[2:]
        elif op == OP_DECORATE:
            self.decorations.setdefault(w[0], {})[w[1]] = w[2] if len(w) > 2 else 0
        elif op == OP_MEMBER_DECORATE:
            self.members.setdefault(w[0], {}).setdefault(w[1], {})[w[2]] = w[3] if len(w) > 3 else 0
        elif op == OP_EXECUTION_MODE_ID and w[1] == LOCAL_SIZE_ID:
            self.local_size = w[2:]

    def decoration(self, target, kind):
        return self.decorations.get(target, {}).get(kind)

    def size_of(self, target, stride=None):
        """Bytes that a type covers in a block, without padding at its end."""
        op, w = self.types[target]
        if op in (OP_TYPE_INT, OP_TYPE_FLOAT):
            return w[0] // 8
        if op == OP_TYPE_BOOL:
            return 4
        if op == OP_TYPE_VECTOR:
            return self.size_of(w[0]) * w[1]
        if op == OP_TYPE_MATRIX:
            return stride * (w[1] - 1) + self.size_of(w[0])
        if op == OP_TYPE_ARRAY:
            return self.decoration(target, ARRAY_STRIDE) * (self.constants[w[1]] - 1) + self.size_of(w[0])
        if op == OP_TYPE_STRUCT:
            members = self.members.get(target, {})
            return max((members[i][OFFSET] + self.size_of(t, members[i].get(MATRIX_STRIDE)) for i, t in enumerate(w)),
                       default=0)
        raise Refused("has push constants of a type that cannot be measured")

    def descriptor_of(self, name, storage, pointee):
        op, w = self.types[pointee]
        if op == OP_TYPE_SAMPLED_IMAGE:
            return "VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER"
        if op == OP_TYPE_SAMPLER:
            return "VK_DESCRIPTOR_TYPE_SAMPLER"
        if op == OP_TYPE_IMAGE:
            return "VK_DESCRIPTOR_TYPE_STORAGE_IMAGE" if w[5] == 2 else "VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE"
        if op == OP_TYPE_STRUCT and storage == STORAGE_BUFFER:
            return "VK_DESCRIPTOR_TYPE_STORAGE_BUFFER"
        if op == OP_TYPE_STRUCT and storage == UNIFORM and self.decoration(pointee, BLOCK) is not None:
            return "VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER"
        raise Refused(f"has a binding {name} of a kind that pipelines do not hold (an array of bindings, perhaps)")

    def bindings(self):
        """{number: (name, descriptor type)}; names are empty in an optimised module."""
        out = {}
        for variable, pointer, storage in self.variables:
            if storage not in (UNIFORM_CONSTANT, UNIFORM, STORAGE_BUFFER):
                continue
            pointee = self.types[pointer][1][1]
            name = self.names.get(variable) or self.names.get(pointee, "")
            number = self.decoration(variable, BINDING)
            if number is None or self.decoration(variable, DESCRIPTOR_SET) not in (None, 0):
                raise Refused(f"has {name} outside of set 0")
            if number in out:
                raise Refused(f"has {name} and {out[number][0]} both at binding {number}")
            out[number] = (name[:1].lower() + name[1:], self.descriptor_of(name, storage, pointee))
        return out

    def push_size(self):
        sizes = [self.size_of(self.types[p][1][1]) for _, p, storage in self.variables if storage == PUSH_CONSTANT]
        return max(sizes, default=0)

    def constant_list(self):
        """[(id, name)] of specialisation constants, ascending. A side of the workgroup has no name of its own."""
        sides = dict(zip(self.local_size, "XYZ"))
        for target, parts in self.composites.items():
            if self.decoration(target, BUILT_IN) == WORKGROUP_SIZE:
                sides.update(zip(parts, "XYZ"))
        out = {}
        for target, kind in self.spec:
            number = self.decoration(target, SPEC_ID)
            if number is None:
                continue
            op, w = self.types[kind]
            name = self.names.get(target) or ("workgroup" + sides[target] if target in sides else None)
            if op != OP_TYPE_BOOL and w[0] != 32:
                raise Refused(f"has a constant {name} that is not 32 bits")
            out[number] = to_camel(name) if name else out.get(number, f"constant{number}")
        return sorted(out.items())


def to_camel(name):
    """FFT_SIZE and targetEncodes to a C member's name."""
    if not name.isupper():
        return name[:1].lower() + name[1:]
    parts = name.lower().split("_")
    return parts[0] + "".join(p.capitalize() for p in parts[1:])


def to_upper(camel):
    """WavesRows to WAVES_ROWS."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", camel).upper()


def read_words(path):
    with open(path, encoding="utf-8") as file:
        return [int(w, 0) for w in re.findall(r"0x[0-9a-fA-F]+|\b\d+\b", file.read())]


class Stage:
    """One shader of a pipeline: its optimised words, and what they are called."""

    def __init__(self, words_path, named_path):
        self.include = os.path.basename(words_path)
        try:
            used, named = Module(read_words(words_path)), Module(read_words(named_path))
            self.stage, self.push = named.stage, named.push_size()
            self.bindings, self.constants = named.bindings(), named.constant_list()
            if self.stage not in STAGES:
                raise Refused("is of a stage that pipelines do not have")
            for number, (_, kind) in used.bindings().items():
                if number not in self.bindings or self.bindings[number][1] != kind:
                    raise Refused(f"has another binding {number} once it is optimised")
            if used.push_size() > self.push:
                raise Refused("has more push constants once it is optimised")
        except Refused as refused:
            raise Refused(f"{self.include.removesuffix('.inc')} {refused}") from None


def merge(stages):
    """The bindings of all stages, [(number, name, type)], and the constants, ascending."""
    bindings, constants = {}, {}
    for stage in stages:
        for number, (name, kind) in stage.bindings.items():
            known = bindings.setdefault(number, (name, kind))
            if known != (name, kind):
                raise Refused(f"{stage.include} calls binding {number} {name}, another stage calls it {known[0]}")
        for number, name in stage.constants:
            if constants.setdefault(number, name) != name:
                raise Refused(f"{stage.include} calls constant {number} {name}, another stage {constants[number]}")
    names = [name for name, _ in bindings.values()]
    for name in names:
        if not re.fullmatch(r"[a-z]\w*", name) or names.count(name) > 1:
            raise Refused(f"{stages[0].include} has a binding that is called {name!r}: give each a name of its own")
    if len(bindings) > MOST_BINDINGS or len(constants) > MOST_CONSTANTS:
        raise Refused(f"{stages[0].include} has {len(bindings)} bindings and {len(constants)} constants; the most are "
                      f"{MOST_BINDINGS} and {MOST_CONSTANTS}")
    if max(s.push for s in stages) > MOST_PUSH_BYTES:
        raise Refused(f"{stages[0].include} has more than {MOST_PUSH_BYTES} bytes of push constants")
    return [(n, *bindings[n]) for n in sorted(bindings)], sorted(constants.items())


def write_struct(lines, name, kind, members):
    if members:
        lines += [f"typedef struct {name}", "{"]
        lines += [f"    {kind} {member};" for member in members]
        lines += [f"}} {name};", ""]


def make_bind(camel, bindings, push_size):
    """swBindPipeline() with this pipeline's own types."""
    arguments = ["swGpu* gpu", "VkCommandBuffer commands", "const swPipeline* pipeline"]
    arguments += [f"const {camel}Bindings* bindings"] if bindings else []
    arguments += [f"const void* push /* SW_{to_upper(camel[2:])}_PUSH_SIZE bytes */"] if push_size else []
    first = f"&bindings->{bindings[0][1]}" if bindings else "NULL"
    return [f"static inline void swBind{camel[2:]}({', '.join(arguments)})", "{",
            f"    swBindPipeline(gpu, commands, pipeline, {first}, {'push' if push_size else 'NULL'});", "}", ""]


def make_header(name, stages):
    bindings, constants = merge(stages)
    push_size = max(s.push for s in stages)
    camel = "sw" + "".join(p.capitalize() for p in name.split("_"))
    lines = ["// SPDX-License-Identifier: MIT",
             f"// Made by scripts/reflect_spirv.py of {', '.join(s.include.removesuffix('.inc') for s in stages)}.",
             "#pragma once", "", '#include "gpu/vk/vk_pipeline.h"', ""]
    write_struct(lines, camel + "Bindings", "swBinding", [b[1] for b in bindings])
    write_struct(lines, camel + "Constants", "uint32_t", [c[1] for c in constants])
    lines += [f"#define SW_{name.upper()}_PUSH_SIZE {push_size}", ""]
    for stage in stages:
        shader = camel + SUFFIXES[stage.stage]
        lines += [f"static const uint32_t {shader}Words[] =", f'#include "{stage.include}"', "    ;",
                  f"static const swShader {shader} = {{",
                  f'    .name = "{name}",', f"    .words = {shader}Words,", f"    .size = sizeof({shader}Words),",
                  f"    .stage = {STAGES[stage.stage]},", f"    .pushSize = {push_size},",
                  f"    .bindingCount = {len(bindings)},"]
        if bindings:
            lines += ["    .bindings =", "        {"]
            lines += [f"            {{{number}, {kind}}}, // {member}" for number, member, kind in bindings]
            lines += ["        },"]
        lines += [f"    .constantCount = {len(constants)},"]
        if constants:
            lines += [f"    .constantIds = {{{', '.join(str(c[0]) for c in constants)}}},"]
        lines += ["};", ""]
    lines += make_bind(camel, bindings, push_size)
    return "\n".join(lines)


def main():
    if len(sys.argv) not in (5, 7):
        print(__doc__, file=sys.stderr)
        return 2
    name, header, paths = sys.argv[1], sys.argv[2], sys.argv[3:]
    try:
        text = make_header(name, [Stage(*paths[i:i + 2]) for i in range(0, len(paths), 2)])
    except Refused as refused:
        print(f"reflect_spirv: {refused}", file=sys.stderr)
        return 1
    with open(header, "w", encoding="utf-8") as file:
        file.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
