"""library_doc.py ROOT: every C++ example of docs/library.md is a file of examples/, to the letter, and all are shown."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
text = (root / "docs/library.md").read_text()
shown = dict(re.findall(r"`examples/([\w/]+\.cpp)`:?\n+```cpp\n(.*?)```", text, re.S))
files = {str(path.relative_to(root / "examples")): path.read_text() for path in (root / "examples").rglob("*.cpp")}
without_licence = {name: source.split("\n", 1)[1] for name, source in files.items()}
faults = [f"docs/library.md doesn't show examples/{name}" for name in files if name not in shown]
faults += [f"docs/library.md shows examples/{name}, which isn't there" for name in shown if name not in files]
faults += [f"docs/library.md shows another examples/{name} than the one that is built"
           for name in shown if name in files and shown[name] != without_licence[name]]
for fault in faults:
    print(fault)
sys.exit(bool(faults))
