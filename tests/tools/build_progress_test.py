#!/usr/bin/env python3
"""What is said of a build's and of a test run's output while one waits."""

import pathlib
import re
import subprocess
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / ".ci" / "build_progress.sh"


def progress(lines, unit):
    """What is passed on, and what is said."""
    command = f". '{SCRIPT}'; exec 4>&1; said=$(build_progress {unit} 3>&1 >&4); echo \"$said\" >&2"
    run = subprocess.run(["bash", "-c", command], input="".join(line + "\n" for line in lines),
                         capture_output=True, text=True, check=True)
    return run.stdout.splitlines(), [re.sub(r", \d+ s$", "", line).strip()
                                     for line in run.stderr.splitlines() if line]


class BuildProgress(unittest.TestCase):
    def test_ninja_has_a_line_for_each_tenth(self):
        lines = ["-- Configuring done", *(f"[{i}/200] Building a.o" for i in range(1, 201))]
        passed, said = progress(lines, "steps")
        self.assertEqual(lines, passed)
        self.assertEqual([f"{20 * i} of 200 steps" for i in range(1, 11)], said)

    def test_ctest_has_a_line_for_each_tenth(self):
        lines = [f"{i:4}/30 Test {'#' + str(i):>5}: a ........   Passed    0.01 sec"
                 for i in range(1, 31)]
        passed, said = progress(lines, "tests")
        self.assertEqual(lines, passed)
        self.assertEqual([f"{3 * i} of 30 tests" for i in range(1, 11)], said)

    def test_few_steps_have_few_lines(self):
        self.assertEqual(["1 of 2 steps", "2 of 2 steps"],
                         progress(["[0/1] Re-running", "[1/2] a", "[2/2] b"], "steps")[1])

    def test_nothing_to_do_is_not_said(self):
        self.assertEqual([], progress(["ninja: no work to do.", "see [1/2]"], "steps")[1])


if __name__ == "__main__":
    unittest.main()
