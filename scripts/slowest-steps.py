#!/usr/bin/env python3
"""Prints the ten slowest build steps and tests since a time, of some build folders.

Usage: scripts/slowest-steps.py SECONDS_SINCE_1970 BUILD_FOLDER…
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ET


def build_steps(folder, since):
    log = folder / ".ninja_log"
    if not log.exists():
        return
    for line in log.read_text().splitlines():
        if line.startswith("#"):
            continue
        start, end, made, output, _ = line.split("\t")
        if int(made) >= since * 1_000_000_000:
            name = re.sub(r"CMakeFiles/[^/]*\.dir/|\.o$", "", output)
            yield (int(end) - int(start)) / 1000, f"{folder.name}: {name}"


def test_steps(folder, since):
    results = folder / "tests.xml"
    if not results.exists() or results.stat().st_mtime < since:
        return
    for suite in ET.parse(results).iter("testcase"):
        for seconds, name in re.findall(r"^([\d.]+) s: (.*)$", suite.findtext("system-out") or "", re.M):
            yield float(seconds), f"{folder.name}: {name}"


if __name__ == "__main__":
    steps = set()
    for folder in map(pathlib.Path, sys.argv[2:]):
        steps.update(build_steps(folder, int(sys.argv[1])))
        steps.update(test_steps(folder, int(sys.argv[1])))
    print("The slowest steps:")
    for seconds, name in sorted(steps, reverse=True)[:10]:
        print(f"{seconds:8.1f} s  {name}")
