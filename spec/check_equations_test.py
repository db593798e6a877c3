#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of check_equations.py on a small tree made for the purpose, whole and with one fault at a time."""
import pathlib
import tempfile
import unittest

import check_equations

HEADER = "namespace wm3d::part {{\n/// Computes eq. ({0}).\ndouble f{0}(double x);\n}} // namespace wm3d::part\n"
ENTRY = """
[[equation]]
id = {0}
functions = ["wm3d::part::f{0}"]
test = "eq_0{0}_test.cpp"
vectors = "vectors/eq_0{0}.json"
generator = "generate/eq_0{0}.py"
"""


class CheckEquations(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for n in range(1, 7):
            self.write(f"modules/part/include/wm3d/part/f{n}.hpp", HEADER.format(n))
            self.write(f"spec/eq_0{n}_test.cpp", f'TEST_CASE("x") {{ part::f{n}(1); }}')
            self.write(f"spec/vectors/eq_0{n}.json", "{}")
            self.write(f"spec/generate/eq_0{n}.py", "")
        self.write("spec/equations.toml", "".join(ENTRY.format(n) for n in range(1, 7)))
        self.write("spec/CMakeLists.txt", "".join(f"wm3d_equation_test(0{n} part)\n" for n in range(1, 7)))
        self.write("cmd/main.cpp", "// prints eq. (4) to (6), and equations (1) and (2)\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def expect(self, *parts):
        found = list(check_equations.faults(self.root))
        self.assertEqual(len(found), 1, found)
        for part in parts:
            self.assertIn(part, found[0])

    def test_a_whole_tree_has_no_faults(self):
        self.assertEqual(list(check_equations.faults(self.root)), [])

    def test_a_missing_entry(self):
        self.write("modules/part/include/wm3d/part/f6.hpp", "")
        self.write("cmd/main.cpp", "")
        self.write("spec/equations.toml", "".join(ENTRY.format(n) for n in range(1, 6)))
        self.expect("equation (6) of the paper has no entry")

    def test_a_missing_vector_file(self):
        (self.root / "spec/vectors/eq_02.json").unlink()
        self.expect("equation (2)", "vectors/eq_02.json is missing")

    def test_a_test_that_calls_something_else(self):
        self.write("spec/eq_03_test.cpp", 'TEST_CASE("x") { part::g(1); }')
        self.expect("equation (3)", "never calls wm3d::part::f3")

    def test_a_test_that_is_not_built(self):
        self.write("spec/CMakeLists.txt", "".join(f"wm3d_equation_test(0{n} part)\n" for n in range(2, 7)))
        self.expect("equation (1)", "doesn't build its test")

    def test_a_function_that_is_gone(self):
        self.write("modules/part/include/wm3d/part/f5.hpp", HEADER.format(5).replace("f5(", "other("))
        self.expect("equation (5)", "no public header declares wm3d::part::f5")

    def test_a_function_of_another_namespace(self):
        self.write("modules/part/include/wm3d/part/f5.hpp", HEADER.format(5).replace("wm3d::part", "wm3d::other"))
        self.expect("equation (5)", "no public header declares wm3d::part::f5")

    def test_citations_of_unknown_equations(self):
        for text in ("// eq. (7)", "/// see Equation (7).", "// eq. (5) to (7)", "// equations (3), (7)", "// eq.\n// (7)"):
            with self.subTest(text):
                self.write("cmd/main.cpp", text)
                self.expect("cmd/main.cpp cites equation (7)")


if __name__ == "__main__":
    unittest.main()
