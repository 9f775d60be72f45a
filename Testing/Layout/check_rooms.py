#!/usr/bin/env python3
"""check_rooms.py SOURCE: sees to it that the rooms of the source tree stay rooms.

- A file includes headers of its own room and of those below it only.
- No file of the module is longer than 600 lines.
- No class is another one's friend.
- A header begins with what it is for: without @class, @struct or @file the reference would leave that out.
"""
import pathlib
import re
import sys

ROOMS = {  # of each folder, from below: each may use those before it
    "Module": ("Core", "Storage", "Passes", "Study"),
    "Plugins/Command": ("Basics", "Models", "Scenes", "Techniques", "Report", "Study", "CommandLine"),
}
MOST_LINES = 600


def find_misplaced(folder, rooms):
    files = [file for room in rooms for file in sorted((folder / room).iterdir())]
    room_of = {file.name: file.parent.name for file in files}
    for file in files:
        text = file.read_text()
        for included in re.findall(r'^#include "(?:.*/)?([^"/]+)"', text, re.MULTILINE):
            room = room_of.get(included)
            if room and rooms.index(room) > rooms.index(file.parent.name):
                yield f"{file} includes {included} of {room}, expected no room above {file.parent.name}"
        for friend in re.findall(r"^\s*friend\s+(?:class|struct)\s+(\w+)", text, re.MULTILINE):
            yield f"{file} has the friend {friend}, expected none"


def find_long(module):
    for file in sorted(module.rglob("*")):
        if file.suffix in (".cxx", ".h", ".glsl"):
            lines = file.read_text().count("\n")
            if lines > MOST_LINES:
                yield f"{file} has {lines} lines, expected at most {MOST_LINES}"


def find_unnamed(folder):
    for file in sorted(folder.rglob("*.h")):
        text = file.read_text()
        if not re.search(rf"^/\*\*\n \* @(file|(class|struct) +{file.stem})$", text, re.MULTILINE):
            yield f"{file} begins with no comment of @class {file.stem}, @struct {file.stem} or @file"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    source = pathlib.Path(sys.argv[1])
    faults = [fault for folder, rooms in ROOMS.items() for fault in find_misplaced(source / folder, rooms)]
    faults += find_long(source / "Module")
    faults += [fault for folder in ("Module", "Plugins/ParaView") for fault in find_unnamed(source / folder)]
    for fault in faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if faults else 0)
