#!/usr/bin/env python3
"""count_tests.py JUNIT_FILE [FOLDER]: prints `PASSED FAILED SKIPPED` of a ctest run.

What ctest ran as one test and has left NAME.xml of GoogleTest in FOLDER counts as its tests.
"""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def outcome(case):
    """Of a ctest test: 0 passed, 1 failed, 2 skipped. One that could not be run has failed."""
    status = case.get("status")
    if status == "run":
        return 0
    if status == "disabled":
        return 2
    skipped = case.find("skipped")
    if status == "notrun" and skipped is not None and "SKIP_" in (skipped.get("message") or ""):
        return 2
    return 1


def program_counts(gtest_text):
    """[passed, failed, skipped] of a program's own tests."""
    counted = [0, 0, 0]
    for case in ElementTree.fromstring(gtest_text).iter("testcase"):
        if case.find("failure") is not None:
            counted[1] += 1
        elif case.get("status") == "notrun" or case.get("result") == "skipped":
            counted[2] += 1
        else:
            counted[0] += 1
    return counted


def counts(junit_text, programs=None):
    """(passed, failed, skipped); programs: what some of ctest's tests left, by their names."""
    counted = [0, 0, 0]
    for case in ElementTree.fromstring(junit_text).iter("testcase"):
        result = outcome(case)
        own = (programs or {}).get(case.get("name"))
        if own is None:
            counted[result] += 1
            continue
        within = program_counts(own)
        # It may fail without a test to blame: at its end, of a leak.
        if result == 1 and within[1] == 0:
            within[1] = 1
        counted = [a + b for a, b in zip(counted, within)]
    return tuple(counted)


def read(path):
    return path.read_text(encoding="utf-8", errors="replace")


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    left = {path.stem: read(path) for path in folder.glob("*.xml")} if folder else {}
    print(*counts(read(pathlib.Path(sys.argv[1])), left))
