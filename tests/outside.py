#!/usr/bin/env python3
"""The executable among other programs: terminals, pipes, damaged files. outside.py WM3D TestClass"""
import fcntl
import json
import math
import os
import pathlib
import pty
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import termios
import unittest

WM3D = None
ROOT = pathlib.Path(__file__).resolve().parent.parent
# Published keys, so that what fails once fails again.
KEYS = {"owner": ROOT / "golden/mark/sample/test.key", "other": ROOT / "tests/support/another.key"}


def wm3d(*arguments, **options):
    options.setdefault("timeout", 300)
    return subprocess.run([WM3D, *map(str, arguments)], capture_output=True, **options)


class InFolder(unittest.TestCase):
    """Runs in an empty folder that goes away."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="wm3d-outside-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def sample(self, faces=20000, suffix="ply"):
        path = self.folder / f"sample.{suffix}"
        self.assertEqual(wm3d("sample", "-q", "-o", path, "--faces", faces).returncode, 0)
        return path

    def key(self, name="owner"):
        path = self.folder / f"{name}.key"
        shutil.copyfile(KEYS[name], path)
        path.chmod(0o600)
        return path


def on_terminal(arguments, columns, environment, stream="stderr"):
    """What a command writes to a terminal of some width that is one of its streams."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    streams = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, stream: theirs}
    process = subprocess.Popen([WM3D, *map(str, arguments)], stdin=subprocess.DEVNULL, **streams,
                               env={**os.environ, "TERM": "xterm", **environment})
    os.close(theirs)
    shown = b""
    while True:
        try:
            block = os.read(ours, 4096)
        except OSError:  # the other end is closed
            break
        if not block:
            break
        shown += block
    os.close(ours)
    return process.wait(), shown.decode()


class Terminals(InFolder):
    def simplify(self, columns, *more, **environment):
        self.source = getattr(self, "source", None) or self.sample(60000)
        return on_terminal(["simplify", self.source, "-o", self.folder / "x.ply", "--vertices", 100, "--overwrite",
                            *more], columns, environment)

    def test_progress_is_one_line_that_disappears(self):
        status, shown = self.simplify(80)
        self.assertEqual(status, 0)
        self.assertIn(" %", shown)
        before, message = shown.rsplit("\r\033[K", 1)
        self.assertNotIn("\n", before)
        self.assertTrue(message.startswith("Wrote "), message)

    def test_narrow_terminals_are_not_overrun(self):
        status, shown = self.simplify(20)
        self.assertEqual(status, 0)
        for line in shown.split("\r\033[K")[:-1]:
            self.assertLess(len(line), 20)

    def test_help_fits_the_terminal(self):
        overview = on_terminal(["--help"], 40, {}, "stdout")[1]
        names = re.findall(r"^  ([a-z]+) ", overview, re.MULTILINE)
        self.assertIn("verify", names)
        for arguments in [["--help"], *([name, "--help"] for name in names)]:
            for width, environment in ((40, {}), (66, {}), (300, {}), (300, {"COLUMNS": "50"}), (0, {})):
                shown = on_terminal(arguments, width, environment, "stdout")[1].replace("\r", "")
                widest = max(map(len, shown.splitlines()))
                self.assertLessEqual(widest, min(100, int(environment.get("COLUMNS", width)) or 100), arguments)
                words = shown.replace("\\\n", "").split()
                self.assertEqual(words, wm3d(*arguments).stdout.decode().replace("\\\n", "").split())

    def test_quiet_and_dumb_terminals_see_no_progress(self):
        self.assertEqual(self.simplify(80, "-q"), (0, ""))
        self.assertNotIn("\033", self.simplify(80, TERM="dumb")[1])

    def test_no_color_is_respected(self):
        colour = on_terminal(["info", "nothing.ply"], 80, {})[1]
        plain = on_terminal(["info", "nothing.ply"], 80, {"NO_COLOR": "1"})[1]
        self.assertIn("\033[1;31merror:\033[0m", colour)
        self.assertNotIn("\033", plain)

    def test_without_a_terminal_there_is_no_control_character(self):
        done = wm3d("simplify", self.sample(), "-o", self.folder / "x.ply", "--vertices", 100)
        self.assertNotIn(b"\033", done.stdout + done.stderr)
        self.assertNotIn(b"\r", done.stdout + done.stderr)


