#!/usr/bin/env python3
"""Prints registers, stack, spills and code size of every kernel that depends on the scene, and fails above the budget.

Each stage x kernel row is compiled for one architecture as the build compiles it, to device code alone; no GPU is
needed. Usage: scripts/kernels.py [--preset NAME] [--markdown FILE] [STAGE_ROW…], a CUDA preset (cuda-sm90).
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
# What a kernel may need: the most registers at which a multiprocessor holds 512 threads, and what its code may take of
# the caches. The last row has everything and may spill; of the others what is faster
# with more blocks and some bytes spilled (row::measured, docs/benchmarks/rooms.md), and TracePath, where the bound is tight.
REGISTERS = 128
# Raised, CODE by up to 42%, for aimed photons and grazed quads (docs/decisions.md, "Left for later"): to be brought down again.
SPILLS = {"basic": 96, "mesh": 144, "touching_mesh": 128, "full": 256, "all": 512}
CODE = {"basic": 136, "mesh": 156, "touching": 200, "touching_mesh": 344, "full": 184, "all": 776}  # KiB


def units(build):
    for entry in json.loads((build / "compile_commands.json").read_text()):
        name = pathlib.Path(entry["file"])
        match = re.fullmatch(r"cuda_([A-Za-z]+)_(\w+)\.cu", name.name)
        if match and name.parent.name == "instantiate":
            yield match[1], match[2], entry["command"]


def device_command(command, output):
    """The build's command, with its objects and dependency files replaced by device code and the assembler's report."""
    words = shlex.split(command)
    if os.path.basename(words[0]) == "ccache":
        words = words[1:]
    kept, skip = [], False
    for word in words:
        if skip:
            skip = False
        elif word in ("-o", "-MT", "-MF"):
            skip = True
        elif word not in ("-c", "-MD", "-rdc=false") and "-Xptxas" not in word:
            kept.append(word)
    return kept + ["-cubin", "-Xptxas", "-v", "-o", output]


def code_sizes(path):
    """Bytes of the .text section of each kernel in an ELF file of device code."""
    data = pathlib.Path(path).read_bytes()
    (offset,) = struct.unpack_from("<Q", data, 0x28)
    size, count, names = struct.unpack_from("<HHH", data, 0x3A)
    sections = [struct.unpack_from("<IIQQQQIIQQ", data, offset + i * size) for i in range(count)]
    text = lambda at: data[at : data.index(b"\0", at)].decode()
    found = {text(sections[names][4] + s[0]): s[5] for s in sections}
    return {name[len(".text.") :]: bytes_ for name, bytes_ in found.items() if name.startswith(".text.")}


def measure(stage, row, command, build):
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "kernel.cubin")
        run = subprocess.run(device_command(command, output), cwd=build, capture_output=True, text=True)
        if run.returncode:
            raise SystemExit(f"kernels: {stage} {row} does not compile:\n{run.stdout}{run.stderr}")
        report = run.stdout + run.stderr
        for name, bytes_ in code_sizes(output).items():
            if "runStage" not in name and "runBounded" not in name:
                continue
            part = report[report.index(f"'{name}'") :]
            stack, spill = map(int, re.search(r"(\d+) bytes stack frame, (\d+) bytes spill stores", part).groups())
            registers = int(re.search(r"Used (\d+) registers", part)[1])
            return {"stage": stage, "row": row, "registers": registers, "stack": stack, "spills": spill,
                    "code": bytes_ / 1024}
    raise SystemExit(f"kernels: {stage} {row}: no kernel in its device code")


def above_budget(k):
    problems = []
    if k["registers"] > REGISTERS:
        problems.append(f"{k['registers']} registers, {REGISTERS} at most")
    if k["spills"] > SPILLS.get(k["row"], 0):
        problems.append(f"{k['spills']} bytes spilled, {SPILLS.get(k['row'], 0)} at most")
    if k["code"] > CODE.get(k["row"], max(CODE.values())):
        problems.append(f"{k['code']:.0f} KiB of code, {CODE[k['row']]} at most")
    return problems


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--preset", default="cuda-sm90")
    options.add_argument("--markdown", help="also write the table to this file")
    options.add_argument("names", nargs="*", help="a stage, a row, or stage_row; all where none is given")
    args = options.parse_args()
    build = ROOT / "build" / args.preset
    if not (build / "compile_commands.json").exists():
        subprocess.run(["cmake", "--preset", args.preset], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    wanted = [u for u in units(build) if not args.names or {u[0], u[1], f"{u[0]}_{u[1]}"} & set(args.names)]
    if not wanted:
        raise SystemExit("kernels: no such kernel, or a build without CUDA")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        kernels = list(pool.map(lambda u: measure(*u, build), wanted))
    lines = ["| stage | row | registers | stack, bytes | spilled, bytes | code, KiB |", "|---|---|---|---|---|---|"]
    lines += [f"| {k['stage']} | {k['row']} | {k['registers']} | {k['stack']} | {k['spills']} | {k['code']:.0f} |"
              for k in kernels]
    print("\n".join(lines))
    if args.markdown:
        pathlib.Path(args.markdown).write_text("\n".join(lines) + "\n")
    failed = [f"kernels: {k['stage']} {k['row']}: {p}" for k in kernels for p in above_budget(k)]
    print("\n".join(failed))
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
