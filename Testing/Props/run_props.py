"""Draws every class of VTK's props, translucent, by the techniques, and compares it with plain blending in thin slabs.

The truth needs no text of a pass in any shader: the camera's range of depths is cut into slabs, which are drawn from the farthest to the nearest, each
over the last, by VTK's own translucent pass. In a slab that is thin enough no order matters. Where surfaces turn away from the camera, front and
back faces share a slab, and are in drawing order; and a surface cut in two may leave a gap of a pixel or cover one twice. That is why not all pixels that a
prop changes have to be within the bound.
"""

import argparse
import pathlib
import sys

from vtkmodules import all as vtk

import vtktranslucency
from kinds import Stage, look, surface
from props import NOT_DRAWN, RECIPES, get_unlisted, make, prop_classes
from run_kind import distances, read, write

VTK_OF_TABLE = (9, 1)  # others have other classes, and change how they are reached; what they draw is compared all the same
SIZE = (120, 100)
SLABS = 256
COLUMNS = {0: ("exact", "peel", "adaptive"), 4: ("exact",)}  # techniques by samples
BOUND = {0: 3, 4: 8}  # of 255
LEAST_SEEN = 0.005  # of the pixels have to be changed by the prop
LEAST_RIGHT = {0: 0.8, 4: 0.7}  # of the pixels that it changes have to be within the bound


class Scene:
    """A window with companions for one prop: two crossing translucent planes that reach through it, drawn first, and an opaque box."""

    def __init__(self, samples):
        self.window = vtk.vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(samples)
        self.window.SetSize(SIZE)
        self.interactor = vtk.vtkRenderWindowInteractor()  # some props ask it how fast they have to draw
        self.interactor.SetRenderWindow(self.window)
        self.renderer = Stage(self.window).renderer
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.9, 0.8, 4)
        camera.SetViewAngle(32)
        for turn, color in ((35, (0.9, 0.5, 0.1)), (-55, (0.2, 0.8, 0.9))):
            plane = look(surface(vtk.vtkPlaneSource(), Origin=(-0.9, -0.7, 0), Point1=(0.9, -0.7, 0), Point2=(-0.9, 0.7, 0)), color, 0.45)
            plane.RotateX(turn)
            plane.RotateY(turn / 2)
            self.renderer.AddViewProp(plane)
        box = look(surface(vtk.vtkCubeSource(), XLength=0.5, YLength=0.7, ZLength=0.4, Center=(-0.45, -0.35, 0)), (0.3, 0.7, 0.4), 1)
        box.RotateY(20)  # no face lies at one depth
        self.renderer.AddViewProp(box)
        self.renderer.ResetCameraClippingRange(-1, 1, -1, 1, -1, 1)
        self.without = self.draw_slabs()

    def draw(self, technique):
        """Twice: what a pass met in the first frame, it knows in the second."""
        vtktranslucency.enable(self.renderer, technique)
        self.window.Render()
        self.window.Render()
        return read(self.window, 1)

    def draw_slabs(self):
        camera = self.renderer.GetActiveCamera()
        nearest, farthest = camera.GetClippingRange()
        blending = vtk.vtkRenderStepsPass()  # without it, VTK draws translucent props of multi-sampled windows without samples
        blending.SetTranslucentPass(vtk.vtkTranslucentPass())
        self.renderer.SetPass(blending)
        golden = (5 ** 0.5 - 1) / 2  # no face that lies at a round depth lies between two slabs
        borders = [farthest] + [farthest - (farthest - nearest) * (i + golden) / SLABS for i in range(SLABS)] + [nearest]
        for far, near in zip(borders, borders[1:]):
            camera.SetClippingRange(near, far)
            self.window.Render()
            self.renderer.PreserveColorBufferOn()
        camera.SetClippingRange(nearest, farthest)
        self.renderer.PreserveColorBufferOff()
        return read(self.window, 1)


class Messages:
    """What VTK and the passes say while it lasts, one text each."""

    def __enter__(self):
        self.before = vtk.vtkOutputWindow.GetInstance()
        self.window = vtk.vtkStringOutputWindow()
        vtk.vtkOutputWindow.SetInstance(self.window)
        return self

    def __exit__(self, *_):
        vtk.vtkOutputWindow.SetInstance(self.before)
        texts = (" ".join(text.split()) for text in self.window.GetOutput().split("\n\n"))
        self.texts = [text for text in texts if text and "was deprecated for VTK" not in text]  # VTK's level-of-detail actors call what is