class Pipes(InFolder):
    def test_a_reader_that_leaves_early_sees_no_message(self):
        source = self.sample()
        for command in (["sample", "-o", "-", "--format", "obj"],
                        ["simplify", source, "-o", "-", "--format", "obj", "--vertices", "9000"],
                        ["sphere", "-o", "-", "--format", "ply", "--level", "6"]):
            process = subprocess.Popen([WM3D, *map(str, command), "-q"], stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE)
            self.assertEqual(len(process.stdout.read(10)), 10)
            process.stdout.close()
            self.assertEqual(process.stderr.read(), b"")
            process.stderr.close()
            self.assertIn(process.wait(), (0, 2))  # 0: everything fitted into the pipe before it closed

    def test_mark_and_verify_work_as_filters(self):
        key, data = self.key(), self.sample().read_bytes()
        marked = wm3d("mark", "-", "-o", "-", "--format", "ply", "--key", key, input=data)
        self.assertEqual(marked.returncode, 0, marked.stderr)
        self.assertEqual(len(marked.stdout), len(data))
        self.assertEqual(wm3d("verify", "-", "--format", "ply", "--key", key, input=marked.stdout).returncode, 0)
        self.assertEqual(wm3d("verify", "-", "--format", "ply", "--key", key, input=data).returncode, 1)

    def test_closed_standard_streams_do_no_harm(self):
        source, target = self.sample(), self.folder / "x.ply"
        script = '"$0" simplify "$1" -o "$2" --vertices 100 --json <&- >&- 2>&-'
        done = subprocess.run(["sh", "-c", script, WM3D, source, target])
        self.assertEqual(done.returncode, 2)  # the JSON could not be delivered
        self.assertTrue(target.read_bytes().startswith(b"ply\nformat binary_little_endian"))
        self.assertNotIn(b"schema", target.read_bytes())


def facets(path):
    """(normal, corners) of every facet of a binary STL file."""
    data = path.read_bytes()
    for at in range(84, len(data), 50):
        numbers = struct.unpack_from("<12f", data, at)
        yield numbers[:3], (numbers[3:6], numbers[6:9], numbers[9:])


def area_vector(corners):
    (ax, ay, az), (bx, by, bz) = ([p - o for p, o in zip(point, corners[0])] for point in corners[1:])
    return ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx


def cosine(a, b):
    return sum(map(float.__mul__, a, b)) / (math.hypot(*a) * math.hypot(*b))


