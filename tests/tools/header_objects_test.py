#!/usr/bin/env python3
"""Tests of header_objects.py: which headers a change can have reached."""

import pathlib
import tempfile
import unittest

from header_objects import touched


class Touched(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.headers = []

    def header(self, path, *includes):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("".join(f'#include "{name}"\n' for name in includes), encoding="utf-8")
        self.headers.append(path)

    def test_a_header_is_reached_by_what_it_includes_in_steps(self):
        self.header("lib/plastica/base/a.hpp")
        self.header("lib/plastica/model/b.hpp", "plastica/base/a.hpp")
        self.header("calibrate/fit/c.hpp", "plastica/model/b.hpp")
        self.header("calibrate/fit/d.hpp")
        self.assertEqual(["lib/plastica/base/a.hpp", "lib/plastica/model/b.hpp", "calibrate/fit/c.hpp"],
                         touched(self.root, self.headers, {"lib/plastica/base/a.hpp"}))
        self.assertEqual(["calibrate/fit/c.hpp"],
                         touched(self.root, self.headers, {"calibrate/fit/c.hpp"}))
        self.assertEqual([], touched(self.root, self.headers, {"calibrate/fit/fit.cpp"}))

    def test_what_is_no_header_of_a_library_leads_on(self):
        self.header("lib/plastica/a.hpp", "plastica/b.hpp")
        self.header("lib/plastica/b.hpp")
        self.assertEqual(["lib/plastica/a.hpp"],
                         touched(self.root, ["lib/plastica/a.hpp"], {"lib/plastica/b.hpp"}))


if __name__ == "__main__":
    unittest.main()
