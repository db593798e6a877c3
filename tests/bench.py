#!/usr/bin/env python3
"""`wm3d bench` from outside: killed and resumed, watched, and its quick form. bench.py WM3D TestClass"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

import outside
from outside import wm3d

FACES = 4000  # where files and lines are what is tried, not marks
QUICK_MODELS = "stanford-bunny.obj", "horse.ply", "rocker-arm.obj"
QUICK_ATTACKS = "noise:0.3,smoothing:10,quantization:9,subdivision:loop,simplification:70,remeshing"


def items_of(folder):
    """The lines of a bench in a fixed order, without the only figure that is no result."""
    lines = []
    for line in (folder / "items.jsonl").read_text().splitlines():
        record = json.loads(line)
        record.pop("seconds", None)
        lines.append(json.dumps(record))
    return sorted(lines)


class Resume(outside.InFolder):
    def run_in(self, name, *more, keys=2, attacks="noise:0.1,smoothing:5,cropping:20,file"):
        """A folder of its own and the bench there, so that the same command line does the same."""
        folder = self.folder / name
        folder.mkdir(exist_ok=True)
        source = self.folder / "sample.ply"
        if not source.exists():
            self.sample(FACES)
        shutil.copy(source, folder / "sample.ply")
        return folder, [outside.WM3D, "bench", "-q", "--models", "sample.ply", "--out", "results", "--mrms", "0.05,0.1",
                        "--keys", str(keys), "--wrong-keys", "4", "--attacks", attacks,
                        "--effort", "0", *more]  # the search is not what is tried here

    def finish(self, name, *more, **options):
        folder, command = self.run_in(name, *more, **options)
        done = subprocess.run(command, cwd=folder, capture_output=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return folder / "results"

    def kill_after(self, lines, name):
        folder, command = self.run_in(name)
        process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        log = folder / "results" / "items.jsonl"
        while process.poll() is None and (not log.exists() or log.read_bytes().count(b"\n") < lines):
            time.sleep(0.002)
        process.send_signal(signal.SIGKILL)
        process.wait()
        return log

    def test_killed_work_goes_on_where_it_was(self):
        whole = self.finish("whole", "--threads", "1")
        for lines in (1, 3, 9):
            log = self.kill_after(lines, "killed")
            there = log.read_text().splitlines()
            self.assertLess(len(there), len(items_of(whole)), "it was over before it could be killed")
        with open(log, "a", encoding="ascii") as file:
            file.write('{"kind":"item","model":"samp')  # cut off in the middle of a line
        resumed = self.finish("killed")
        self.assertEqual(log.read_text().splitlines()[:len(there)], there)
        self.assertEqual(items_of(resumed), items_of(whole))
        for name in ("summary.md", "summary.csv", "summary.svg"):
            if (whole / name).exists():
                self.assertEqual((resumed / name).read_bytes(), (whole / name).read_bytes(), name)

    def test_nothing_is_done_twice_and_more_can_be_added(self):
        results = self.finish("twice", keys=1)
        before = (results / "items.jsonl").read_bytes()
        self.finish("twice", keys=1)
        self.assertEqual((results / "items.jsonl").read_bytes(), before)
        self.finish("twice", keys=1, attacks="noise:0.2")
        after = (results / "items.jsonl").read_bytes()
        self.assertTrue(after.startswith(before))
        self.assertEqual(after.count(b"\n"), before.count(b"\n") + 3)  # two items and the command line
        summary = (results / "summary.md").read_text()
        self.assertIn("| noise:0.1 |", summary)
        self.assertIn("| noise:0.2 |", summary)

    def test_a_model_that_breaks_is_a_line_and_its_results_stay(self):
        results = self.finish("broken", keys=1, attacks="noise:0.1")
        folder = results.parent
        self.sample(FACES, "obj").rename(folder / "other.obj")
        (folder / "sample.ply").write_text("no mesh any more")
        done = subprocess.run([outside.WM3D, "bench", "-q", "--models", ".", "--out", "results", "--mrms", "0.05,0.1", "--effort", "0",
                               "--keys", "1", "--wrong-keys", "4", "--attacks", "noise:0.1"],
                              cwd=folder, capture_output=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(b"warning: ./sample.ply: ", done.stderr)
        summary = (results / "summary.md").read_text()
        self.assertIn("- sample.ply: ./sample.ply: the file does not begin", summary)
        self.assertIn("| attack | other | sample |", summary)

    def test_the_time_left_is_shown(self):
        source = self.sample(FACES)
        status, shown = outside.on_terminal(["bench", "--models", source, "--out", self.folder / "results", "--keys", "2",
                                             "--wrong-keys", "0", "--attacks", "noise:0.1,file"], 100, {})
        self.assertEqual(status, 0, shown)
        self.assertRegex(shown, r"\d of 8 items, \d+ s left \[#* *\] +\d+ %")


class Quick(outside.InFolder):
    """Three models, six attacks, one key: every mark has to be found, and wrong keys as rarely as p says."""

    def check(self, models, cells, *more):
        done = wm3d("bench", "--json", "-q", "--models", *models, "--out", self.folder / "results", "--strengths", "0.075",
                    "--keys", "1", "--wrong-keys", "50", "--attacks", QUICK_ATTACKS, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads(done.stdout)
        self.assertEqual(result["not_examined"], [])
        self.assertEqual(result["tables"], [{"size": "strength 0.075", "log10_target": -9.0, "cells": cells, "missed": 0}],
                         (self.folder / "results" / "summary.md").read_text())
        wrong = result["wrong_keys"]
        self.assertEqual(wrong["keys"], 50 * cells)
        self.assertGreater(wrong["p_uniformity"], 1e-4)
        for count in wrong["counts"]:
            self.assertGreater(count["p_found"], 1e-4, count)
            self.assertGreater(count["p_found_in_one"], 1e-4, count)


class QuickSample(Quick):
    def test_sample(self):
        self.check([self.sample(30000)], 6, "--reference")  # QuickModels has them of the size of scans


class QuickModels(Quick):
    def test_real_models(self):
        folder = pathlib.Path(os.environ.get("WM3D_MESHES", ""))
        models = [folder / name for name in QUICK_MODELS]
        missing = [str(model) for model in models if not model.exists()]
        if missing:
            self.skipTest(f"SKIPPED: {', '.join(missing)} is not there; WM3D_MESHES names the folder of models")
        self.check(models, 18)


def main():
    outside.WM3D = str(pathlib.Path(sys.argv[1]).resolve())
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(globals()[sys.argv[2]])
    return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
