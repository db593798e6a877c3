#!/usr/bin/env python3
"""Marks one mesh with the executable and looks for the mark: round_trip.py WM3D MESH.

MESH is a file of the folder WM3D_MESHES, or "sample" for the built-in one. Checks that the mark is found with its
key, that neither the original nor another key shows one, that nothing in the file changed but coordinates, that
positions which coincided still do, and that the number of threads doesn't show in the bytes.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import mesh_bytes

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Published keys, so that what fails once fails again.
KEYS = {"owner": ROOT / "golden/mark/sample/test.key", "stranger": ROOT / "tests/support/another.key"}


class RoundTrip(unittest.TestCase):
    wm3d = None
    mesh = None

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="wm3d-round-trip-")
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = pathlib.Path(cls.temporary.name)
        if cls.mesh is None:
            cls.mesh = cls.folder / "sample.ply"
            cls.wm3d_does("sample", "-q", "-o", cls.mesh, "--faces", "40000")
        cls.marked = cls.folder / f"marked{cls.mesh.suffix}"
        for name, file in KEYS.items():
            shutil.copyfile(file, cls.folder / f"{name}.key")
            (cls.folder / f"{name}.key").chmod(0o600)
        cls.report = json.loads(cls.wm3d_does("mark", cls.mesh, "-o", cls.marked, "--key", cls.folder / "owner.key",
                                        "--json", "--threads", "2"))

    @classmethod
    def attempt(cls, *arguments):
        return subprocess.run([cls.wm3d, *map(str, arguments)], capture_output=True, text=True, timeout=600)

    @classmethod
    def wm3d_does(cls, *arguments):
        done = cls.attempt(*arguments)
        if done.returncode != 0:
            raise AssertionError(f"wm3d {' '.join(map(str, arguments))}: status {done.returncode}\n{done.stderr}")
        return done.stdout

    def verify(self, suspect, key):
        # By its own axes: the search of all poses takes minutes on what is open, and has tests of its own.
        done = self.attempt("verify", suspect, "--key", self.folder / f"{key}.key", "--resync", "pca", "--json")
        return done.returncode, json.loads(done.stdout) if done.stdout else done.stderr

    def test_the_mark_is_found_with_its_key(self):
        status, report = self.verify(self.marked, "owner")
        self.assertEqual(status, 0, report)
        self.assertEqual(report["verdict"], "present")
        self.assertLess(report["log10_p"], -6)

    def check_no_mark(self, suspect, key):
        status, report = self.verify(suspect, key)
        if report["largest_opening_percent"] > 0.6:  # the helmet's neck might be a cut
            self.assertEqual((status, report["verdict"]), (3, "inconclusive"), report)
            self.assertIn(report["reason"], ("opening", "power"))
        elif self.mesh.name == "thing-73416.stl":  # a usual mark might be missed here
            self.assertIn((status, report["verdict"]), ((1, "absent"), (3, "inconclusive")), report)
        else:
            self.assertEqual((status, report["verdict"]), (1, "absent"), report)

    def test_the_original_holds_no_mark(self):
        self.check_no_mark(self.mesh, "owner")

    def test_another_key_finds_no_mark(self):
        self.check_no_mark(self.marked, "stranger")

    def test_only_coordinates_differ(self):
        positions, rest = mesh_bytes.split(self.mesh.name, self.mesh.read_bytes())
        marked_positions, marked_rest = mesh_bytes.split(self.marked.name, self.marked.read_bytes())
        self.assertTrue(rest == marked_rest, "bytes outside the coordinates changed")
        self.assertEqual(len(positions), len(marked_positions))
        self.assertNotEqual(positions, marked_positions)

    def test_positions_that_coincided_still_do(self):
        before = mesh_bytes.split(self.mesh.name, self.mesh.read_bytes())[0]
        after = mesh_bytes.split(self.marked.name, self.marked.read_bytes())[0]
        place = {}
        for old, new in zip(before, after):
            self.assertEqual(place.setdefault(old, new), new, f"the seam at {old} opened")

    def test_the_move_is_as_small_as_asked_for(self):
        self.assertLessEqual(self.report["msdm2"], 0.10)
        self.assertLess(self.report["max_percent"], 1)

    def test_the_bytes_do_not_depend_on_the_number_of_threads(self):
        again = self.folder / f"again{self.mesh.suffix}"
        self.wm3d_does("mark", self.mesh, "-o", again, "--key", self.folder / "owner.key", "-q", "--threads", "1")
        self.assertTrue(again.read_bytes() == self.marked.read_bytes(), "one and two threads give different bytes")


def main():
    RoundTrip.wm3d = pathlib.Path(sys.argv[1]).resolve()
    if sys.argv[2] != "sample":
        RoundTrip.mesh = pathlib.Path(os.environ.get("WM3D_MESHES", ".")) / sys.argv[2]
        if not RoundTrip.mesh.exists():
            print(f"SKIPPED: there is no {RoundTrip.mesh}; WM3D_MESHES names the folder of the models")
            return 0
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(RoundTrip)
    return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
