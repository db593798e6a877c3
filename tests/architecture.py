"""architecture.py ROOT ARROWS: docs/architecture.md shows the modules of the build, in its order, with its arrows.

ARROWS has a line "module: modules that it includes" for each. The document may leave out an arrow that follows from two
others, and must show no other than those.
"""
import pathlib
import re
import sys


def reached(arrows, module):
    """All modules that one stands on, near and far."""
    found, todo = set(), [module]
    while todo:
        new = set(arrows[todo.pop()]) - found
        found |= new
        todo += new
    return found


root, arrows = map(pathlib.Path, sys.argv[1:])
built = {line.split(":")[0]: line.split(":")[1].split() for line in arrows.read_text().splitlines()}
text = (root / "docs/architecture.md").read_text()
rows = re.findall(r"^modules/(\w+) +([^\n]*)$", text, re.MULTILINE)
shown = {name: row.split("-> ")[1].split(", ") if "-> " in row else [] for name, row in rows}

faults = []
if list(shown) != list(built):
    faults.append(f"the document lists {', '.join(shown)}; the build has {', '.join(built)}")
for module in set(shown) & set(built):
    for other in set(shown[module]) - set(built[module]):
        faults.append(f"the document has {module} -> {other}, and the build hasn't")
if not faults:
    for module in built:
        for other in sorted(reached(built, module) - reached(shown, module)):
            faults.append(f"the build has {module} -> {other}, which the document's arrows don't reach")
print("\n".join(faults) or f"{len(built)} modules, as in the build")
sys.exit(bool(faults))
