"""What a test of the command does: run it, and hold what it wrote and said against what was expected."""

import html.parser
import os
import re
import struct
import subprocess


def run(command, folder, arguments, environment=None):
    return subprocess.run(
        [command, *arguments], cwd=folder, env=environment, capture_output=True, text=True, timeout=100)


def changed(environment):
    """The environment with these changes: None where there shall be no such variable."""
    return {name: value for name, value in {**os.environ, **environment}.items() if value is not None}


def files_in(folder):
    return {str(path.relative_to(folder)) for path in folder.rglob("*")}


def fails(arguments, expected, environment=None):
    """The command ends with an error: one line that matches the expression, and no file written or left."""

    def case(command, folder):
        before = files_in(folder)
        result = run(command, folder, arguments, environment and changed(environment))
        assert result.returncode == 1, f"exit code {result.returncode}, stderr: {result.stderr}"
        lines = result.stderr.splitlines()
        assert len(lines) == 1, f"expected one line, got {result.stderr!r}"
        assert lines[0].startswith("translucency: error: "), lines[0]
        assert re.search(expected, lines[0]), f"expected {expected!r} in {lines[0]!r}"
        assert result.stdout == "", f"stdout: {result.stdout}"
        assert files_in(folder) == before, f"left behind: {files_in(folder) - before}"

    return case


def fails_without_windows(arguments, expected, environment):
    """The same where VTK finds neither EGL nor OSMesa, which it draws by without a display from release 9.4 on."""

    def case(command, folder):
        libraries = folder / "libraries"
        libraries.mkdir()
        for name in ("libEGL.so.1", "libEGL.so", "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
            (libraries / name).touch()  # which is found first, and can't be loaded
        fails(arguments, expected, {"LD_LIBRARY_PATH": str(libraries), "VTK_DEFAULT_OPENGL_WINDOW": None, **environment})(command, folder)

    return case


def warns(arguments, expected):
    """The command succeeds, and says one line that expected is found in."""

    def case(command, folder):
        result = run(command, folder, arguments)
        assert result.returncode == 0, f"exit code {result.returncode}, stderr: {result.stderr}"
        lines = result.stderr.splitlines()
        assert len(lines) == 1 and re.search(expected, lines[0]), f"expected {expected!r}, got {result.stderr!r}"

    return case


def succeeds(command, folder, arguments, environment=None):
    """What the command prints; it has to say nothing on stderr."""
    result = run(command, folder, arguments, environment)
    assert result.returncode == 0, f"exit code {result.returncode}, stderr: {result.stderr}"
    assert result.stderr == "", f"stderr: {result.stderr}"
    return result.stdout


SIGNATURES = {
    "png": b"\x89PNG\r\n\x1a\n",
    "exr": b"\x76\x2f\x31\x01",
    "tif": b"II*\0",
    "tiff": b"II*\0",
    "jpg": b"\xff\xd8\xff",
    "jpeg": b"\xff\xd8\xff",
}


def png_size(content):
    assert content.startswith(SIGNATURES["png"])
    return struct.unpack(">II", content[16:24])


def writes_picture(arguments, name, size=None):
    """The command writes a picture of the kind that its suffix says, and nothing else."""

    def case(command, folder):
        before = files_in(folder)
        succeeds(command, folder, [*arguments, "-o", name])
        assert files_in(folder) == before | {name}, files_in(folder) - before
        content = (folder / name).read_bytes()
        suffix = name.rsplit(".", 1)[1].lower()
        assert content.startswith(SIGNATURES[suffix]), content[:8]
        if size:
            assert png_size(content) == size, png_size(content)

    return case


class Page(html.parser.HTMLParser):
    """Counts the pictures of a page, checks that it needs no other file, and that what is opened is closed."""

    VOID = {"meta", "img", "input", "br", "link"}

    def __init__(self):
        super().__init__()
        self.pictures = 0
        self.open = []

    def handle_starttag(self, tag, attributes):
        if tag not in self.VOID:
            self.open.append(tag)
        for name, value in attributes:
            if name == "src":
                assert value.startswith("data:image/png;base64,"), value[:40]
                self.pictures += 1
            assert name != "href", value

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag, tag


def read_page(text):
    page = Page()
    page.feed(text)
    page.close()
    assert not page.open, page.open
    return page
