"""dependencies.py ROOT: docs/dependencies.md says of every package that scripts/packages lists what it is for."""
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(sys.argv[1])
script = root / "scripts" / "packages"
purposes = re.findall(r"^        ([a-z]+)\) echo", script.read_text(), re.MULTILINE)
packages = subprocess.run([script, *purposes], capture_output=True, text=True, check=True).stdout.split()
named = set(re.findall(r"[\w+.-]+", (root / "docs/dependencies.md").read_text()))
missing = sorted(set(packages) - named)
for package in missing:
    print(f"docs/dependencies.md doesn't name {package}")
if not missing:
    print(f"{len(set(packages))} packages of {len(purposes)} purposes are named")
sys.exit(bool(missing or len(purposes) < 10))
