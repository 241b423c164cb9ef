#!/usr/bin/env python3
"""What ctest writes for each outcome of a test, and where it is counted."""

import unittest

from count_tests import counts


def suite(*cases):
    return f"<testsuite>{''.join(cases)}</testsuite>"


PASSED = '<testcase name="a" status="run"><system-out>x</system-out></testcase>'
FAILED = '<testcase name="b" status="fail"><failure message=""/></testcase>'
SKIPPED = ('<testcase name="c" status="notrun">'
           '<skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/></testcase>')
DISABLED = '<testcase name="d" status="disabled"/>'
MISSING = ('<testcase name="e" status="notrun">'
           '<skipped message="Unable to find executable"/></testcase>')


class CountTests(unittest.TestCase):
    def test_each_outcome_is_counted_once(self):
        self.assertEqual((2, 1, 2), counts(suite(PASSED, FAILED, PASSED, SKIPPED, DISABLED)))

    def test_a_program_that_is_not_there_has_failed(self):
        self.assertEqual((0, 1, 0), counts(suite(MISSING)))

    def test_no_test_is_no_test_passed(self):
        self.assertEqual((0, 0, 0), counts(suite()))


if __name__ == "__main__":
    unittest.main()
