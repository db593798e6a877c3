#!/usr/bin/env python3
"""The package from outside. Needs numpy."""
import ast
import dataclasses
import gc
import os
import pathlib
import re
import signal
import tempfile
import threading
import time
import unittest

try:
    import numpy as np
except ImportError:
    print("SKIPPED: numpy is not installed")
    raise SystemExit

import wm3d

ROOT = pathlib.Path(__file__).parents[2]
KEY_TEXT = ROOT / "golden" / "mark" / "sample" / "test.key"
ANOTHER_KEY = ROOT / "tests" / "support" / "another.key"


def grid_faces(rows, columns):
    """Two triangles for each cell of a torus of rows by columns."""
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    a, b = i * columns + j, (i + 1) % rows * columns + j
    c, d = (i + 1) % rows * columns + (j + 1) % columns, i * columns + (j + 1) % columns
    return np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])


def bumpy_torus(rows=160, columns=96):
    """A torus with bumps that no turn maps onto itself: V, F."""
    u, v = np.meshgrid(np.arange(rows) * 2 * np.pi / rows, np.arange(columns) * 2 * np.pi / columns, indexing="ij")
    r = 0.35 + 0.05 * np.sin(3 * u + 1) * np.cos(2 * v) + 0.04 * np.cos(u + v) + 0.03 * np.sin(5 * v + 2 * u)
    rim = 1 + r * np.cos(v) + 0.12 * np.cos(2 * u + 0.4)
    V = np.stack([1.4 * rim * np.cos(u), rim * np.sin(u), r * np.sin(v) + 0.1 * np.cos(u - 0.3)], -1).reshape(-1, 3)
    return V, grid_faces(rows, columns)


