"""Runs the programs that are there and use VTK, unmodified, as they are and under `translucency run --always`, and puts their pictures side
by side.

    unmodified_programs.py --command TRANSLUCENCY [--application BLENDS] [--only NAME ...] FOLDER

All draw the balls of programs/balls.py, those that ask for peeling too: there it is said how far that is from --always. FOLDER/index.html
shows the pictures; FOLDER/table.txt has the figures, and FOLDER/Programs.png the pictures of Documentation/Programs.md: above as they are, below
by --always, in the order of the table. BLENDS is the application in C++ that is built with the tests. A program that is not
installed is left out, and named. A display is needed.
"""

import argparse
import importlib.util
import pathlib
import shutil
import subprocess
import sys
from typing import NamedTuple

from pictures import difference, montage, page, read

PROGRAMS = pathlib.Path(__file__).parent / "programs"
sys.path.insert(0, str(PROGRAMS))
from balls import OPACITY, SIZE  # noqa: E402

FILE = "{file}"
MODEL = "{model}"
RANKS = (1, 2, 4)


class Program(NamedTuple):
    needs: str      # a command on PATH, or a module of this Python behind "import "
    words: list     # with FILE for the picture
    peeling: list   # the words with which it asks for depth peeling; None where it can't be told to


def script(name, *words):
    return str(PROGRAMS / name), FILE, *words


def list_programs(application):
    programs = {
        "VTK, a script in Python": Program("import vtkmodules", [sys.executable, *script("vtk_script.py")], ["peeling"]),
        "PyVista": Program("import pyvista", [sys.executable, *script("pyvista_script.py")], ["peeling"]),
        "vedo": Program("import vedo", [sys.executable, *script("vedo_script.py")], ["peeling"]),
        "F3D": Program("f3d", ["f3d", MODEL, f"--output={FILE}", "--resolution={},{}".format(*SIZE), f"--opacity={OPACITY}", "--no-config",
                               "--scalar-coloring", "--coloring-array=Colors", "--coloring-component=-2"], ["--blending=ddp"]),
        "F3D, its package of Python": Program("import f3d", [sys.executable, *script("f3d_script.py", MODEL)], ["peeling"]),
    }
    # ParaView's scripts find balls.py by PYTHONPATH only.
    paraview = ["env", f"PYTHONPATH={PROGRAMS}"]
    programs["ParaView's window"] = Program("paraview", [*paraview, f"PICTURE={FILE}", "paraview", f"--script={PROGRAMS / 'paraview_script.py'}"], None)
    programs["pvpython"] = Program("pvpython", [*paraview, "pvpython", *script("paraview_script.py")], ["peeling"])
    for ranks in RANKS:
        mpi = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(ranks)]
        programs[f"pvbatch, {ranks} ranks"] = Program("pvbatch", [*paraview, *mpi, "pvbatch", *script("paraview_script.py")], ["peeling"])
    if application:
        programs["VTK, an application in C++"] = Program(application, [application, FILE, "viewer"], ["peeling"])
    return programs


def is_there(program):
    if program.needs.startswith("import "):
        return importlib.util.find_spec(program.needs.split()[1])
    return shutil.which(program.needs)


def draw(words, file, model):
    """Runs a program. Gives its picture, if it has written one, and what the drop-in or the program's failure has to say."""
    file.unlink(missing_ok=True)
    words = [str(word).format(file=file, model=model) for word in words]
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=300, cwd=file.parent)
    except subprocess.TimeoutExpired:
        return None, ["it did not end within 300 s"]
    said = [line for line in done.stderr.splitlines() if line.startswith("translucency run:")]
    if not file.exists():
        return None, [*said, f"no picture, status {done.returncode}: " + " ".join(done.stderr.split()[-40:])]
    picture = read(file)
    if (picture == picture[0, 0]).all():
        said.append(f"{file.name} is of one colour")
    return picture, said


def compare(a, b):
    if a is None or b is None:
        return "no picture"
    share, largest = difference(a, b)
    return f"{share:.2%} of pixels within 3/255, largest {largest}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", type=pathlib.Path, required=True, help="the built translucency")
    parser.add_argument("--application", type=pathlib.Path, help="the built blends")
    parser.add_argument("--technique", default="exact")
    parser.add_argument("--only", nargs="+", help="names of programs")
    parser.add_argument("folder", type=pathlib.Path)
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    programs = list_programs(arguments.application and str(arguments.application.resolve()))
    unknown = set(arguments.only or ()) - set(programs)
    if unknown:
        parser.error(f"--only: there is no {', '.join(sorted(unknown))}, expected some of {', '.join(programs)}")
    model = folder / "balls.vtp"
    subprocess.run([sys.executable, PROGRAMS / "model_file.py", model], check=True)
    run = [arguments.command.resolve(), "run", "--always", "--technique", arguments.technique, "--"]
    rows, shown = [], []
    for name, program in programs.items():
        if arguments.only and name not in arguments.only:
            continue
        print(name, file=sys.stderr)
        if not is_there(program):
            rows.append((name, f"left out: there is no {program.needs}", (None, None, None)))
            continue
        files = [folder / "{}-{}.png".format("".join(filter(str.isalnum, name)), kind) for kind in ("stock", "peeling", "always")]
        pictures, said = [], []
        asking = None if program.peeling is None else [*program.words, *program.peeling]
        for file, words in zip(files, (program.words, asking, [*run, *program.words])):
            picture, sentences = draw(words, file, model) if words else (None, [])
            pictures.append(picture)
            said += sentences
        stock, peeling, always = pictures
        if stock is not None and always is not None and stock.shape == always.shape == (SIZE[1], SIZE[0], 3):
            shown.append((stock, always))
        text = f"--always to the program as it is: {compare(always, stock)}; to its peeling: {compare(always, peeling)}"
        rows.append((name, "\n    ".join([text, *said]), [file.name if file.exists() else None for file in files]))
    table = "\n".join(f"{name}\n    {text}" for name, text, _ in rows)
    (folder / "table.txt").write_text(table + "\n")
    page(folder / "index.html", "Unmodified programs", ("as it is", "where it asks for peeling", "as it is, by translucency run --always"), rows)
    if shown:
        montage(folder / "Programs.png", list(zip(*shown)))
    print(table)
    return 0


if __name__ == "__main__":
    sys.exit(main())
