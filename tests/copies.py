#!/usr/bin/env python3
"""Copies and their entries: both or neither, whatever goes wrong. copies.py WM3D TestClass"""
import json
import pathlib
import resource
import shutil
import signal
import sqlite3
import sys
import unittest

import outside
from outside import InFolder, wm3d

KEY = pathlib.Path(__file__).parent.parent / "golden" / "mark" / "for-twice" / "test.key"  # no test depends on luck
PADDING = 400_000  # bytes that make a ledger larger than a copy, so that a limit can stop the one and not the other


class Entering(InFolder):
    """One size of file is all that the disk has room for."""

    def setUp(self):
        super().setUp()
        self.source, self.ledger = self.sample(4000), self.folder / "shop.ledger"
        self.owner = self.folder / "shop.key"
        shutil.copyfile(KEY, self.owner)
        self.owner.chmod(0o600)
        self.assertEqual(self.mark("Ann").returncode, 0)

    def mark(self, name, *options, **how):
        return wm3d("mark", self.source, "-o", self.folder / f"{name}.ply", "--key", self.owner, "--strength", "0.5",
                    "--for", name, "-q", *options, **how)

    def names(self):
        done = wm3d("ledger", "list", self.ledger, "--json")
        return [copy["recipient"] for copy in json.loads(done.stdout)["copies"]]

    def files(self):
        return {path.name for path in self.folder.iterdir()}

    def check_refused(self, done, before):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stderr.count(b"\n"), 1, done.stderr)
        self.assertIn(b"error: ", done.stderr)
        self.assertEqual(self.files(), before)
        self.assertEqual(self.names(), ["Ann"])
        self.assertEqual(wm3d("ledger", "check", self.ledger).returncode, 0)

    @staticmethod
    def limited(size):
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        return limit

    def grow_ledger(self):
        """Until no page is free and any entry of a new work needs another one. \\return the size"""
        with sqlite3.connect(self.ledger) as ledger:
            ledger.execute("CREATE TABLE padding (bytes)")
            ledger.execute("INSERT INTO padding VALUES (zeroblob(?))", (PADDING,))
        ledger.close()
        return self.ledger.stat().st_size

    def test_no_room_for_the_entry(self):
        self.assertEqual(wm3d("sample", "-q", "-o", self.folder / "other.ply", "--faces", 4400).returncode, 0)
        self.source = self.folder / "other.ply"
        size = self.grow_ledger()
        before = self.files()
        done = self.mark("Ben", preexec_fn=self.limited(size))
        self.check_refused(done, before)

        old = self.folder / "Ben.ply"
        old.write_bytes(b"what stood there")
        before = self.files()
        self.check_refused(self.mark("Ben", "--overwrite", preexec_fn=self.limited(size)), before)
        self.assertEqual(old.read_bytes(), b"what stood there")

        self.assertEqual(self.mark("Ben", "--overwrite").returncode, 0)
        self.assertEqual(self.names(), ["Ann", "Ben"])

    def test_no_room_for_the_copy(self):
        self.grow_ledger()
        before = self.files()
        self.check_refused(self.mark("Ben", preexec_fn=self.limited(20_000)), before)
        self.assertEqual(self.mark("Ben").returncode, 0)

    def test_no_ledger_can_be_made(self):
        before = self.files()
        done = self.mark("Ben", "--ledger", self.folder / "none" / "shop.ledger")
        self.check_refused(done, before)

    def test_a_locked_ledger_is_waited_for_and_then_refused(self):
        before = self.files()
        writer = sqlite3.connect(self.ledger, isolation_level=None)
        writer.execute("BEGIN IMMEDIATE")
        done = self.mark("Ben")
        writer.execute("ROLLBACK")
        writer.close()
        self.check_refused(done, before)
        self.assertIn(b"another program is writing", done.stderr)

    def test_a_newer_ledger_is_left_alone(self):
        with sqlite3.connect(self.ledger) as ledger:
            ledger.execute("PRAGMA user_version = 99")
        ledger.close()
        before, bytes_before = self.files(), self.ledger.read_bytes()
        done = self.mark("Ben")
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"use a newer wm3d", done.stderr)
        self.assertEqual(self.files(), before)
        self.assertEqual(self.ledger.read_bytes(), bytes_before)


if __name__ == "__main__":
    outside.WM3D = str(pathlib.Path(sys.argv[1]).resolve())
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(globals()[sys.argv[2]])
    sys.exit(0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1)
