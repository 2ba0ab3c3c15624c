#!/usr/bin/env python3
"""Prints the table of docs/stability.md from the JSON of `ropelight stress`.

    ropelight stress --json cpu.json; ropelight stress --backend cuda --json cuda.json
    scripts/stability-table.py cpu.json cuda.json
"""
import json
import math
import sys


def badness(m):
    allowed = m["bound"] + 4 * m["noise"]
    error = abs(m["value"] - m["expected"])
    return error / allowed if allowed > 0 else (math.inf if error > 0 else 0)


def cell(case):
    if case is None:
        return "not run"
    if case["verdict"] == "left out":
        return f"left out: {case['left out']}"
    worst = max(case["measurements"], key=badness)
    error = abs(worst["value"] - worst["expected"])
    at = f" at {worst['parameter']:.4g}" if case["parameter"] else ""
    within = f" within {worst['bound']:.2g}" if worst["bound"] > 0 else ""
    noise = f" ± {worst['noise']:.1g}" if worst["noise"] > 0 else ""
    return f"{case['verdict']}: {error:.2g}{noise}{within} ({worst['series'].split(', worst')[0]}{at})"


def main():
    runs = [json.load(open(name)) for name in sys.argv[1:]]
    if not runs:
        sys.exit(__doc__)
    for run in runs:
        print(f"- {run['backend']}: {run['device']}, seed {run['seed']}, {run['seconds']:.0f} s, {run['summary']}")
    print("\n| case | what makes it hard | measured against | " + " | ".join(r["backend"] for r in runs) + " |")
    print("|---|---|---|" + "---|" * len(runs))
    for case in runs[0]["cases"]:
        key = (case["family"], case["case"])
        same = [next((c for c in r["cases"] if (c["family"], c["case"]) == key), None) for r in runs]
        cells = " | ".join(cell(c).replace("|", "\\|") for c in same)
        print(f"| {case['family']}: {case['case']} | {case['hard']} | {case['reference']} | {cells} |")


main()
