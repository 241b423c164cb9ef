#!/usr/bin/env python3
"""Tests of tidy_units.py: which sources are read as one, and by which command."""

import pathlib
import tempfile
import unittest

from tidy_units import arguments_for, units_of, write_unit


class Units(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.commands = []
        self.unity("lib", "a.cpp", "b.cpp", "c.cpp")
        self.unity("tests", "x_test.cpp", "y_test.cpp")
        self.compiled("lib/kernel.cpp")

    def source(self, name):
        return str(self.root / name)

    def compiled(self, name):
        self.commands.append({"directory": str(self.root), "file": self.source(name),
                              "command": f"c++ -O3 -DNAME='\"{name}\"' -c {self.source(name)}"})

    def unity(self, folder, *names):
        file = self.root / folder / "Unity/unity_0_cxx.cxx"
        file.parent.mkdir(parents=True)
        file.write_text("".join(f'#include "{self.source(folder)}/{name}"\n' for name in names),
                        encoding="utf-8")
        self.compiled(f"{folder}/Unity/unity_0_cxx.cxx")

    def units(self, *names):
        return [of_unit for _, of_unit in
                units_of([self.source(name) for name in names], self.commands)]

    def test_sources_of_one_unit_of_the_build_are_read_at_once_in_its_order(self):
        self.assertEqual([[self.source("lib/a.cpp"), self.source("lib/c.cpp")],
                          [self.source("lib/kernel.cpp")], [self.source("tests/y_test.cpp")]],
                         self.units("lib/c.cpp", "lib/kernel.cpp", "lib/a.cpp", "tests/y_test.cpp"))

    def test_a_source_that_nothing_compiles_is_refused(self):
        with self.assertRaises(SystemExit):
            self.units("lib/forgotten.cpp")

    def test_the_command_is_that_of_the_build_with_another_source(self):
        self.assertEqual(["c++", "-O3", '-DNAME="lib/kernel.cpp"', "-c", "unit.cpp"],
                         arguments_for(self.commands[2], "unit.cpp"))

    def test_a_unit_stands_where_the_rules_of_its_folder_hold(self):
        (self.root / ".clang-tidy").write_text("of all", encoding="utf-8")
        (self.root / "tests/.clang-tidy").write_text("of tests", encoding="utf-8")
        (self.root / "tests/deep").mkdir()
        out = self.root / "build"
        unit = write_unit(self.root, out, 3, [self.source("tests/deep/x_test.cpp")])
        self.assertEqual(str(out / "tests/deep/unit_3.cpp"), unit)
        self.assertIn(f'#include "{self.source("tests/deep/x_test.cpp")}"',
                      pathlib.Path(unit).read_text(encoding="utf-8"))
        self.assertEqual("of tests", (out / "tests/.clang-tidy").read_text(encoding="utf-8"))
        self.assertFalse((out / ".clang-tidy").exists())


if __name__ == "__main__":
    unittest.main()
