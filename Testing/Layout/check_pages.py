#!/usr/bin/env python3
"""check_pages.py SOURCE: sees to it that the documentation holds together.

- The pages of the techniques have the same headings, in the same order, and a paragraph before the first.
- Links between files of the source tree lead somewhere, to headings, too.
"""
import pathlib
import re
import sys

HEADINGS = ["Idea", "Source", "Equations", "Options", "Cost", "When not"]
INDEX = "README.md"
FOLDERS = ("Documentation", "Examples", "Module", "Packaging", "Plugins", "Testing")


def without_blocks(text):
    """The text with blocks of code left out: what looks like a heading there is none."""
    return re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)


def find_headings(folder):
    for file in sorted(folder.glob("*.md")):
        if file.name == INDEX:
            continue
        text = without_blocks(file.read_text())
        if not re.match(rf"# `{re.escape(file.stem)}`: \S.*\n\n\w", text):
            yield f"{file} does not begin with '# `{file.stem}`: its name' and a paragraph of what it is"
        found = re.findall(r"^## +(.*?) *$", text, re.MULTILINE)
        if found != HEADINGS:
            yield f"{file} has the headings {found}, expected {HEADINGS}"


def anchors(file):
    """GitHub's: in lower case, without punctuation, '-' for spaces, and numbered where they come again."""
    times = {}
    for heading in re.findall(r"^#+ +(.*?) *$", without_blocks(file.read_text()), re.MULTILINE):
        heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        anchor = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        times[anchor] = times.get(anchor, 0) + 1
        yield anchor if times[anchor] == 1 else f"{anchor}-{times[anchor] - 1}"


def find_broken_links(source):
    files = list(source.glob("*.md"))
    for folder in FOLDERS:
        files += (source / folder).rglob("*.md")
    for file in sorted(files):
        text = re.sub(r"`[^`\n]*`", "", without_blocks(file.read_text()))
        for target in re.findall(r"\]\(([^()\s]+)\)", text):
            if re.match(r"[a-z]+:", target):
                continue
            path, _, anchor = target.partition("#")
            linked = (file.parent / path).resolve() if path else file
            if not linked.exists():
                yield f"{file} links to {target}, where there is nothing"
            elif anchor and linked.suffix == ".md" and anchor not in anchors(linked):
                yield f"{file} links to {target}: {linked.name} has no such heading"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    source = pathlib.Path(sys.argv[1])
    faults = [*find_headings(source / "Documentation/Techniques"), *find_broken_links(source)]
    for fault in faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if faults else 0)
