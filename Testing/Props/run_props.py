"""Draws every class of VTK's props, translucent, by the techniques, and compares it with plain blending in thin slabs.

    run_props.py --check FILE [CLASS...]  fails if a class is not drawn as it should be, if VTK has one that is not listed, or if FILE, the table in
                                          the documentation, has not the rows that it should have
    run_props.py --table FILE             FILE becomes that table

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
from props import NOT_DRAWN, RECIPES, get_unlisted, make
from run_kind import read, values, write

SIZE = (120, 100)
SLABS = 256
COLUMNS = {0: ("exact", "peel", "adaptive"), 4: ("exact",)}  # techniques by samples
BOUND = {0: 3, 4: 8}  # of 255
LEAST_SEEN = 0.005  # of the pixels have to be changed by the prop
LEAST_RIGHT = 0.9  # of the pixels that it changes have to be within the bound


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


def distances(one, other):
    """The largest difference of the channels of each pixel."""
    differences = [abs(a - b) for a, b in zip(values(one).cast("B"), values(other).cast("B"))]
    return list(map(max, differences[0::3], differences[1::3], differences[2::3]))


class Messages:
    """What VTK and the passes say while it lasts, one text each."""

    def __enter__(self):
        self.before = vtk.vtkOutputWindow.GetInstance()
        self.window = vtk.vtkStringOutputWindow()
        vtk.vtkOutputWindow.SetInstance(self.window)
        return self

    def __exit__(self, *_):
        vtk.vtkOutputWindow.SetInstance(self.before)
        self.texts = [text for text in self.window.GetOutput().split("\n\n") if text.strip()]


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
            seen = [distance > BOUND[samples] for distance in distances(truth, scene.without)]
            if sum(seen) < LEAST_SEEN * len(seen):
                self.wrong.append(f"{sum(seen)} of {len(seen)} pixels are changed by the prop, expected {LEAST_SEEN:.1%} of them")
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
                self.wrong.append(f"{technique} says, where at most one warning that names the class is expected: {' '.join(text.split())}")

    def compare(self, technique, samples, drawn, truth, seen, folder):
        apart = distances(drawn, truth)
        outside = sum(distance > BOUND[samples] for distance in apart)
        share = outside / max(1, sum(seen))
        self.cells.append("all" if outside == 0 else f"{1 - share:.1%}")
        if share > 1 - LEAST_RIGHT:
            self.wrong.append(f"{technique} with {samples} samples: {outside} pixels are more than {BOUND[samples]}/255 off, by {max(apart)} at most; the prop "
                              f"changes {sum(seen)}, and {1 - LEAST_RIGHT:.0%} of those is expected at most")
            folder.mkdir(parents=True, exist_ok=True)
            write(drawn, folder / f"{self.name}-{technique}-{samples}.png")
            write(truth, folder / f"{self.name}-truth-{samples}.png")


if __name__ == "__main__":
    import time
    print(get_unlisted())
    scenes = {samples: Scene(samples) for samples in BOUND}
    for name in sys.argv[1:] or sorted(RECIPES):
        t = time.process_time()
        d = Drawn(name, scenes, pathlib.Path("/tmp/props-out"))
        print(name, "alone" if d.alone else "keys", *d.cells, round(time.process_time() - t, 2), *["\n    " + w for w in d.wrong], flush=True)
