#!/usr/bin/env python3
"""Writes a closed, bumpy sphere as a Wavefront OBJ: the mesh of assets/bumpy.json.

The surface is P = R (sin t cos p, cos t, sin t sin p) with t in [0, pi], p in [0, 2 pi) and
R = 1 + 0.08 sin(17 p) sin(13 t) sin(t)^2 + 0.02 sin(71 p + 3) sin(67 t + 1) sin(t)^2.
Triangles are counter-clockwise seen from outside; there are 2 * segments * (bands - 1).
"""

import argparse
import math
import os
from pathlib import Path

DEFAULT_OUT = Path(__file__).resolve().parent.parent / "assets" / "generated" / "bumpy100k.obj"


def point(t, p):
    s = math.sin(t)
    r = 1 + 0.08 * math.sin(17 * p) * math.sin(13 * t) * s * s
    r += 0.02 * math.sin(71 * p + 3) * math.sin(67 * t + 1) * s * s
    return r * s * math.cos(p), r * math.cos(t), r * s * math.sin(p)


def vertices(segments, bands):
    """The north pole, then the rings from north to south, then the south pole."""
    yield 0.0, 1.0, 0.0
    for i in range(1, bands):
        for j in range(segments):
            yield point(math.pi * i / bands, 2 * math.pi * j / segments)
    yield 0.0, -1.0, 0.0


def triangles(segments, bands):
    """Vertex numbers from 1, as the OBJ format counts."""

    def ring(i, j):
        return 2 + (i - 1) * segments + j % segments

    south = 2 + (bands - 1) * segments
    for j in range(segments):
        yield 1, ring(1, j + 1), ring(1, j)
    for i in range(1, bands - 1):
        for j in range(segments):
            a, b = ring(i, j), ring(i, j + 1)
            c, d = ring(i + 1, j + 1), ring(i + 1, j)
            yield a, b, c
            yield a, c, d
    for j in range(segments):
        yield south, ring(bands - 1, j), ring(bands - 1, j + 1)


def write(out, segments, bands):
    """Under a temporary name first, so that an interrupted run leaves no half a mesh."""
    out.parent.mkdir(parents=True, exist_ok=True)
    temporary = out.with_name(f"{out.name}.{os.getpid()}.tmp")
    try:
        with open(temporary, "w", encoding="ascii") as f:
            f.write("# Made by scripts/make_bumpy_mesh.py\n")
            f.writelines(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in vertices(segments, bands))
            f.writelines(f"f {a} {b} {c}\n" for a, b, c in triangles(segments, bands))
        os.replace(temporary, out)
    finally:
        temporary.unlink(missing_ok=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--segments", type=int, default=320, help="around the axis, at least 3 (default %(default)s)")
    parser.add_argument("--bands", type=int, default=160, help="from pole to pole, at least 2 (default %(default)s)")
    parser.add_argument("--out", type=Path, default=DEFAULT_OUT, help="OBJ file to write (default %(default)s)")
    arguments = parser.parse_args()
    if arguments.segments < 3 or arguments.bands < 2:
        parser.error("a closed surface needs at least 3 segments and 2 bands")
    write(arguments.out, arguments.segments, arguments.bands)
    print(f"{arguments.out}: {2 * arguments.segments * (arguments.bands - 1)} triangles")


if __name__ == "__main__":
    main()
