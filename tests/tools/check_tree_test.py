#!/usr/bin/env python3
"""Each rule of check_tree.py, kept and broken, in small repositories made for it."""

import pathlib
import subprocess
import tempfile
import unittest

import check_tree


class CheckTree(unittest.TestCase):
    def breaches(self, **files):
        """Breaches in a repository of `files`: name with __ for / and _dot_ for . → text."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            subprocess.run(["git", "init", "-q", folder], check=True)
            for name, text in files.items():
                path = root / name.replace("__", "/").replace("_dot_", ".")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check_tree.breaches(root)

    def assert_one(self, found, words):
        self.assertEqual(len(found), 1, found)
        self.assertIn(words, found[0])

    def test_includes_upward_are_kept(self):
        self.assertEqual([], self.breaches(
            lib__plastica__law__a_dot_cpp='#include "plastica/base/check.hpp"\n',
            calibrate__fit__b_dot_cpp='#include "plastica/io/csv.hpp"\n#include "calibrate/x.hpp"\n',
            tests__lib__c_dot_cpp='#include "cli/x.hpp"\n#include "tests/support.hpp"\n'))

    def test_an_include_downward_is_a_breach_with_its_line(self):
        found = self.breaches(lib__plastica__law__a_dot_cpp='\n#include "plastica/io/csv.hpp"\n')
        self.assert_one(found, "lib/plastica/law/a.cpp:2: plastica/law must not include")

    def test_a_library_must_not_include_calibrate(self):
        found = self.breaches(lib__plastica__io__a_dot_cpp='#include "calibrate/target/x.hpp"\n')
        self.assert_one(found, "plastica/io must not include")

    def test_an_include_beside_the_file_is_a_breach(self):
        self.assert_one(self.breaches(cli__a_dot_cpp='#include "b.hpp"\n'), "from one of the roots")

    def test_a_product_must_not_include_the_tests(self):
        self.assert_one(self.breaches(cli__a_dot_cpp='#include "tests/b.hpp"\n'), "of the tests")

    def test_as_many_lines_as_a_folder_may_have_are_kept_and_one_more_is_a_breach(self):
        self.assertEqual([], self.breaches(cli__a_dot_cpp="//\n" * 350, tests__a_dot_cpp="//\n" * 400))
        self.assert_one(self.breaches(cli__a_dot_cpp="//\n" * 351), "351 lines")
        self.assert_one(self.breaches(tests__a_dot_cpp="//\n" * 401), "401 lines")

    def test_a_readme_of_251_lines_is_a_breach_and_another_page_is_not(self):
        self.assertEqual([], self.breaches(README_dot_md="a\n" * 250, docs__a_dot_md="a\n" * 251))
        self.assert_one(self.breaches(README_dot_md="a\n" * 251), "251 lines")

    def test_what_a_command_leaves_in_the_root_is_a_breach(self):
        self.assertEqual([], self.breaches(data__scene_dot_toml="a = 1\n"))
        self.assert_one(self.breaches(scene_dot_toml="a = 1\n"), "scene.toml: a command has left")

    def test_a_header_without_pragma_once_is_a_breach(self):
        self.assert_one(self.breaches(cli__a_dot_hpp="int a();\n"), "no #pragma once")

    def test_openmp_in_two_files_is_a_breach(self):
        loop = "#pragma omp parallel for\n"
        self.assertEqual([], self.breaches(lib__plastica__base__a_dot_cpp=loop))
        found = self.breaches(lib__plastica__base__a_dot_cpp=loop, lib__plastica__base__b_dot_cpp=loop)
        self.assert_one(found, "#pragma omp belongs in one file")

    def test_nlopt_in_a_header_is_a_breach(self):
        found = self.breaches(calibrate__a_dot_hpp="#pragma once\n#include <nlopt.hpp>\n")
        self.assert_one(found, "<nlopt.hpp> belongs in a .cpp")

    def test_hdf5_in_one_folder_is_kept_and_in_two_is_a_breach(self):
        include = "#include <hdf5.h>\n"
        self.assertEqual([], self.breaches(lib__plastica__io__hdf5__a_dot_cpp=include,
                                           lib__plastica__io__hdf5__b_dot_cpp=include))
        found = self.breaches(lib__plastica__io__a_dot_cpp=include, calibrate__b_dot_cpp=include)
        self.assert_one(found, "<hdf5.h> belongs in one folder")

    def test_udunits_in_two_files_is_a_breach(self):
        include = "#include <udunits2.h>\n"
        found = self.breaches(lib__plastica__io__a_dot_cpp=include, cli__b_dot_cpp=include)
        self.assert_one(found, "<udunits2.h> belongs in one file")

    def test_a_machines_path_is_a_breach_and_a_relative_path_is_not(self):
        self.assertEqual([], self.breaches(README_dot_md="../home/a data/root/b\n"))
        found = self.breaches(README_dot_md="see /" + "home/someone/file\n")
        self.assert_one(found, "README.md:1: '/" + "home/' is a machine's path")

    def test_a_link_to_a_file_a_folder_or_a_heading_is_kept(self):
        self.assertEqual([], self.breaches(
            README_dot_md="[a](docs/a.md#two-words-and-code) [b](docs) ![c](docs/c.svg)\n"
                          "[d](https://example.org/x) [e](#here) `[f](nowhere)`\n"
                          "```sh\necho '[g](nowhere)'\n```\n# Here\n",
            docs__a_dot_md="## Two words, and `code`\n[home](../README.md)\n", docs__c_dot_svg="<svg/>\n"))

    def test_a_link_that_leads_nowhere_is_a_breach_with_its_line(self):
        self.assert_one(self.breaches(README_dot_md="\n[a](docs/b.md)\n", docs__a_dot_md="# A\n"),
                        "README.md:2: the link docs/b.md leads nowhere")

    def test_a_link_to_a_heading_that_is_not_there_is_a_breach(self):
        self.assert_one(self.breaches(README_dot_md="[a](docs/a.md#b)\n", docs__a_dot_md="# A\n"),
                        "leads to no heading of docs/a.md")
        self.assert_one(self.breaches(README_dot_md="```\n# B\n```\n[b](#b)\n"), "no heading")

    def test_the_second_heading_of_a_name_has_a_number(self):
        self.assertEqual([], self.breaches(README_dot_md="# A\n# A\n[a](#a) [b](#a-1)\n"))

    def test_what_is_left_to_do_is_a_breach(self):
        self.assert_one(self.breaches(cli__a_dot_cpp="// TO" + "DO: mend\n"), "is left to do")

    def test_a_merge_that_was_not_ended_is_a_breach(self):
        self.assert_one(self.breaches(README_dot_md="<" * 7 + " HEAD\na\n"),
                        "README.md:1: '<<<<<" + "<<' is of a merge that was not ended")

    def test_an_ignored_file_is_not_read(self):
        self.assertEqual([], self.breaches(_dot_gitignore="/build/\n",
                                           build__a_dot_hpp="int a();\n"))

    def library(self, *, header="", installed="a.hpp", used="a.hpp", **more):
        """Breaches of a library that promises lib/plastica/base/a.hpp, beside b.hpp."""
        pragma = "#pragma once\n"
        return self.breaches(
            lib__plastica__README_dot_md="| `plastica/base/a.hpp` | all |\n",
            lib__plastica__base__a_dot_hpp=pragma + header, lib__plastica__base__b_dot_hpp=pragma,
            lib__plastica__base__CMakeLists_dot_txt=
                f"target_sources(x\n  PUBLIC FILE_SET HEADERS FILES\n {installed}\n  PRIVATE x.cpp)\n",
            tests__consumer__main_dot_cpp=f"#include <plastica/base/{used}>\n", **more)

    def test_a_library_that_installs_what_it_promises_is_kept(self):
        self.assertEqual([], self.library())
        self.assertEqual([], self.library(header='#include "plastica/base/b.hpp"\n',
                                          installed="a.hpp\n b.hpp"))

    def test_a_header_that_is_installed_for_nobody_is_a_breach(self):
        self.assert_one(self.library(installed="a.hpp\n b.hpp"), "lib/plastica/base/b.hpp: is installed")

    def test_a_header_that_a_promised_one_needs_is_installed(self):
        found = self.library(header='#include "plastica/base/b.hpp"\n')
        self.assert_one(found, "lib/plastica/base/b.hpp: is not installed")

    def test_a_promised_header_needs_no_other_library(self):
        self.assert_one(self.library(header="#include <Eigen/Core>\n"), "<Eigen/Core> would be needed")

    def test_the_consumer_includes_what_is_promised_and_all_of_it(self):
        found = self.library(used="b.hpp")
        self.assertEqual(2, len(found), found)
        self.assertIn("<plastica/base/b.hpp> is not promised", found[0])
        self.assertIn("no project of tests/consumer includes it", found[1])


if __name__ == "__main__":
    unittest.main()
