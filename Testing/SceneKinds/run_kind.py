"""Draws one kind of scene by every technique and compares it with the truth: plain blending in thin slabs of depth (vtkDepthSlabsPass).

    run_kind.py KIND FOLDER          FOLDER/KIND.json tells the differences, and where they are too large the pictures lie beside it
    run_kind.py --alone KIND         draws what is opaque in it by VTK alone; the exit code is 3 if that is not seen
    run_kind.py --table FOLDER FILE  FILE becomes the table of all kinds in FOLDER; fails if one is missing
    run_kind.py --check FOLDER FILE  fails if FILE, the table in the documentation, has not the rows that it should have

Slabs are drawn with one sample a pixel. The truth with four is the mean of four such pictures, each with the camera moved
so that one sample of each pixel lies where its centre was. Only edges are the same then: what is shaded once a pixel is shaded at
another place, and points and lines are as wide as before. That is why the bound is wider.

A kind that VTK itself may fail in is skipped where it does (exit code 77): with one sample or more, what is opaque is not seen, VTK warns
of something, or the process ends.
"""

import json
import pathlib
import re
import subprocess
import sys

import numpy
from vtkmodules import all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtktranslucency
from kinds import KINDS, Stage
from translucencyslabs.vtkTranslucencySlabs import vtkDepthSlabsPass

SIZE = (240, 200)
CENTER = (0.5, 0.5)
# Where llvmpipe samples, in pixels; other drivers have other places, which moves edges by less than a quarter of a pixel.
SAMPLE_POSITIONS = {1: (CENTER,), 4: ((0.375, 0.125), (0.875, 0.375), (0.125, 0.625), (0.625, 0.875))}
COLUMNS = [(technique, samples) for technique in ("exact", "adaptive") for samples in (1, 4)]
BOUND = {1: 3, 4: 8}  # of 255
LEAST_SEEN = 0.02  # of the pixels have to change where translucent props are drawn
SKIPPED = 77
NOT_SEEN = 3
WARNING = r"(ERR|WARN)\|(?! GL Message: .*SOURCE_SHADER_COMPILER)"  # of VTK, not what a driver's compiler remarks on its shaders


def items(collection):
    return [collection.GetItemAsObject(i) for i in range(collection.GetNumberOfItems())]


class Scene:
    """A kind in a window, drawn by a technique, if that is None in slabs, or by VTK alone."""

    def __init__(self, kind, technique, samples=1, alone=False):
        self.window = vtk.vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(samples if samples > 1 else 0)
        self.window.SetSize(SIZE)
        self.stage = Stage(self.window)
        camera = self.stage.renderer.GetActiveCamera()
        camera.SetPosition(0.9, 0.8, 4)
        camera.SetViewAngle(32)
        camera.SetParallelScale(1.1)
        self.stage.companions()
        kind.build(self.stage)
        self.kind = kind
        self.technique = technique
        self.passes = []
        self.renderers = items(self.window.GetRenderers())
        for renderer in self.renderers:
            if alone:
                renderer.SetPass(vtk.vtkRenderStepsPass())
            else:
                self.passes.append(vtktranslucency.enable(renderer, technique) if technique else draw_in_slabs(renderer, self.stage))
            self.stage.arrange(renderer, renderer.GetPass())

    def draw(self, sample_position=CENTER):
        """The picture as bytes, rows of RGB."""
        for renderer in self.renderers:
            viewport = renderer.GetViewport()
            renderer.GetActiveCamera().SetWindowCenter(
                *(2 * (sample_position[i] - 0.5) / (SIZE[i] * self.stage.tiles * (viewport[i + 2] - viewport[i])) for i in (0, 1)))
            renderer.ResetCameraClippingRange()
        self.stage.shoot()
        for technique_pass in (p for p in self.passes if hasattr(p, "GetStatistics")):
            fallback = technique_pass.GetStatistics().GetFallback()
            assert not fallback, f"drawn by {fallback} instead of {self.technique}"
        return read(self.window, self.stage.scale)

    def draw_without(self, props):
        """The picture without these, which don't come back."""
        for prop in props:
            prop.VisibilityOff()
        return self.draw()


