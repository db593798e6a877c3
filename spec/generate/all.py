#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every generator. With --check it writes nothing and fails where a committed vector file differs."""
import importlib.util
import pathlib
import subprocess
import sys

if not importlib.util.find_spec("mpmath"):
    print("SKIPPED: the generators need mpmath")
    sys.exit(0)
generators = sorted(pathlib.Path(__file__).resolve().parent.glob("eq_*.py"))
failed = [g.name for g in generators if subprocess.run([sys.executable, g, *sys.argv[1:]], check=False).returncode]
sys.exit(f"failed: {', '.join(failed)}" if failed else 0)