class Marking(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.V, cls.F = bumpy_torus()
        cls.key = wm3d.Key.load(KEY_TEXT)
        cls.marked = wm3d.mark(cls.V, cls.F, cls.key)

    def test_a_mark_is_found_where_it_is_and_nowhere_else(self):
        report = wm3d.verify(self.marked.vertices, self.F, self.key)
        self.assertEqual(report.verdict, "present")
        self.assertLess(report.log10_p, -6)
        self.assertNotEqual(wm3d.verify(self.V, self.F, self.key).verdict, "present")
        self.assertNotEqual(wm3d.verify(self.marked.vertices, self.F, wm3d.Key.load(ANOTHER_KEY)).verdict, "present")

    def test_results_are_dataclasses(self):
        fields = dataclasses.asdict(self.marked)
        self.assertEqual(fields["vertices"].shape, self.V.shape)
        self.assertEqual(fields["vertices"].dtype, np.float64)
        with self.assertRaises(dataclasses.FrozenInstanceError):
            self.marked.level = 1

    def test_the_distortion_is_that_of_the_positions(self):
        diagonal = np.linalg.norm(self.V.max(0) - self.V.min(0))
        moves = np.linalg.norm(self.marked.vertices - self.V, axis=1)
        self.assertAlmostEqual(100 * moves.max() / diagonal, self.marked.max_percent, places=9)
        self.assertAlmostEqual(100 * np.sqrt((moves ** 2).mean()) / diagonal, self.marked.vertex_rms_percent, places=9)

    def test_strength_is_what_was_asked_for(self):
        marked = wm3d.mark(self.V, self.F, self.key, strength=0.02)
        self.assertAlmostEqual(marked.rms_percent, 0.02, delta=0.001)

    def test_visibility_is_a_limit(self):
        marked = wm3d.mark(self.V, self.F, self.key, visibility=0.05)
        self.assertAlmostEqual(marked.msdm2, 0.05, delta=0.005)
        self.assertEqual(marked.profile, "masked")
        self.assertLess(marked.rms_percent, self.marked.rms_percent)

    def test_a_payload_is_read_back(self):
        for payload in ("Inv 4711", "0xc0ffee"):
            marked = wm3d.mark(self.V, self.F, self.key, profile="robust", strength=0.2, payload=payload)
            report = wm3d.verify(marked.vertices, self.F, self.key)
            self.assertEqual(report.payload, payload)
            self.assertLess(report.payload_log10_p, -6)
        self.assertIsNone(wm3d.verify(self.V, self.F, self.key, effort=0).payload)

    def test_arrays_may_be_of_any_layout(self):
        for V, F in ((np.asfortranarray(self.V), self.F.astype(np.uint32)), (self.V[:, ::-1][:, ::-1], self.F.astype(">i8")),
                     (self.V.tolist(), self.F.tolist())):
            np.testing.assert_array_equal(wm3d.mark(V, F, self.key).vertices, self.marked.vertices)

    def test_the_original_is_a_reference(self):
        try:
            report = wm3d.verify(self.marked.vertices + [1, 2, 3], self.F, self.key, reference=(self.V, self.F))
        except wm3d.ParameterError as error:
            self.assertIn("Ceres", str(error))  # a build without it says so
            return
        self.assertEqual(report.verdict, "present")


class Files(unittest.TestCase):
    def test_a_file_keeps_all_but_its_coordinates(self):
        V, F = bumpy_torus()
        key = wm3d.Key.load(KEY_TEXT)
        with tempfile.TemporaryDirectory() as name:
            source, target = pathlib.Path(name, "in.obj"), pathlib.Path(name, "out.obj")
            lines = ["# a comment"] + [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in V] + ["g part"]
            lines += [f"f {a} {b} {c}" for a, b, c in F + 1]
            source.write_text("\n".join(lines) + "\n")
            result = wm3d.mark_file(source, target, key)
            self.assertTrue(result.written, result.reason)
            self.assertEqual(result.check.verdict, "present")
            others = [line for line in target.read_text().splitlines() if not line.startswith("v ")]
            self.assertEqual(others, [line for line in lines if not line.startswith("v ")])
            mesh = wm3d.read(target)
            self.assertEqual((mesh.format, mesh.vertices.shape, mesh.faces.shape), ("obj", V.shape, F.shape))
            self.assertEqual(wm3d.verify(mesh.vertices, mesh.faces, key).verdict, "present")
            with self.assertRaisesRegex(wm3d.OutputError, "exists"):
                wm3d.mark_file(source, target, key)
            receipt = pathlib.Path(name, "a.receipt")
            wm3d.mark_file(source, target, key, receipt=receipt, overwrite=True)
            part = mesh.faces[mesh.vertices[mesh.faces].mean(1)[:, 0] < 0.8]
            report = wm3d.verify(mesh.vertices, part, key, receipt=receipt, search="never")
            self.assertEqual((report.verdict, report.pose.startswith("receipt")), ("present", True), report)

    def test_keys(self):
        with tempfile.TemporaryDirectory() as name:
            key, path = wm3d.Key.generate("Größe"), pathlib.Path(name, "a.key")
            key.save(path)
            self.assertEqual(path.stat().st_mode & 0o777, 0o600)
            again = wm3d.Key.load(str(path))
            self.assertEqual((again.name, again.fingerprint), ("Größe", key.fingerprint))
            self.assertNotIn(key.commitment[:16], repr(key))
            self.assertIn(key.fingerprint, repr(key))
            with self.assertRaises(wm3d.OutputError):
                key.save(path)

    def test_a_passphrase_opens_its_key(self):
        with tempfile.TemporaryDirectory() as name:
            key, path = wm3d.Key.generate("shop"), pathlib.Path(name, "a.key")
            key.save(path, passphrase="open sesame")
            self.assertEqual(wm3d.Key.load(path, passphrase="open sesame").fingerprint, key.fingerprint)
            for passphrase in (None, "sesame"):
                with self.assertRaises(wm3d.InputError):
                    wm3d.Key.load(path, passphrase)


class Mistakes(unittest.TestCase):
    V, F = np.eye(3), np.array([[0, 1, 2]])

    def complaint(self, kind, code, *arguments, function=wm3d.mark, **keywords):
        with self.assertRaises(kind) as caught:
            function(*arguments, **keywords)
        self.assertIsInstance(caught.exception, wm3d.Error)
        self.assertEqual(caught.exception.code, code)
        sentence = str(caught.exception)
        self.assertNotIn("\n", sentence)
        return sentence

    def test_arrays(self):
        key = wm3d.Key.generate()
        wrong = wm3d.ParameterError, "bad_parameter"
        self.assertIn("(3,)", self.complaint(*wrong, self.V[0], self.F, key))
        self.assertIn("(3, 2)", self.complaint(*wrong, self.V[:, :2], self.F, key))
        self.assertIn("whole numbers", self.complaint(*wrong, self.V, self.F + 0.5, key))
        self.assertIn("real numbers", self.complaint(*wrong, self.V.astype(complex), self.F, key))
        self.assertIn("vertex 3", self.complaint(*wrong, self.V, self.F + 1, key))
        self.assertIn("vertex -1", self.complaint(*wrong, self.V, self.F - 1, key))
        self.assertIn("V[0]", self.complaint(wm3d.GeometryError, "unusable_geometry", self.V * np.nan, self.F, key))
        self.complaint(wm3d.GeometryError, "unusable_geometry", self.V * 0, self.F, key)
        self.complaint(wm3d.GeometryError, "unusable_geometry", np.zeros((0, 3)), np.zeros((0, 3), int), key)

    def test_settings(self):
        key = wm3d.Key.generate()
        for keywords in ({"pf": 0}, {"pf": float("nan")}, {"strength": -1}, {"gamma": float("inf")}, {"rmax": 0},
                         {"strength": 1, "gamma": 1}, {"strength": 1, "visibility": 0.1}, {"level": 99}, {"visibility": 2},
                         {"profile": "loud"}, {"payload": ""}, {"payload": "x" * 17}, {"payload": "0xg"}):
            self.complaint(wm3d.ParameterError, "bad_parameter", *bumpy_torus(20, 12), key, **keywords)
        with self.assertRaises(TypeError):
            wm3d.mark(self.V, self.F, "a key")
        for keywords in ({"search": "perhaps"}, {"effort": -1}, {"pf": 1}):
            self.complaint(wm3d.ParameterError, "bad_parameter", *bumpy_torus(20, 12), key, function=wm3d.verify, **keywords)
        self.complaint(wm3d.InputError, "unreadable_input", *bumpy_torus(20, 12), key, function=wm3d.verify,
                       receipt="/nowhere/a.receipt")

    def test_files(self):
        sentence = self.complaint(wm3d.InputError, "unreadable_input", "/nowhere/a.ply", function=wm3d.read)
        self.assertIn("/nowhere/a.ply", sentence)
        self.complaint(wm3d.InputError, "malformed_input", __file__, function=wm3d.Key.load)
        self.complaint(wm3d.ParameterError, "bad_parameter", __file__, "text", function=wm3d.read)


class Stubs(unittest.TestCase):
    """The types that editors and checkers read are those of the compiled module."""

    @staticmethod
    def taken(function):
        """Names of the arguments, as pybind11 tells them in the first line of the docstring."""
        return [name for name in re.findall(r"[(,] ?(\w+):", function.__doc__.splitlines()[0]) if name != "self"]

    @staticmethod
    def declared(node):
        return [argument.arg for argument in node.args.args + node.args.kwonlyargs if argument.arg != "self"]

    def test_every_function_is_declared_with_its_arguments(self):
        tree = ast.parse(pathlib.Path(wm3d.__file__).with_name("_core.pyi").read_text(encoding="utf-8"))
        functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
        self.assertEqual(set(functions), {name for name, value in vars(wm3d._core).items()
                                          if callable(value) and not isinstance(value, type)})
        for name, node in functions.items():
            self.assertEqual(self.declared(node), self.taken(getattr(wm3d._core, name)), name)
        key = next(node for node in tree.body if isinstance(node, ast.ClassDef) and node.name == "Key")
        members = {node.name: node for node in key.body if isinstance(node, ast.FunctionDef)}
        self.assertEqual(set(members), {name for name in vars(wm3d.Key) if not name.startswith("_")})
        for name in ("generate", "load", "save"):
            self.assertEqual(self.declared(members[name]), self.taken(getattr(wm3d.Key, name)), name)


class Patience(unittest.TestCase):
    """What happens while a call runs."""

    def setUp(self):
        self.V, self.F = bumpy_torus(240, 160)
        self.key = wm3d.Key.load(KEY_TEXT)

    def test_progress_goes_from_stage_to_stage(self):
        heard = []
        wm3d.verify(self.V, self.F, self.key, progress=lambda stage, done: heard.append((stage, done)))
        self.assertGreater(len(heard), 2)
        self.assertTrue(all(isinstance(stage, str) and 0 <= done <= 1 for stage, done in heard), heard)

    def test_what_progress_raises_stops_the_work(self):
        def stop(stage, done):
            raise LookupError(stage)
        with self.assertRaises(LookupError):
            wm3d.mark(self.V, self.F, self.key, progress=stop)

    def test_other_threads_run_meanwhile(self):
        ticks, stop = [], threading.Event()

        def tick():
            while not stop.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.01)
        thread = threading.Thread(target=tick)
        thread.start()
        begin = time.monotonic()
        wm3d.verify(self.V, self.F, self.key)
        end = time.monotonic()
        stop.set()
        thread.join()
        self.assertGreater(sum(begin < t < end for t in ticks), 3)

    def test_ctrl_c_is_heard(self):
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        begin = time.monotonic()
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            for _ in range(1000):
                wm3d.mark(self.V, self.F, self.key)
        self.assertLess(time.monotonic() - begin, 60)


