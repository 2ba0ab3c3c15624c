#!/usr/bin/env python3
"""Plays random input to the viewer for a while, then checks what it reported: no problem, no pixel that is not finite,
no growth of memory. Needs a display (DISPLAY), such as Xvfb's.

Usage: scripts/soak.py --program build/cpu-debug/ropelight --seconds 600 [--seed 1] [-- OPTIONS of ropelight view]
"""
import argparse
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

ASSETS = pathlib.Path(__file__).resolve().parent.parent / "assets"
SCENES = ["cornell", "cornell-caustics", "six-lights", "glass-caustic", "light-in-glass", "box-spheres-diffuse"]
VIEWS = ["ray", "path", "sppm", "indirect only", "direct by photons", "photons", "traversal heat", "gather count",
         "gather radius", "normals", "depth", "albedo"]
KEYS = ["c", "v", "p", "k", "i", "l", "t", "space", "period", "backspace", "r", "f", "1", "2", "3", "equal", "minus",
        "f1", "escape", "tab", "[", "]", "home"]


class Player:
    def __init__(self, seed, broken):
        self.random = random.Random(seed)
        self.broken = broken
        self.width, self.height = 1000, 760

    def place(self):
        return f"{self.random.randint(20, max(self.width - 420, 40))} {self.random.randint(20, self.height - 20)}"

    def command(self):
        r = self.random
        choices = [
            (6, lambda: f"drag {self.place()} {self.place()} {r.choice(['left', 'right', 'middle'])}"),
            (2, lambda: f"move {self.place()}\nwheel {r.choice([-2, -1, 1, 2])}"),
            (5, lambda: f"key {r.choice(KEYS)}"),
            (2, lambda: f"hold {r.choice('wasdqe')} {r.randint(2, 12)}"),
            (1, lambda: f"click {self.place()} left ctrl"),
            (1, lambda: f"key s ctrl"),
            (3, self.slider),
            (2, self.view),
            (1, self.scene),
            (1, self.resize),
            (2, lambda: f"wait seconds {r.uniform(0.05, 0.8):.2f}"),
        ]
        return r.choices([c for _, c in choices], [w for w, _ in choices])[0]()

    def slider(self):
        name, low, high = self.random.choice([
            ("photons", 500, 60000), ("alpha", 0.3, 1), ("nearest", 2, 100), ("cell-size", 0.5, 4)])
        value = self.random.uniform(low, high)
        whole = name not in ("alpha", "cell-size")
        return f"try set A/{name} {int(value) if whole else round(value, 3)}"

    def view(self):
        return f"try click view\ntry click view/{self.random.choice(VIEWS).replace(' ', '-')}"

    def scene(self):
        if self.random.random() < 0.3:
            return f"drop {self.broken}\nwait seconds 0.3\ndrop {ASSETS / (self.random.choice(SCENES) + '.json')}"
        return f"drop {ASSETS / (self.random.choice(SCENES) + '.json')}\nwait seconds 0.5"

    def resize(self):
        if self.random.random() < 0.3:
            return "resize 1 1\nframes 3\nresize 1000 760"
        self.width, self.height = self.random.randint(900, 1400), self.random.randint(600, 900)
        return f"resize {self.width} {self.height}"


def play(arguments, folder):
    broken = folder / "broken.json"
    broken.write_text('{"shapes": 7}')
    player = Player(arguments.seed, broken)
    lines = ["wait iterations 2", "state start.json"]
    for i in range(int(arguments.seconds * 12)):
        lines.append(player.command())
        if i % 40 == 39:
            lines.append(f"frames 2\nstate state-{i // 40:05d}.json")
    (folder / "soak.txt").write_text("\n".join(lines) + "\nquit\n")
    command = [str(pathlib.Path(arguments.program).resolve()), "view", "cornell", "--script", "soak.txt", "--no-preferences",
               "--state", "end.json", "--window", "1000x760", *arguments.options]
    process = subprocess.Popen(command, cwd=folder, stderr=subprocess.PIPE, text=True)
    start = time.time()
    try:
        _, errors = process.communicate(timeout=arguments.seconds)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=120)
    return process.returncode, errors, time.time() - start


def check(folder, code, errors):
    faults = [] if code == 0 else [f"exit code {code}"]
    if errors.strip():
        faults.append("standard error: " + errors.strip()[-2000:])
    states = [json.loads(f.read_text()) for f in sorted(folder.glob("state-*.json")) + [folder / "end.json"] if f.exists()]
    for state in states:
        for which in ("A", "B"):
            if state[which]["nonFinitePixels"] or state[which]["nonFiniteSamples"]:
                faults.append(f"frame {state['frames']}: {which} has values that are not finite")
            if state[which]["problem"]:
                faults.append(f"frame {state['frames']}: {which}: {state[which]['problem']}")
        if state["problem"] and not any(text in state["problem"] for text in ("broken.json", "no finished iteration")):
            faults.append(f"frame {state['frames']}: {state['problem']}")
    resident = [state["residentBytes"] / 2**20 for state in states]
    third = max(len(resident) // 3, 1)
    early, late = max(resident[third:2 * third] or resident), max(resident[2 * third:] or resident)
    # Caches fill in the first third; after it the most that is held may not rise by more than a tenth.
    if late > 1.1 * early + 16:
        faults.append(f"memory grew from {early:.0f} to {late:.0f} MiB")
    return faults, states, early, late


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", help="folder for what the run writes; a temporary one without it")
    parser.add_argument("options", nargs="*")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(arguments.keep or temporary).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        code, errors, seconds = play(arguments, folder)
        faults, states, early, late = check(folder, code, errors)
    frames = states[-1]["frames"] if states else 0
    print(f"soak: {seconds:.0f} s, {frames} frames, {states[-1]['scenesLoaded'] if states else 0} scenes, {len(states)} "
          f"states; at most {early:.0f} MiB in the second third, {late:.0f} in the last; seed {arguments.seed}")
    for fault in faults:
        print("soak: FAULT:", fault)
    sys.exit(1 if faults or not states else 0)


if __name__ == "__main__":
    main()
