#!/usr/bin/env python3
"""Checks that every room includes only what its page allows, that no rooms include one another in a circle, that CUDA,
GL and GLM stay where the design lets them, and that folders, files and functions are of a size that can be read.

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
MOST_LINES_OF_FUNCTION = 60

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


LITERALS = re.compile(
    r'R"(?P<end>[^(\s]*)\(.*?\)(?P=end)"'  # a raw string
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9A-Za-z_])'(?:\\.|[^'\\\n])*'"  # not the mark between digits
    r"|//[^\n]*|/\*.*?\*/",
    re.S,
)
NAMESPACE = re.compile(r"(?:^|\s)(?:namespace(?:\s+[\w:]+)?|extern|TEST_SUITE\([^()]*\))$")
TYPE = re.compile(r"^\s*(?:template\s*<.*>\s*)?(?:class|struct|union|enum)\b[^()]*$", re.M)


def blank(match):
    return re.sub(r"[^\n]", " ", match[0])


def first_branches(text):
    """The text without directives, and of every #if its first branch alone."""
    lines, branches, continued = [], [], False
    for line in text.split("\n"):
        directive = re.match(r"\s*#\s*(\w+)", line)
        if directive and not continued:
            if directive[1].startswith("if"):
                branches.append(True)
            elif directive[1].startswith("el") and branches:
                branches[-1] = False
            elif directive[1] == "endif" and branches:
                branches.pop()
        hidden = bool(directive) or continued
        continued = hidden and line.endswith("\\")
        lines.append("" if hidden or not all(branches) else line)
    return "\n".join(lines)


def kind_of_brace(head):
    """What a brace after this text opens outside of functions. What stands in a namespace, a test suite or a type is
    still outside."""
    if NAMESPACE.search(head) or TYPE.search(re.sub(r"alignas\([^)]*\)", "", head)):
        return "members"
    return "data" if head.endswith("=") else "function"


def long_functions(text):
    """(first line, lines) of every function outside of other functions, from the line of its opening brace to the one
    of its closing brace, where there are too many."""
    text = first_branches(LITERALS.sub(blank, text))
    found, scopes, line, start = [], [], 1, 0
    for at, c in enumerate(text):
        if c == "\n":
            line += 1
        elif c == "{":
            outside = all(kind == "members" for kind, _ in scopes)
            scopes.append((kind_of_brace(text[start:at].strip()) if outside else "inside", line))
        elif c == "}" and scopes:
            kind, first = scopes.pop()
            if kind == "function" and line - first > MOST_LINES_OF_FUNCTION:
                found.append((first, line - first))
        if c in ";{}" and all(kind == "members" for kind, _ in scopes):
            start = at + 1
    if scopes:
        raise ValueError("braces that do not match")
    return found


def check_functions():
    for top in TOPS + ["tests"]:
        for path in files_below(top):
            name = path.relative_to(ROOT).as_posix()
            try:
                found = long_functions(path.read_text())
            except ValueError as error:
                problem(name, f"functions cannot be measured: {error}")
                continue
            for first, lines in found:
                problem(f"{name}:{first}", f"a function of {lines} lines; {MOST_LINES_OF_FUNCTION} at most: divide it")


if __name__ == "__main__":
    rooms = read_rooms()
    check_includes(rooms)
    check_circles(rooms)
    check_names()
    check_sizes()
    check_functions()
    print("\n".join(problems))
    sys.exit(bool(problems))