def draw_in_slabs(renderer, stage):
    slabs = vtkDepthSlabsPass()
    slabs.SetUndivided(stage.undivided)
    vtktranslucency.vtkTranslucencyFactory.Enable(renderer, slabs)
    renderer.GetPass().SetVolumetricPass(None)  # the slabs have it
    return slabs


def read(window, scale):
    reader = vtk.vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.SetScale(scale)
    reader.ReadFrontBufferOff()
    reader.SetShouldRerender(scale > 1)
    reader.Update()
    image = vtk.vtkImageData()
    image.DeepCopy(reader.GetOutput())
    return image


def pixels(image):
    """Its rows of RGB, which change with it."""
    return vtk_to_numpy(image.GetPointData().GetScalars())


def mean(images):
    result = vtk.vtkImageData()
    result.DeepCopy(images[0])
    pixels(result)[:] = (sum(pixels(image).astype(int) for image in images) + len(images) // 2) // len(images)
    return result


def distances(one, other):
    """The largest difference of the channels of each pixel."""
    assert one.GetDimensions() == other.GetDimensions(), f"{one.GetDimensions()}, expected {other.GetDimensions()}"
    return numpy.abs(pixels(one).astype(int) - pixels(other)).max(axis=1)


class Truth:
    """A picture of a scene in slabs, and the pixels in which it is the truth: where the order within a slab does not matter."""

    def __init__(self, scene, samples):
        self.bound = BOUND[samples]
        pictures = []
        for front_to_back in (False, True):
            for slabs in scene.passes:
                slabs.SetFrontToBack(front_to_back)
            pictures.append(mean([scene.draw(position) for position in SAMPLE_POSITIONS[samples]]))
        self.picture = pictures[0]
        self.known = distances(*pictures) <= BOUND[1]
        known = numpy.mean(self.known)
        assert known >= scene.kind.known, f"with {samples} samples {known:.2%} of the pixels don't depend on the order within slabs, expected {scene.kind.known:.0%}"

    def compare(self, drawn):
        """The share of pixels within the bound, and the largest difference."""
        apart = distances(drawn, self.picture)[self.known]
        return numpy.mean(apart <= self.bound), int(apart.max())


def write(image, file):
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(image)
    writer.Write()


def seen(scene, props, before):
    """The share of the pixels in which these props are seen: hides them."""
    return numpy.mean(distances(scene.draw_without(props), before) > BOUND[1])


def draw_alone(kind):
    """Whether what is opaque is seen, by VTK alone; with several samples only where the kind has to be right with them."""
    for samples in BOUND:
        scene = Scene(kind, None, samples, alone=True)
        opaque = [prop for prop in items(scene.stage.renderer.GetViewProps()) if prop not in scene.stage.translucent]
        share = seen(scene, opaque, scene.draw_without(scene.stage.translucent))
        if share < LEAST_SEEN and (samples == 1 or kind.share_of_samples):
            return False
    return True


def run(name, folder):
    kind = KINDS[name]
    if kind.may_fail:
        alone = subprocess.run([sys.executable, "-B", __file__, "--alone", name], capture_output=True, text=True)
        if alone.returncode == NOT_SEEN or alone.returncode < 0 or re.search(WARNING, alone.stderr):  # less than 0: by a signal
            print(f"{name}: left out, for VTK {vtk.vtkVersion.GetVTKVersion()} does not draw what is opaque in it without complaint, either")
            (folder / f"{name}.json").write_text(json.dumps({"kind": name, "results": None}) + "\n")
            return SKIPPED
        assert alone.returncode == 0, alone.stderr
    scene = Scene(kind, None)
    truths = {samples: Truth(scene, samples) for samples in BOUND}
    share = seen(scene, scene.stage.translucent, truths[1].picture)
    assert share >= LEAST_SEEN, f"{name}: translucent props change {share:.2%} of the pixels, expected {LEAST_SEEN:.0%}"
    row = {"kind": name, "results": {}}
    failures = []
    for technique, samples in COLUMNS:
        drawn = Scene(kind, technique, samples).draw()
        share, largest = truths[samples].compare(drawn)
        row["results"][f"{technique} {samples}"] = {"share": share, "largest": largest}
        least = kind.share if samples == 1 else kind.share_of_samples
        print(f"{name}, {technique}, samples {samples}: {share:.3%} within {BOUND[samples]}, largest difference {largest}")
        if share < least:
            failures.append(f"{technique} with {samples} samples: {share:.3%} of the pixels are within {BOUND[samples]}/255, expected {least:.1%}")
            write(drawn, folder / f"{name}-{technique}-{samples}.png")
            write(truths[samples].picture, folder / f"{name}-truth-{samples}.png")
    (folder / f"{name}.json").write_text(json.dumps(row, indent=2) + "\n")
    for failure in failures:
        print(f"{name}: {failure}", file=sys.stderr)
    return 1 if failures else 0


def cell(result):
    if result["share"] == 1:
        return "all"
    return f"{100 * result['share']:.2f} %, {result['largest']}"


def table(folder):
    lines = ["| kind | " + " | ".join(f"{technique}, {samples}" for technique, samples in COLUMNS) + " | why not all |",
             "| --- |" + " --- |" * (len(COLUMNS) + 1)]
    for name, kind in KINDS.items():
        results = json.loads((folder / f"{name}.json").read_text())["results"]
        cells = [cell(results[f"{technique} {samples}"]) if results else "left out" for technique, samples in COLUMNS]
        lines.append(f"| {kind.what} | " + " | ".join(cells) + f" | {kind.why} |")
    return lines


def check(folder, file):
    """The figures change a little from driver to driver; the kinds and the reasons don't."""
    def stable(line):
        cells = line.split("|")
        return cells[1].strip(), cells[-2].strip()

    expected = [stable(line) for line in table(folder)]
    written = [stable(line) for line in pathlib.Path(file).read_text().splitlines() if line.startswith("|")]
    if written != expected:
        for row in [row for row in expected if row not in written] + [row for row in written if row not in expected]:
            print(f"{file}: the row of '{row[0]}' is not as the tests have it", file=sys.stderr)
        sys.exit(1)


HEAD = """# Kinds of scenes

What the techniques draw, beside plain blending in thin slabs of depth, from the farthest to the nearest: the share of the pixels that are within 3/255 of it with
one sample a pixel, and within 8/255 of the mean of four such pictures with four samples, and the largest difference where that is not all of them. Slabs need no
technique: nothing is stored, sorted or peeled. Pixels in which the order within a slab matters are left out: two surfaces cross there (at most 6 % of them, 10 % of the
deep ones). With four samples, edges are the same, but what is shaded once a pixel is shaded at another place in each of the four pictures. Made by the tests:
`Testing/SceneKinds` and `Testing/Slabs`.
"""

if __name__ == "__main__":
    arguments = sys.argv[1:]
    if len(arguments) == 3 and arguments[0] == "--table":
        pathlib.Path(arguments[2]).write_text(HEAD + "\n" + "\n".join(table(pathlib.Path(arguments[1]))) + "\n")
    elif len(arguments) == 3 and arguments[0] == "--check":
        check(pathlib.Path(arguments[1]), arguments[2])
    elif len(arguments) == 2 and arguments[0] == "--alone":
        sys.exit(0 if draw_alone(KINDS[arguments[1]]) else NOT_SEEN)
    elif len(arguments) == 2 and arguments[0] in KINDS:
        folder = pathlib.Path(arguments[1])
        folder.mkdir(parents=True, exist_ok=True)
        sys.exit(run(arguments[0], folder))
    else:
        sys.exit(__doc__)
