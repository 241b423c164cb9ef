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
PROGRAM = '<testcase name="p" status="{}"/>'
OF_PROGRAM = """<testsuites tests="5"><testsuite name="S">
<testcase name="a" status="run" result="completed"/>
<testcase name="b" status="run" result="completed">{}</testcase>
<testcase name="c" status="run" result="skipped"><skipped message=""/></testcase>
<testcase name="d" status="notrun" result="suppressed"/>
<testcase name="e" status="run" result="completed"/>
</testsuite></testsuites>"""


class CountTests(unittest.TestCase):
    def test_each_outcome_is_counted_once(self):
        self.assertEqual((2, 1, 2), counts(suite(PASSED, FAILED, PASSED, SKIPPED, DISABLED)))

    def test_a_program_that_is_not_there_has_failed(self):
        self.assertEqual((0, 1, 0), counts(suite(MISSING)))

    def test_no_test_is_no_test_passed(self):
        self.assertEqual((0, 0, 0), counts(suite()))

    def test_a_program_counts_as_its_own_tests(self):
        left = {"p": OF_PROGRAM.format("")}
        self.assertEqual((4, 0, 2), counts(suite(PASSED, PROGRAM.format("run")), left))

    def test_a_test_of_a_program_fails_once(self):
        left = {"p": OF_PROGRAM.format('<failure message="x"/><failure message="y"/>')}
        self.assertEqual((2, 1, 2), counts(suite(PROGRAM.format("fail")), left))

    def test_a_program_that_fails_at_its_end_has_one_failure_more(self):
        left = {"p": OF_PROGRAM.format("")}
        self.assertEqual((3, 1, 2), counts(suite(PROGRAM.format("fail")), left))

    def test_a_program_that_left_no_counts_is_one_test(self):
        self.assertEqual((0, 1, 0), counts(suite(PROGRAM.format("fail")), {"q": OF_PROGRAM}))


if __name__ == "__main__":
    unittest.main()