class Growth(unittest.TestCase):
    """Many calls leave nothing behind."""

    @staticmethod
    def resident():
        gc.collect()
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def assert_no_growth(self, function, calls):
        for _ in range(calls // 10):
            function()
        before = self.resident()
        for _ in range(calls):
            function()
        self.assertLess(self.resident() - before, 8 << 20)

    def test_marks(self):
        V, F = bumpy_torus(24, 16)
        key = wm3d.Key.generate()
        self.assert_no_growth(lambda: wm3d.mark(V, F, key, level=3, progress=lambda *_: None), 200)

    def test_ten_thousand_arrays_in_and_out(self):
        V, F = bumpy_torus(24, 16)
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name, "a.off")
            rows = [" ".join(map(repr, row)) for row in V.tolist()] + [f"3 {a} {b} {c}" for a, b, c in F]
            path.write_text(f"OFF\n{len(V)} {len(F)} 0\n" + "\n".join(rows) + "\n")
            self.assert_no_growth(lambda: wm3d.read(path), 10_000)

    def test_ten_thousand_errors(self):
        V, F, key = np.zeros((300, 3)), np.zeros((500, 3), int), wm3d.Key.generate()

        def fail():
            with self.assertRaises(wm3d.GeometryError):
                wm3d.verify(V, F, key)
        self.assert_no_growth(fail, 10_000)


if __name__ == "__main__":
    unittest.main(verbosity=2)
