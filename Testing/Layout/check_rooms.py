#!/usr/bin/env python3
"""check_rooms.py FOLDER: sees to it that the rooms of the module (Module's folders) stay rooms.

- A file includes headers of its own room and of those below it only: Core, Storage, Passes, Study, each may use those before it.
- No file is longer than 600 lines.
- No class is another one's friend.
"""
import pathlib
import re
import sys

ROOMS = ("Core", "Storage", "Passes", "Study")  # each may use those before it
MOST_LINES = 600


def find_faults(module):
    files = [file for room in ROOMS for file in sorted((module / room).iterdir())]
    room_of = {file.name: file.parent.name for file in files}
    for file in files:
        text = file.read_text()
        for included in re.findall(r'^#include "(?:.*/)?([^"/]+)"', text, re.MULTILINE):
            room = room_of.get(included)
            if room and ROOMS.index(room) > ROOMS.index(file.parent.name):
                yield f"{file} includes {included} of {room}, expected no room above {file.parent.name}"
        for friend in re.findall(r"^\s*friend\s+(?:class|struct)\s+(\w+)", text, re.MULTILINE):
            yield f"{file} has the friend {friend}, expected none"
    for file in files + sorted((module / "Shaders").rglob("*.glsl")):
        lines = file.read_text().count("\n")
        if lines > MOST_LINES:
            yield f"{file} has {lines} lines, expected at most {MOST_LINES}"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    faults = list(find_faults(pathlib.Path(sys.argv[1])))
    for fault in faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if faults else 0)
