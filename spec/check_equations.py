#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks spec/equations.toml against the sources: check_equations.py ROOT.

Fails if an equation of the paper has no entry; if an entry has no test, vectors or generator, a test that ctest does
not run or that never calls a named function, or names a function that no public header declares; or if a comment or
document under modules/ or cmd/ cites an equation that the file doesn't know.
"""
import pathlib
import re
import sys
import tomllib

PAPER = {1, 2, 3, 4, 5, 6}
CITATION = re.compile(r"\b(?:eqs?\.|eqn\.|equations?)\s*((?:\(\d+\)(?:\s*(?:,|and|or|to)\s*)?)+)", re.IGNORECASE)
SOURCES = {".hpp", ".cpp", ".h", ".cppm", ".md", ".py", ".txt"}


def cited(text):
    """Numbers that a text cites; "eq. (4) to (6)" cites 4, 5 and 6."""
    numbers = set()
    text = re.sub(r"\n\s*(?://+|#)?\s*", " ", text)  # a citation may run over a line end
    for match in CITATION.finditer(text):
        numbers |= {int(n) for n in re.findall(r"\d+", match[1])}
        for first, last in re.findall(r"\((\d+)\)\s*to\s*\((\d+)\)", match[1]):
            numbers |= set(range(int(first), int(last) + 1))
    return numbers


def declared(root, function):
    """Whether a public header declares the function in its namespace, or in its class and that class's namespace."""
    scope, _, name = function.rpartition("::")
    outer, _, last = scope.rpartition("::")
    for header in root.glob("modules/*/include/**/*.hpp"):
        text = header.read_text(encoding="utf-8")
        in_scope = f"namespace {scope} " in text or (f"namespace {outer} " in text and f"class {last} " in text)
        if in_scope and re.search(rf"\b{name}\(", text):
            return True
    return False


def faults_of_entry(root, entry):
    spec = root / "spec"
    label = f"equation ({entry['id']})"
    for field in ("test", "vectors", "generator"):
        if not (spec / entry[field]).is_file():
            yield f"{label}: its {field} {entry[field]} is missing"
    test = spec / entry["test"]
    code = test.read_text(encoding="utf-8") if test.is_file() else ""
    if "TEST_CASE(" not in code:
        yield f"{label}: {entry['test']} holds no test"
    if f"wm3d_equation_test({entry['id']:02} " not in (spec / "CMakeLists.txt").read_text(encoding="utf-8"):
        yield f"{label}: spec/CMakeLists.txt doesn't build its test"
    if not entry["functions"]:
        yield f"{label}: no function computes it"
    for function in entry["functions"]:
        if not declared(root, function):
            yield f"{label}: no public header declares {function}"
        if not re.search(rf"\b{function.rpartition('::')[2]}\b", code):
            yield f"{label}: {entry['test']} never calls {function}"


def faults(root):
    entries = tomllib.loads((root / "spec/equations.toml").read_text(encoding="utf-8"))["equation"]
    known = [entry["id"] for entry in entries]
    for number in sorted(PAPER - set(known)):
        yield f"equation ({number}) of the paper has no entry in spec/equations.toml"
    for number in sorted({n for n in known if known.count(n) > 1}):
        yield f"equation ({number}) has several entries in spec/equations.toml"
    for entry in entries:
        yield from faults_of_entry(root, entry)
    for folder in ("modules", "cmd"):
        for path in sorted(p for p in (root / folder).rglob("*") if p.suffix in SOURCES):
            for number in sorted(cited(path.read_text(encoding="utf-8")) - set(known)):
                yield f"{path.relative_to(root)} cites equation ({number}), which spec/equations.toml doesn't know"


def main():
    found = list(faults(pathlib.Path(sys.argv[1])))
    for fault in found:
        print(fault)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
