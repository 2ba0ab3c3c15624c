#!/usr/bin/env python3
"""Sums up what ctest wrote about the suites: the messages of tests that could do nothing here, the ten slowest tests,
and, last, 'N passed, N failed, N skipped'. Fails where a test failed, or where one is in no suite.

Usage: scripts/test-summary.py JUNIT_FILE ALL EXPECTED    numbers of test cases: of the program, and of these suites
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ET

COUNT = re.compile(r"^\[doctest\] test cases: *\d+ \| *(\d+) passed \| *(\d+) failed", re.M)
DURATION = re.compile(r"^([\d.]+) s: (.*)$", re.M)


def main(path, total, expected):
    passed = failed = 0
    durations, messages, problems = [], {}, []
    if not pathlib.Path(path).exists():
        print(f"test: ctest ended before it wrote {path}\n0 passed, {expected} failed, {total - expected} skipped")
        return True
    for suite in ET.parse(path).iter("testcase"):
        text = suite.findtext("system-out") or ""
        counts = COUNT.findall(text)
        good = int(counts[-1][0]) if counts else 0
        bad = int(counts[-1][1]) if counts else 0
        if suite.get("status") != "run" and not bad:
            problems.append(f"{suite.get('name')} ended badly and no test case failed: it crashed, or a sanitizer spoke")
            bad = 1
        passed, failed = passed + good, failed + bad
        durations += [(float(seconds), name) for seconds, name in DURATION.findall(text)]
        for message in re.findall(r"skipped: .*", text):
            messages[message] = messages.get(message, 0) + 1
    if passed + failed != expected and not problems:
        problems.append(f"the suites ran {passed + failed} test cases of {expected}; see cmake/suites.cmake")
        failed += abs(expected - passed - failed)
    for message, times in messages.items():
        print(f"test: {message}" + (f" ({times} times)" if times > 1 else ""))
    print("The slowest tests:")
    for seconds, name in sorted(durations, reverse=True)[:10]:
        print(f"{seconds:8.1f} s  {name}")
    for problem in problems:
        print("test:", problem)
    print(f"{passed} passed, {failed} failed, {max(total - passed - failed, 0)} skipped")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3])))
