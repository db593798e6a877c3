# SPDX-License-Identifier: GPL-3.0-or-later
"""What the generators share: 50-digit arithmetic, exact inputs, the layout of a vector file.

Inputs are IEEE doubles, printed with the shortest digits that give them back; a generator takes their exact values.
Expected values are decimal strings of 34 digits.
"""
import json
import pathlib
import sys

import mpmath
from mpmath import mp, mpf

mp.dps = 60  # ten guard digits beyond the fifty that count

U = 2.0**-53  # unit roundoff of double


def exact(x):
    """The double nearest to what x says, as an exact number."""
    return mpf(float(x))


def digits(x):
    return mpmath.nstr(x, 34, min_fixed=-5, max_fixed=20)


def expected(x):
    """Numbers, and lists of them, as decimal strings."""
    return [expected(y) for y in x] if isinstance(x, (list, tuple)) else digits(x)


class Numbers:
    """Repeatable doubles of few bits, uniform in [-1, 1]: a linear congruential generator, its upper 16 bits."""

    def __init__(self, seed):
        self.state = seed

    def __call__(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 48) / 2.0**15 - 1


class Suite:
    def __init__(self, equation, tolerances):
        self.equation = equation
        self.tolerances = tolerances  # quantity -> relative, absolute, why
        self.vectors = []

    def add(self, name, origin, inputs, values, absolute=None):
        """`absolute`: quantity -> absolute tolerance of this vector, where it depends on the inputs."""
        vector = {"id": f"eq{self.equation}-{len(self.vectors) + 1:03}-{name}", "origin": origin, "inputs": inputs,
                  "expected": {quantity: expected(value) for quantity, value in values.items()}}
        if absolute:
            vector["absolute"] = absolute
        assert all(quantity in self.tolerances for quantity in values), name
        self.vectors.append(vector)

    def text(self):
        head = {"equation": self.equation, "generator": f"spec/generate/eq_0{self.equation}.py",
                "digits": 34, "tolerances": self.tolerances}
        lines = [json.dumps(head, indent=1)[:-2] + ',\n "vectors": [']
        lines += [",\n".join("  " + json.dumps(vector) for vector in self.vectors)]
        return "\n".join(lines) + "\n ]\n}\n"

    def write(self):
        """Writes the file; with --check, compares it with the committed one and exits with 1 where they differ."""
        target = pathlib.Path(__file__).resolve().parent.parent / "vectors" / f"eq_0{self.equation}.json"
        if "--check" not in sys.argv:
            target.write_text(self.text(), encoding="ascii")
        elif target.read_text(encoding="ascii") != self.text():
            sys.exit(f"{target} is not what its generator writes: run it and review the difference")
