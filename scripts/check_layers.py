#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Hold the layers: who may include whom, and what every file of ours must have.

Rules, each with a name that its messages carry:
  layer    src/<half>/<module> includes only lower modules of its half, the seam (gpu: core/frame, core/lod, core/math,
           core/base), public headers and shaders/shared; programs and examples include public headers and their own folder only
  system   the core includes the C library, threads and the compilers' vector headers, nothing else
  vulkan   no Vulkan name in src/core
  shaders  shaders/shared includes shared; lib includes shared and lib; the rest shared, lib and its own folder
  unique   base names are unique across src/
  pass     every line of passes.inl has its shader, its recorder and its parity test
  header   every public header compiles alone, as C17 and as C++17
  spdx     every file starts with its licence
  sources  every .c file of a module is listed in a sources.cmake

Usage: scripts/check_layers.py [ROOT]
"""
import os
import re
import subprocess
import sys

CORE = {"base": 0, "math": 1, "frame": 2, "lod": 3, "spectra": 4, "records": 5, "formats": 6,
        "waves": 7, "input": 7, "fields": 7, "sim": 7, "surface": 8, "query": 9, "physics": 10, "world": 11, "api": 12}
GPU = {"vk": 0, "layer": 1, "pass": 2, "query": 3, "draw": 4, "record": 5, "api": 6}
COMPANIONS = {"files": 0, "measure": 0, "stage": 0, "share": 0, "scene": 1}
SEAM = {"core/frame", "core/lod", "core/math", "core/base"}
CORE_SYSTEM = set("""assert.h errno.h float.h inttypes.h limits.h math.h pthread.h sched.h stdalign.h stdarg.h stdatomic.h
    stdbool.h stddef.h stdint.h stdio.h stdlib.h string.h threads.h time.h unistd.h
    xmmintrin.h emmintrin.h immintrin.h cpuid.h arm_neon.h sys/auxv.h""".split())
PROGRAMS = ("cli", "viewer", "examples", "scenarios")
CODE = (".c", ".h", ".cpp", ".inl", ".comp", ".vert", ".frag", ".glsl")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
VULKAN = re.compile(r"\b(?:Vk[A-Z]\w*|vk[A-Z]\w*|VK_[A-Z_0-9]+)\b|vulkan|volk")

problems = []


def report(rule, path, text, line=0):
    problems.append(f"{path}:{line}: {rule}: {text}" if line else f"{path}: {rule}: {text}")


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def list_files(root):
    """Tracked and new files, without what git ignores; every file where there is no git."""
    try:
        out = subprocess.run(["git", "-C", root, "ls-files", "-co", "--exclude-standard"], check=True,
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
        return sorted({p for p in out.splitlines() if os.path.isfile(os.path.join(root, p))})
    except (OSError, subprocess.CalledProcessError):
        found = []
        for folder, subfolders, names in os.walk(root):
            subfolders[:] = [s for s in subfolders if not s.startswith((".", "build")) and s != "out"]
            found += [os.path.relpath(os.path.join(folder, n), root) for n in names]
        return sorted(found)


def module_of(path):
    parts = path.split("/")
    return "/".join(parts[:2]) if len(parts) > 2 else None


def check_core(path, target):
    mine, theirs = path.split("/")[2], target.split("/")[1]
    if theirs == mine:
        return True
    return theirs in CORE and mine in CORE and CORE[theirs] < CORE[mine]


def check_gpu(path, target):
    if module_of(target) in SEAM:
        return True
    mine, theirs = path.split("/")[2], target.split("/")[1]
    return target.startswith("gpu/") and theirs in GPU and (theirs == mine or GPU[theirs] < GPU[mine])


def may_include(root, path, target):
    """Whether a quoted include of a file below src/ or of a program is one that the table allows."""
    if target.startswith("seaway/"):
        return True
    if path.startswith("include/seaway/"):
        return "/" not in target
    if path.startswith("src/"):
        if target.startswith("shared/"):
            return True
        if target.endswith((".inc", "_shader.h")) and "/" not in target:
            return path.startswith(("src/gpu/", "src/stage/"))  # made by the build: SPIR-V and its bindings
        if path.startswith("src/core/"):
            return target.startswith("core/") and check_core(path, target)
        if path.startswith("src/gpu/"):
            return target.startswith(("core/", "gpu/")) and check_gpu(path, target)
        mine, theirs = path.split("/")[1], target.split("/")[0]
        return theirs == mine or target.startswith("core/base/") or \
            theirs in COMPANIONS and COMPANIONS[theirs] < COMPANIONS.get(mine, 0)
    folder = path.split("/")[0]
    if target.startswith(folder + "/"):
        return True
    beside = os.path.normpath(os.path.join(os.path.dirname(path), target))
    if os.path.isfile(os.path.join(root, beside)) and beside.startswith(folder + "/"):
        return True
    if os.path.isfile(os.path.join(root, folder, target)):
        return True
    if folder == "viewer" and re.fullmatch(r"\w+\.(vert|frag|comp)\.inc", target):
        return True  # SPIR-V of the build
    if folder == "examples" and re.fullmatch(r"\w+\.comp\.inc", target):
        return True  # likewise
    # The command line opens the viewer through the one header that the viewer shows; both write text to a terminal.
    if folder == "viewer" and target == "text.h":
        return True
    return folder == "cli" and target in ("viewer.h", "viewer/viewer.h")


def check_shader(path, target):
    folder = path.split("/")[1]
    allowed = {"shared": ("shared/",), "lib": ("shared/", "lib/")}.get(folder, ("shared/", "lib/", folder + "/"))
    if folder == "shared" and target in ("types.h", "limits.h") or target.startswith(allowed):
        return True
    if folder == "shared":  # beside it, and what C needs for GLSL's types and functions
        return "/" not in target or target in ("seaway/math.h", "core/math/scalar.h")
    return "/" not in target and folder not in ("shared", "lib")


def check_includes(root, path, text):
    for match in INCLUDE.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        quoted, target = match.group(1) == '"', match.group(2)
        if path.startswith("shaders/"):
            if quoted and not check_shader(path, target):
                report("shaders", path, f"must not include {target}", line)
        elif quoted or target.startswith("seaway/"):
            if not may_include(root, path, target):
                report("layer", path, f"must not include {target}", line)
        elif path.startswith("src/core/") and target not in CORE_SYSTEM:
            report("system", path, f"the core must not include <{target}>", line)


def check_names(files):
    seen = {}
    for path in files:
        if path.startswith("src/") and path.endswith((".c", ".h", ".cpp", ".inl")):
            name = os.path.basename(path)
            stem = name if name.endswith(".inl") else os.path.splitext(name)[0]
            for key, other in ((name, seen.get(name)), (stem, seen.get(stem))):
                if other and os.path.dirname(other) != os.path.dirname(path):
                    report("unique", path, f"has the base name of {other}")
                    break
            seen.setdefault(name, path)
            seen.setdefault(stem, path)


def check_passes(root, files):
    path = "src/core/frame/passes.inl"
    if path not in files:
        return
    for name in re.findall(r"^SW_PASS\(\w+, (\w+),", read(root, path), re.M):
        if not any(f.startswith("shaders/") and f.endswith(f"/{name}.comp") for f in files):
            report("pass", path, f"{name} has no shaders/*/{name}.comp")
        if f"src/gpu/pass/pass_{name}.c" not in files:
            report("pass", path, f"{name} has no src/gpu/pass/pass_{name}.c")
        family = name.split("_")[0]  # one test may hold several passes that only make sense together
        if not {f"tests/parity/parity_{name}.c", f"tests/parity/parity_{family}.c"} & set(files):
            report("pass", path, f"{name} has no tests/parity/parity_{name}.c")


def check_sources(root, files):
    listings = set(re.findall(r"\w+\.c\b", "".join(read(root, f) for f in files if f.endswith("sources.cmake"))))
    for path in files:
        if not re.match(r"src/(?:(?:core|gpu)/\w+|scene|files)/\w+\.c$", path):
            continue
        if os.path.basename(path) not in listings:
            report("sources", path, "is listed in no sources.cmake")


def check_headers(root, files):
    for path in files:
        if not re.match(r"include/seaway/\w+\.h$", path):
            continue
        for language, standard, compiler in (("c", "c17", os.environ.get("CC", "cc")),
                                             ("c++", "c++17", os.environ.get("CXX", "c++"))):
            command = [compiler, "-x", language, f"-std={standard}", "-Wall", "-Wextra", "-Werror", "-fsyntax-only",
                       "-I", os.path.join(root, "include"), "-"]
            done = subprocess.run(command, input=f'#include <{path[len("include/"):]}>\n', text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
            if done.returncode != 0:
                report("header", path, f"does not compile alone as {standard}:\n{done.stdout.strip()}")


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    root = os.path.normpath(root)
    files = list_files(root)
    code = [f for f in files if f.endswith(CODE)]
    for path in code:
        text = read(root, path)
        if "SPDX-License-Identifier: MIT" not in text[:200]:
            report("spdx", path, "does not start with // SPDX-License-Identifier: MIT")
        if path.startswith("src/core/"):
            for number, line in enumerate(text.splitlines(), 1):
                if VULKAN.search(re.sub(r"//.*", "", line)):
                    report("vulkan", path, "the core must not name Vulkan", number)
        if path.startswith(("src/", "include/", "shaders/") + tuple(p + "/" for p in PROGRAMS)):
            check_includes(root, path, text)
    check_names(files)
    check_passes(root, files)
    check_sources(root, files)
    check_headers(root, files)
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"layers: {len(code)} files, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