class Marking(InFolder):
    def test_a_mesh_too_small_leaves_nothing_behind(self):
        source, key, target = self.sample(2000), self.key(), self.folder / "marked.ply"
        done = wm3d("mark", source, "-o", target, "--key", key, "--strength", "0.001")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertFalse(target.exists())
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["owner.key", "sample.ply"])

    def test_outputs_and_inputs_are_never_lost(self):
        source, key = self.sample(), self.key()
        before = source.read_bytes()
        self.assertEqual(wm3d("mark", source, "-o", source, "--key", key).returncode, 2)
        self.assertEqual(source.read_bytes(), before)
        self.assertEqual(wm3d("mark", source, "-o", source, "--key", key, "--overwrite").returncode, 0)
        self.assertEqual(wm3d("verify", source, "--key", key).returncode, 0)

    def test_exit_zero_leaves_the_verdict_to_the_output(self):
        done = wm3d("verify", self.sample(), "--key", self.key(), "--exit-zero", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(b'"verdict": "absent"', done.stdout)

    def test_normals_are_kept_or_recomputed(self):
        source, key = self.sample(8000, "stl"), self.key()
        for mode in ("keep", "recompute"):
            marked = self.folder / f"{mode}.stl"
            done = wm3d("mark", source, "-o", marked, "--key", key, "--strength", "0.1", "--normals", mode)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(wm3d("verify", marked, "--key", key).returncode, 0)
        kept, recomputed = (list(facets(self.folder / f"{mode}.stl")) for mode in ("keep", "recompute"))
        self.assertEqual([normal for normal, _ in kept], [normal for normal, _ in facets(source)])
        self.assertEqual([corners for _, corners in kept], [corners for _, corners in recomputed])
        for normal, corners in recomputed:
            self.assertGreater(cosine(normal, area_vector(corners)), 0.99999)
        self.assertLess(min(cosine(normal, area_vector(corners)) for normal, corners in kept), 0.999)

    def test_the_receipt_knows_its_two_files(self):
        key, receipt = self.key(), self.folder / "receipt"
        for suffix in ("ply", "obj", "stl", "off", "glb"):
            source, marked, other = (self.folder / f"{name}.{suffix}" for name in ("sample", "marked", "other"))
            self.sample(8000, suffix)
            self.assertEqual(wm3d("mark", source, "-o", marked, "--key", key, "--receipt", receipt,
                                  "--strength", "0.1", "--overwrite").returncode, 0)
            wm3d("mark", source, "-o", other, "--key", key, "--strength", "0.11")
            for file, expected in ((source, "original"), (marked, "marked"), (other, "other")):
                done = wm3d("verify", file, "--key", key, "--receipt", receipt, "--json")
                self.assertEqual(json.loads(done.stdout)["receipt"], {"file": expected}, file)

    def test_a_key_that_others_can_read_is_warned_of(self):
        source, key = self.sample(2000), self.key()
        for mode, warned in ((0o600, False), (0o400, False), (0o640, True), (0o604, True)):
            key.chmod(mode)
            message = wm3d("verify", source, "--key", key).stderr.decode()
            self.assertEqual("chmod 600" in message, warned, message)
            self.assertLessEqual(message.count("\n"), 1)

    def test_a_new_key_is_for_its_owner_alone(self):
        path = self.folder / "owner.key"
        self.assertEqual(wm3d("keygen", "-q", path).returncode, 0)
        self.assertEqual(path.stat().st_mode & 0o777, 0o600)


class Hostile(InFolder):
    """Damaged files of every format: an answer or one sentence, never a crash, never for long."""

    def check(self, path):
        done = wm3d("info", path, timeout=60)
        self.assertIn(done.returncode, (0, 2), f"{path.name}: {done.stderr!r}")
        if done.returncode == 2:
            message = done.stderr.decode("utf-8", "replace")
            self.assertTrue(message.startswith("wm3d info: error: "), message)
            self.assertEqual(message.count("\n"), 1, message)
            self.assertNotIn("internal error", message)

    def damaged(self, suffix):
        random.seed(suffix)
        original = self.sample(2000, suffix).read_bytes()
        for cut in (0, 1, 10, 83, 84, 85, len(original) // 2, len(original) - 1):
            yield original[:cut]
        for _ in range(12):
            data = bytearray(original)
            for _ in range(random.choice((1, 3, 30))):
                data[random.randrange(min(len(data), random.choice((100, 1000, len(data)))))] = random.randrange(256)
            yield bytes(data)
        yield original + original
        yield bytes(random.randrange(256) for _ in range(5000))

    def check_format(self, suffix):
        for number, data in enumerate(self.damaged(suffix)):
            path = self.folder / f"damaged-{number}.{suffix}"
            path.write_bytes(data)
            self.check(path)

    def test_obj(self):
        self.check_format("obj")

    def test_ply(self):
        self.check_format("ply")

    def test_stl(self):
        self.check_format("stl")

    def test_off(self):
        self.check_format("off")

    def test_gltf(self):
        self.check_format("gltf")

    def test_glb(self):
        self.check_format("glb")


def main():
    global WM3D
    WM3D = str(pathlib.Path(sys.argv[1]).resolve())
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(globals()[sys.argv[2]])
    return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