class Drawn:
    """One class by all techniques: the row of the table, and what is wrong."""

    def __init__(self, name, scenes, folder):
        self.name = name
        self.wrong = []
        self.cells = []
        self.alone = False  # whether it is drawn by itself
        for samples, scene in scenes.items():
            prop = make(name, scene.renderer)
            with Messages():  # VTK's own about its own props
                truth = scene.draw_slabs()
            apart = distances(truth, scene.without)
            seen = (apart > BOUND[samples]).sum()
            if seen < LEAST_SEEN * len(apart):
                self.wrong.append(f"{seen} of {len(apart)} pixels are changed by the prop, expected {LEAST_SEEN:.1%} of them")
            for technique in COLUMNS[samples]:
                with Messages() as messages:
                    drawn = scene.draw(technique)
                self.listen(technique, messages.texts)
                self.compare(technique, samples, drawn, truth, seen, folder)
            scene.renderer.RemoveViewProp(prop)

    def listen(self, technique, texts):
        for text in texts:
            if "Warning:" in text and self.name in text and "drawn by itself" in text and len(texts) == 1:
                self.alone = True
            else:
                self.wrong.append(f"{technique} says, where at most one warning that names the class is expected: {text}")

    def compare(self, technique, samples, drawn, truth, seen, folder):
        apart = distances(drawn, truth)
        outside = (apart > BOUND[samples]).sum()
        share = outside / max(1, seen)
        self.cells.append("all" if outside == 0 else f"{1 - share:.1%}")
        allowed = 1 - LEAST_RIGHT[samples]
        if share > allowed:
            self.wrong.append(f"{technique} with {samples} samples: {outside} pixels are more than {BOUND[samples]}/255 off, by {apart.max()} at most; the prop "
                              f"changes {seen}, and {allowed:.0%} of those are expected at most")
            folder.mkdir(parents=True, exist_ok=True)
            write(drawn, folder / f"{self.name}-{technique}-{samples}.png")
            write(truth, folder / f"{self.name}-truth-{samples}.png")


HEAD = f"""# Props

Every class of VTK's props, as far as it draws translucent geometry in a scene, drawn by the techniques among two translucent planes that reach through it and
an opaque box: how its shaders are reached, by the pass's text (its keys) or by drawing it by itself, and the share of the pixels that it changes that are
within {BOUND[0]}/255 of plain blending in {SLABS} slabs of depth, from the farthest to the nearest ({BOUND[4]}/255 with four samples a pixel). Where surfaces turn away from
the camera, more than one layer lies in a slab, and there the slabs are wrong. Made by the test: `Testing/Props`.
"""
REASONS = "Those that are not drawn, and why:"


def table(rows):
    columns = [f"{technique}, {samples}" for samples in COLUMNS for technique in COLUMNS[samples]]
    lines = ["| class | reached | " + " | ".join(columns) + " |", "| --- | --- |" + " --- |" * len(columns)]
    lines += [f"| {row.name} | {'by itself' if row.alone else 'by its keys'} | " + " | ".join(row.cells) + " |" for row in rows]
    lines += ["", REASONS, "", "| class | why it is not drawn |", "| --- | --- |"]
    return lines + [f"| {name} | {why} |" for name, why in sorted(NOT_DRAWN.items())]


def stable(lines):
    """The figures change a little from driver to driver; the classes, and how they are reached, don't."""
    return [tuple(cell.strip() for cell in line.split("|")[1:3]) for line in lines if line.startswith("|")]


def check(rows, file):
    expected = stable(table(rows))
    written = stable(pathlib.Path(file).read_text().splitlines())
    return [f"{file}: the row of '{row[0]}' is not as the test has it" for row in dict.fromkeys(expected + written)
            if (row in expected) != (row in written)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--check", metavar="FILE", help="fail if this table, of the VTK that it was made with, is not as the test has it")
    action.add_argument("--table", metavar="FILE", help="write the table")
    parser.add_argument("--pictures", metavar="FOLDER", type=pathlib.Path, default=pathlib.Path("."), help="where those go that are wrong")
    parser.add_argument("names", metavar="CLASS", nargs="*", help="draw these only, and check and write no table")
    arguments = parser.parse_args()
    listed = not arguments.names and (vtk.vtkVersion.GetVTKMajorVersion(), vtk.vtkVersion.GetVTKMinorVersion()) == VTK_OF_TABLE
    if not listed:
        print("drawn and compared only: the list of classes and the table are all of VTK", ".".join(map(str, VTK_OF_TABLE)))
    wrong = get_unlisted() if listed else []
    scenes = {samples: Scene(samples) for samples in BOUND}
    rows = []
    present = prop_classes()
    for name in arguments.names or sorted(name for name in RECIPES if name in present):
        row = Drawn(name, scenes, arguments.pictures)
        print(name, "by itself" if row.alone else "by its keys", *row.cells, flush=True)
        wrong += [f"{name}: {text}" for text in row.wrong]
        rows.append(row)
    if arguments.table and not arguments.names:
        pathlib.Path(arguments.table).write_text(HEAD + "\n" + "\n".join(table(rows)) + "\n")
    elif listed:
        wrong += check(rows, arguments.check)
    print(*wrong, sep="\n", file=sys.stderr)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
