#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Hold the docs to the code.

  code     a code block after <!-- from FILE --> or <!-- from FILE REGION --> is that file's text, or its text between
           "// [REGION]" and "// [/REGION]" without the common indentation; --fix writes it anew
  link     relative links and pictures lead to files of the repository, anchors to headings
  verb     every `seaway VERB` in the docs is a verb of the program
  cite     every [Author Year] in the sources stands in docs/references.md
  target   every `make TARGET` in the docs is a target of the Makefile
  mistake  docs/checks.md is what scripts/make_check_docs writes

Usage: scripts/check_docs.py [--fix]
"""
import os
import re
import subprocess
import sys
import textwrap

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
BLOCK = re.compile(r"<!-- from (\S+)(?: (\S+))? -->\n+```\w*\n(.*?)```", re.S)
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)(?: \"[^\"]*\")?\)")
CITE = re.compile(r"\[((?:[A-Z][\w'\u00C0-\u017F-]+)(?:(?: and| et al\.| of|,)? [A-Z][\w'\u00C0-\u017F-]+)* (?:18|19|20)\d\d[a-z]?)\]")
problems = []


def report(rule, path, text):
    problems.append(f"{path}: {rule}: {text}")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def list_files():
    out = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard"], check=True,
                         stdout=subprocess.PIPE, text=True).stdout
    return [p for p in out.splitlines() if os.path.isfile(os.path.join(ROOT, p))]


def cut(path, region):
    text = read(path)
    if region:
        match = re.search(rf"^[ \t]*// \[{region}\]\n(.*?)^[ \t]*// \[/{region}\]", text, re.S | re.M)
        if not match:
            return None
        text = textwrap.dedent(match.group(1))
    return text.rstrip("\n") + "\n"


def check_code(path, text, fix):
    def replace(match):
        source, region, code = match.groups()
        wanted = cut(source, region) if os.path.isfile(os.path.join(ROOT, source)) else None
        if wanted is None:
            report("code", path, f"there is no {source} {region or ''}")
        elif wanted != code:
            if fix:
                return match.group(0)[:match.start(3) - match.start()] + wanted + "```"
            report("code", path, f"the block from {source} {region or ''} differs; scripts/check_docs.py --fix")
        return match.group(0)

    fixed = BLOCK.sub(replace, text)
    if fixed != text:
        with open(os.path.join(ROOT, path), "w", encoding="utf-8") as file:
            file.write(fixed)
    return fixed


def anchors(text):
    found = set()
    for heading in re.findall(r"^#+ (.*)$", text, re.M):
        slug = re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")
        found.add(slug)
    return found


def check_links(path, text):
    plain = re.sub(r"```.*?```", "", text, flags=re.S)
    for target in LINK.findall(plain):
        if re.match(r"[a-z]+:", target):
            continue
        file, _, anchor = target.partition("#")
        place = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
        if not os.path.exists(os.path.join(ROOT, place)):
            report("link", path, f"{target} leads nowhere")
        elif anchor and place.endswith(".md") and anchor not in anchors(read(place)):
            report("link", path, f"{place} has no heading #{anchor}")


def check_verbs(path, text, verbs):
    code = re.findall(r"```.*?```|`[^`\n]+`", text, re.S)
    for verb in re.findall(r"(?:^|[\s`/(])seaway ([a-z]+)\b", "\n".join(code)):
        if verbs and verb not in verbs:
            report("verb", path, f"the program has no verb '{verb}'")


def check_targets(path, text, targets):
    code = re.findall(r"```.*?```|`[^`\n]+`", text, re.S)
    for target in re.findall(r"(?:^|`|\n|&& )make ([a-z]+)\b", "\n".join(code)):
        if target not in targets:
            report("target", path, f"the Makefile has no target '{target}'")


def check_cites(files):
    if "docs/references.md" not in files:
        return
    known = set(re.findall(r"\*\*\[([^\]]+)\]\*\*", read("docs/references.md")))
    for path in files:
        if path.endswith((".c", ".h", ".inl", ".comp", ".vert", ".frag", ".glsl")) or path.startswith("docs/") and \
                path.endswith(".md"):
            for cite in CITE.findall(read(path)):
                if cite not in known:
                    report("cite", path, f"[{cite}] is not in docs/references.md")


def check_mistakes():
    if subprocess.run([sys.executable, "scripts/make_check_docs", "--check"], stderr=subprocess.DEVNULL).returncode:
        report("mistake", "docs/checks.md", "it differs from its lists; run scripts/make_check_docs")


def main():
    fix = "--fix" in sys.argv[1:]
    files = list_files()
    verbs = {m.group(1) for m in (re.match(r"cli/cmd_(\w+)\.c$", f) for f in files) if m}
    targets = set(re.findall(r"^([a-z]+):", read("Makefile"), re.M))
    pages = [f for f in files if f.endswith(".md")]
    for path in pages:
        text = check_code(path, read(path), fix)
        check_links(path, text)
        check_verbs(path, text, verbs)
        check_targets(path, text, targets)
    check_cites(files)
    check_mistakes()
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"docs: {len(pages)} pages, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
