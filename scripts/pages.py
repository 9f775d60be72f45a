"""What the scripts that write documentation have in common: tables and markers in pages, and sheets of pictures."""

import subprocess

END = "<!-- end -->"
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"


def rows(table):
    """A table whose first row is its head."""
    lines = ["| " + " | ".join(row) + " |" for row in table]
    lines.insert(1, "|" + " --- |" * len(table[0]))
    return "\n".join(lines) + "\n"


def filled(page, script, texts):
    """The page with each text behind the marker of its name and of the script; None if it hasn't one of each, or one has no end."""
    if page.count(END) != page.count("<!-- scripts/"):
        return None
    for name, text in texts.items():
        begin = "<!-- scripts/%s: %s -->\n" % (script, name)
        if page.count(begin) != 1:
            return None
        before, behind = page.split(begin)
        page = before + begin + text + behind[behind.index(END):]
    return page


def sheet(tiles, size, across, output):
    """A JPEG of tiles: of each a label, the file of a picture, and of what is shown below it, or None: black."""
    command = ["oiiotool", "--nosoftwareattrib"]  # else the picture holds this command line with its paths
    for label, picture, below in tiles:
        command += [str(picture), "--resize", "%dx%d" % size, "--text:x=6:y=16:size=12:color=1,1,1:font=" + FONT, label]
        command += [str(below or picture), "--resize", "%dx%d" % size]
        if below is None:
            command += ["--mulc", "0,0,0"]
        command += ["--mosaic:pad=2", "1x2"]
    command += ["--mosaic:pad=4", "%dx%d" % (across, -(-len(tiles) // across)), "-d", "uint8", "--compression", "jpeg:85", "-o", str(output)]
    subprocess.run(command, check=True)
