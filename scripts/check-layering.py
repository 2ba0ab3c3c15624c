#!/usr/bin/env python3
"""Checks that every room includes only what its page allows, that no rooms include one another in a circle, and that
CUDA, GL and GLM stay where the design lets them.

A room is a folder with a page, README.md, whose line 'Includes:' names the rooms that it may include. The tests may
include anything.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOPS = ["accel", "app", "measure", "render"]
SOURCES = {".h", ".cpp", ".cu"}
MOST_FILES = 16
MOST_LINES = 320

CUDA = re.compile(
    r"\bcuda[A-Z]\w+|__(global|device|host|shared|constant|launch_bounds)__|__CUDA(CC|_ARCH)__"
    r'|#\s*include\s*[<"](cuda|cub/|thrust/|nvtx)'
)
CUDA_AT_HOME = re.compile(r"^(render/core/hd\.h|render/backend/.*|.*\.cu)$")
GL = re.compile(r'#\s*include\s*[<"](GL|GLES|GLFW|EGL|imgui|CLI)\b')
GLM = re.compile(r'#\s*include\s*[<"]glm/')
OURS = re.compile(r'^#\s*include\s*"([^"]+)"', re.M)

problems = []


def problem(place, text):
    problems.append(f"layering: {place}: {text}")


def files_below(top):
    return sorted(p for p in (ROOT / top).rglob("*") if p.suffix in SOURCES)


def room_of(path):
    return path.parent.relative_to(ROOT).as_posix()


def allowed_by(page):
    line = re.search(r"^Includes: *(.*)$", page.read_text(), re.M)
    if not line:
        problem(page.relative_to(ROOT), "there is no line 'Includes: …'; name the rooms, or write 'nothing'")
        return set()
    return set(re.findall(r"[\w/]+", line[1])) - {"nothing"}


def read_rooms():
    rooms = {}
    for top in TOPS:
        for room in {room_of(f) for f in files_below(top)}:
            page = ROOT / room / "README.md"
            if page.exists():
                rooms[room] = allowed_by(page)
            else:
                problem(room, "a folder with sources needs a README.md that says what it is for")
    return rooms


def check_includes(rooms):
    used = {room: set() for room in rooms}
    for top in TOPS:
        for path in files_below(top):
            room = room_of(path)
            for included in OURS.findall(path.read_text()):
                other = str(pathlib.PurePosixPath(included).parent)
                if other == room or room not in rooms:
                    continue
                used[room].add(other)
                if other not in rooms[room]:
                    problem(path.relative_to(ROOT), f"includes {included}, which the page of {room} does not allow")
    for room, allowed in rooms.items():
        for other in sorted(allowed - used[room]):
            problem(f"{room}/README.md", f"allows {other}, which nothing here includes")


def check_circles(rooms):
    done, path = set(), []

    def visit(room):
        if room in path:
            problem(room, "a circle of rooms: " + " -> ".join(path[path.index(room) :] + [room]))
            return
        if room in done or room not in rooms:
            return
        path.append(room)
        for other in sorted(rooms[room]):
            visit(other)
        path.pop()
        done.add(room)

    for room in sorted(rooms):
        visit(room)


def check_names():
    for top in TOPS + ["tests"]:
        for path in files_below(top):
            name = path.relative_to(ROOT).as_posix()
            for number, line in enumerate(path.read_text().splitlines(), 1):
                place = f"{name}:{number}"
                if CUDA.search(line) and not CUDA_AT_HOME.match(name):
                    if not (name == "render/core/vec.h" and "__CUDACC__" in line):
                        problem(place, "CUDA names belong in render/core/hd.h, render/backend/ and .cu files")
                if GL.search(line) and not name.startswith(("app/", "tests/")):
                    problem(place, "GL, windows and the command line belong in app/")
                if GLM.search(line) and name != "render/core/vec.h":
                    problem(place, "GLM is included by render/core/vec.h alone")


def check_sizes():
    for top in TOPS + ["tests"]:
        counts = {}
        for path in files_below(top):
            counts[room_of(path)] = counts.get(room_of(path), 0) + 1
            lines = len(path.read_text().splitlines())
            if lines > MOST_LINES:
                problem(path.relative_to(ROOT), f"{lines} lines; {MOST_LINES} at most: divide it")
        for room, count in sorted(counts.items()):
            if count > MOST_FILES:
                problem(room, f"{count} files; {MOST_FILES} at most: divide the room")


if __name__ == "__main__":
    rooms = read_rooms()
    check_includes(rooms)
    check_circles(rooms)
    check_names()
    check_sizes()
    print("\n".join(problems))
    sys.exit(bool(problems))
