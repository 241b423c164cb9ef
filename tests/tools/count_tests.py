#!/usr/bin/env python3
"""count_tests.py JUNIT_FILE: prints `PASSED FAILED SKIPPED` of a ctest run."""

import sys
import xml.etree.ElementTree as ElementTree


def counts(junit_text):
    """(passed, failed, skipped): a test that could not be run has failed."""
    passed = failed = skipped = 0
    for case in ElementTree.fromstring(junit_text).iter("testcase"):
        status = case.get("status")
        if status == "run":
            passed += 1
        elif status == "disabled":
            skipped += 1
        elif status == "notrun" and case.find("skipped") is not None and "SKIP_" in (
                case.find("skipped").get("message") or ""):
            skipped += 1
        else:
            failed += 1
    return passed, failed, skipped


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8", errors="replace") as junit:
        print(*counts(junit.read()))
