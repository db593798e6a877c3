#!/usr/bin/env python3
import unittest

from closeness import agree, texts_agree


class Closeness(unittest.TestCase):
    def test_exact_where_nothing_is_tolerated(self):
        self.assertTrue(texts_agree("p = 1.25", "p = 1.25", 0))
        self.assertFalse(texts_agree("p = 1.25", "p = 1.26", 0))

    def test_decimals_may_stray(self):
        self.assertTrue(texts_agree("moved 0.0500 %", "moved 0.0502 %", 0.02))
        self.assertTrue(texts_agree("moved 0.1 %", "moved 0.2 %", 0.02))  # the last place that is printed
        self.assertFalse(texts_agree("moved 0.0500 %", "moved 0.0600 %", 0.02))

    def test_counts_and_words_may_not(self):
        self.assertFalse(texts_agree("20000 vertices", "20001 vertices", 0.02))
        self.assertFalse(texts_agree("present: 1.5", "absent: 1.5", 0.02))
        self.assertFalse(texts_agree("a 1.5", "a 1.5 2.5", 0.02))

    def test_probabilities_stray_in_their_logarithm(self):
        self.assertTrue(texts_agree("p = 3e-120", "p = 8e-121", 0.02))
        self.assertFalse(texts_agree("p = 3e-120", "p = 3e-12", 0.02))

    def test_files_and_status(self):
        self.assertTrue(agree("expected.files", "aa  out.ply\n", "bb  out.ply\n", 0.02))
        self.assertFalse(agree("expected.files", "aa  out.ply\n", "bb  out.ply\n", 0))
        self.assertFalse(agree("expected.files", "aa  out.ply\n", "aa  other.ply\n", 0.02))
        self.assertFalse(agree("expected.status", "1\n", "2\n", 0.02))


if __name__ == "__main__":
    unittest.main()
