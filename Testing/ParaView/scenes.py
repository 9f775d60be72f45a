"""scenes.py CASE PLUGIN FOLDER: runs within ParaView (pvpython, pvbatch, or paraview --script). PLUGIN is '-' for none.

Most scenes are flat surfaces that cover the picture, one behind the other, each of one colour and opacity: what has to come out follows
from the over operator.
"""
import numpy

from paraview import servermanager
from paraview.simple import (
    Box,
    ColorBy,
    CreateView,
    Delete,
    GetActiveView,
    GetActiveViewOrCreate,
    LoadDistributedPlugin,
    LoadState,
    ProgrammableSource,
    Render,
    SaveScreenshot,
    SaveState,
    Show,
    Sphere,
    Wavelet,
)
from paraview.vtk.vtkCommonCore import vtkCollection
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

SIZE = 60
BACKGROUND = (51, 102, 153)
RANDOM = numpy.random.RandomState(1)
COLORS = RANDOM.randint(0, 256, (20, 3))
OPACITIES = RANDOM.randint(20, 120, 20)  # of 255
LAYERS = 12  # more than the 4 peels of ParaView reach
NUMBER = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()  # of ranks
MOVES = servermanager.vtkSMProxyManager.GetVersionMajor() >= 6  # 5.11 loses what it moves between ranks

# Ranks hold one slab of the layers each, the last one the nearest, in an order that no blending is right with. ParaView cuts the layers
# between them anew, in the middle of what they are made of: with several squares a layer, that goes through the picture.
LAYERS_SCRIPT = """
import random
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController

colors = {colors}
ranks = vtkMultiProcessController.GetGlobalController()
begin, end = (rank * len(colors) // ranks.GetNumberOfProcesses() for rank in
    (ranks.GetNumberOfProcesses() - 1 - ranks.GetLocalProcessId(), ranks.GetNumberOfProcesses() - ranks.GetLocalProcessId()))
layers = list(range(begin, end))
random.Random(4).shuffle(layers)
points, cells, rgba = vtkPoints(), vtkCellArray(), vtkUnsignedCharArray()
rgba.SetName("rgba")
rgba.SetNumberOfComponents(4)
for layer in layers:
    for x in range(-{squares}, {squares}):
        for y in range(-{squares}, {squares}):
            cells.InsertNextCell(4)
            for corner in ((x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)):
                place = [part / {squares} for part in corner]
                place.insert({axis}, -0.1 * layer)
                cells.InsertCellPoint(points.InsertNextPoint(*place))
            rgba.InsertNextTuple4(*colors[layer])
output.VTKObject.SetPoints(points)
output.VTKObject.SetPolys(cells)
output.VTKObject.GetCellData().AddArray(rgba)
"""

# Many faint layers across x, of squares of random colours and opacities, as ParaView cuts them between ranks: through the middle of x, and
# then, with four ranks, through that of y, where they have a gap.
FAINT_SCRIPT = """
import random
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController

ranks = vtkMultiProcessController.GetGlobalController()
generator = random.Random(1)
points, cells, rgba = vtkPoints(), vtkCellArray(), vtkUnsignedCharArray()
rgba.SetName("rgba")
rgba.SetNumberOfComponents(4)
for layer in range(48):
    for y in range(-8, 8):
        for z in range(-8, 8):
            color = [*(generator.randrange(256) for _ in range(3)), generator.randrange(2, 16)]
            owner = (0, layer < 24, 2 * (layer < 24) + (y >= 0))[ranks.GetNumberOfProcesses() // 2]
            if owner != ranks.GetLocalProcessId():
                continue
            cells.InsertNextCell(4)
            for corner in ((y, z), (y + 1, z), (y + 1, z + 1), (y, z + 1)):
                gap = 0.02 if y >= 0 else -0.02
                cells.InsertCellPoint(points.InsertNextPoint(-0.1 * layer, corner[0] / 8 + gap, corner[1] / 8))
            rgba.InsertNextTuple4(*color)
output.VTKObject.SetPoints(points)
output.VTKObject.SetPolys(cells)
output.VTKObject.GetCellData().AddArray(rgba)
"""


def new_view(kind="RenderView", layers=LAYERS, **arguments):
    return set_up(CreateView(kind), layers, **arguments)


def set_up(view, layers=LAYERS, axis=2, squares=1):
    """Layers across an axis, of two times squares squares each way, looked at along it."""
    colors = [[*map(int, COLORS[i]), int(OPACITIES[i])] for i in range(layers)]
    show(view, LAYERS_SCRIPT.format(colors=colors, axis=axis, squares=squares))
    look_at_layers(view, axis)
    return view


def show(view, script):
    """Shows what a script makes, in the colours that it gives."""
    view.ViewSize = [SIZE, SIZE]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [part / 255 for part in BACKGROUND]
    view.UseFXAA = 0
    display = Show(ProgrammableSource(OutputDataSetType="vtkPolyData", Script=script), view)
    display.ColorArrayName = ["CELLS", "rgba"]
    display.MapScalars = 0
    display.Ambient, display.Diffuse, display.Specular = 1, 0, 0
    Render(view)


def look_at_layers(view, axis=2):
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = [5 if i == axis else 0 for i in range(3)]
    view.CameraViewUp = [1 if i == (axis + 2) % 3 else 0 for i in range(3)]
    view.CameraParallelScale = 0.5


def over(layers=LAYERS, kept=LAYERS, behind=BACKGROUND):
    """Colour and opacity of the nearest layers over what lies behind them."""
    color, transmittance = numpy.zeros(3), 1.0
    for i in range(min(layers, kept)):
        opacity = OPACITIES[i] / 255
        color += transmittance * opacity * COLORS[i]
        transmittance *= 1 - opacity
    return color + transmittance * numpy.array(behind), 1 - transmittance


def to_array(image):
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).astype(int)


def read(name):
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    return to_array(reader.GetOutput())


def draw(view):
    Render(view)
    return to_array(view.CaptureWindow(1))


def expect_near(picture, expected, tolerance, what):
    off = numpy.abs(picture - expected).max()
    assert off <= tolerance, f"{what}: off by {off}, expected at most {tolerance}"


def expect_far(picture, other, least, what):
    off = numpy.abs(picture - other).max()
    assert off >= least, f"{what}: off by {off}, expected at least {least}"


def is_root():
    return vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 0


# Cases: each is a function, and what it prints is looked for by run_paraview.py.


def stock(folder):
    numpy.save(folder / "stock.npy", draw(new_view()))


def techniques(folder):
    view = new_view()
    assert view.TranslucencyTechnique == "exact", view.TranslucencyTechnique
    right, _ = over()
    expect_near(draw(view), right, 1, "the default")
    view.TranslucencyMlabLayers = view.TranslucencyKbufferLayers = view.TranslucencyHybridLayers = LAYERS
    for technique in ("adaptive", "peel", "mlab", "kbuffer", "hybrid"):
        view.TranslucencyTechnique = technique
        expect_near(draw(view), right, 2, technique)
    expect_far(numpy.load(folder / "stock.npy"), right, 5, "ParaView by itself")
    view.TranslucencyTechnique = "None"
    expect_near(draw(view), numpy.load(folder / "stock.npy"), 0, "None")


def by_name(_folder):
    LoadDistributedPlugin("Translucency", remote=False, ns=globals())
    expect_near(draw(new_view()), over()[0], 1, "the default")


def options(_folder):
    view = new_view()
    view.TranslucencyTechnique = "kbuffer"
    expect_near(draw(view), over(kept=4)[0], 1, "4 layers, the default")
    view.TranslucencyKbufferLayers = 2
    expect_near(draw(view), over(kept=2)[0], 1, "2 layers")
    view.TranslucencyTechnique = "exact"
    view.TranslucencyKbufferLayers = 3  # while another one draws
    view.TranslucencyTechnique = "kbuffer"
    expect_near(draw(view), over(kept=3)[0], 1, "3 layers")
    view.TranslucencyKbufferLayers = 4
    expect_near(draw(view), over(kept=4)[0], 1, "4 layers again")
    view.TranslucencyKbufferLayers = LAYERS
    view.TranslucencyKbufferColorFormat = "rgba8"
    expect_near(draw(view), over()[0], 3, "all layers, in 8 bits")


def statistics(_folder):
    view = new_view()
    draw(view)
    assert view.TranslucencyFragments == LAYERS * SIZE * SIZE, view.TranslucencyFragments
    assert view.TranslucencyDeepestPixel == LAYERS, view.TranslucencyDeepestPixel
    assert view.TranslucencyBytes >= 16 * LAYERS * SIZE * SIZE, view.TranslucencyBytes
    assert view.TranslucencyTiles == 1 and view.TranslucencyFallback == "", view.TranslucencyFallback
    assert view.TranslucencyGatherTime < 0, view.TranslucencyGatherTime
    view.TranslucencyMeasureTimes = 1
    draw(view)
    assert view.TranslucencyGatherTime > 0 and view.TranslucencyResolveTime > 0, view.TranslucencyGatherTime
    view.TranslucencyTechnique = "None"
    draw(view)
    assert view.TranslucencyFragments == 0, view.TranslucencyFragments


def bad_values(_folder):
    view = new_view()
    for name, value in (("Technique", "exakt"), ("AdaptiveNodes", 1000), ("ExactStorage", "heap"), ("Release", "9.9")):
        setattr(view, "Translucency" + name, value)
    expect_near(draw(view), over()[0], 1, "after bad values")


def samples(_folder):
    """A pixel at the edge of one surface has so many quarters of its colour as samples lie on it."""
    view = new_view(layers=1)
    view.CameraViewUp = [0.2, 1, 0]
    view.CameraParallelScale = 1.7
    background, opacity = numpy.array(BACKGROUND), OPACITIES[0] / 255
    ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
    for count, quarters in ((1, (0, 4)), (4, (0, 1, 2, 3, 4))):
        view.UseFXAA = 0 if count == 1 else 1  # which is left out then
        view.TranslucencySamples = count
        picture = draw(view)
        # ParaView may cut the surface between ranks: then two of them draw the pixels of the cut, each a part of their samples.
        parts = [(i, j) for i in quarters for j in (quarters if ranks > 1 else (0,)) if i + j <= 4]
        hidden = numpy.array([[1 - (1 - opacity * i / 4) * (1 - opacity * j / 4)] for i, j in parts])
        off = numpy.abs(picture[:, :, None, :] - (background + hidden * (COLORS[0] - background))).max(axis=3)
        expect_near(off.min(axis=2), 0, 1 if ranks == 1 else 2, f"{count} samples")
        found = {sum(parts[i]) for i in numpy.unique(off.argmin(axis=2))}
        assert len(found) >= (4 if count > 1 else 2), found
    view.TranslucencySamples = 9
    Delete(view)
    view = new_view(axis=0, squares=4)  # of which each rank has what it draws
    view.TranslucencySamples = 4
    expect_near(draw(view), over()[0], 1, "where no edges are")
    if is_root():
        assert view.TranslucencyFragments >= LAYERS * SIZE * SIZE, view.TranslucencyFragments


def effects(_folder):
    """What ParaView does beside: the same with the technique as without, where the latter is right."""
    layers = 3
    scenes = {
        "plain": {},
        "FXAA": {"UseFXAA": 1},
        "ambient occlusion": {"UseAmbientOcclusion": 1},
        "tone mapping": {"UseToneMapping": 1},
        "tone mapping and FXAA": {"UseToneMapping": 1, "UseFXAA": 1},
        "axes": {"OrientationAxesVisibility": 1, "CenterAxesVisibility": 1},
        "axes grid": {"grid": True},
        "colour legend": {"legend": True},
        "volume": {"volume": True},
        "eye-dome lighting": {"kind": "RenderViewWithEDL"},
    }
    plain = None
    for name, scene in scenes.items():
        settings = dict(scene)
        view = new_view(settings.pop("kind", "RenderView"), layers)
        # What is opaque stands beside what is translucent: VTK's peeling is wrong where it lies behind it.
        Show(Box(XLength=0.3, YLength=0.3, ZLength=0.3, Center=[-0.3, 0.3, 0.3]), view)
        Show(Sphere(Radius=0.15, Center=[-0.3, -0.3, 0.4]), view)
        if settings.pop("grid", False):
            view.AxesGrid.Visibility = 1
        if settings.pop("legend", False):
            wavelet = Wavelet()
            display = Show(wavelet, view)
            display.Representation = "Outline"
            ColorBy(display, ("POINTS", "RTData"))
            display.SetScalarBarVisibility(view, True)
        if settings.pop("volume", False):
            display = Show(Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5]), view)
            display.SetRepresentationType("Volume")
            ColorBy(display, ("POINTS", "RTData"))
            display.Scale = [0.04, 0.04, 0.04]
            setattr(display, "Translation" if hasattr(display, "Translation") else "Position", [0.3, 0, 0.6])
        for key, value in settings.items():
            setattr(view, key, value)
        view.CameraParallelScale = 1.3
        pictures = {}
        for technique in ("None", "exact"):
            view.TranslucencyTechnique = technique
            draw(view)  # effects of the frame before, such as a legend's place, are over by the second one
            pictures[technique] = draw(view)
        plain = pictures["None"] if plain is None else plain
        expect_near(pictures["exact"], pictures["None"], 3, name)
        if scene and name != "FXAA":  # which the edges of a box may not need
            expect_far(pictures["exact"], plain, 8, name + ", against a view without")
        Delete(view)


def selection(_folder):
    view = new_view()
    counts = {}
    for technique in ("None", "exact"):
        view.TranslucencyTechnique = technique
        Render(view)
        representations, sources = vtkCollection(), vtkCollection()
        view.SMProxy.SelectSurfaceCells([10, 10, 50, 50], representations, sources, 0)
        selected = [sources.GetItemAsObject(i) for i in range(sources.GetNumberOfItems())]
        counts[technique] = [list(servermanager._getPyProxy(item).IDs) for item in selected]
        if technique == "exact":
            expect_near(draw(view), over()[0], 1, "after a selection")
    assert counts["exact"] and counts["exact"] == counts["None"], counts


def screenshots(folder):
    view = new_view()
    color, opacity = over(behind=(0, 0, 0))
    name = str(folder / "screenshot.png")
    for size in (SIZE, 4 * SIZE):  # the window's, and one that is put together of several pictures
        SaveScreenshot(name, view, ImageResolution=[size, size], TransparentBackground=1)
        picture = read(name)
        assert picture.shape == (size, size, 4), picture.shape
        expect_near(picture[..., 3], 255 * opacity, 2, f"opacity at {size}")
        expect_near(picture[..., :3], color / opacity, 3, f"colour at {size}")


def ranks(folder):
    """Each rank draws a part of the picture, or of what lies behind the other's: that depends on the axis across which ParaView cuts."""
    axes = range(3) if MOVES else [0] if NUMBER <= 2 else []  # two ranks have what they draw along x
    for axis in axes:
        view = new_view(axis=axis, squares=4)
        for technique in ("exact", "adaptive"):
            view.TranslucencyTechnique = technique
            picture = draw(view)
            what = f"{technique} on {NUMBER} ranks along {'xyz'[axis]}"
            expect_near(picture, over()[0], 2, what)
            # A pixel of a cut may be drawn by both.
            assert 0 <= view.TranslucencyFragments - LAYERS * SIZE * SIZE <= 2 * LAYERS * SIZE * NUMBER, view.TranslucencyFragments
            if axis == 0:  # the first cut
                assert view.TranslucencyDeepestPixel <= (LAYERS if NUMBER == 1 else LAYERS / 2), view.TranslucencyDeepestPixel
            expect_as_one_rank(folder, f"{technique} along {'xyz'[axis]}", picture, 2)
        Delete(view)


def new_faint_view(kind="RenderView"):
    """A view in which three of four ranks lie behind each other in many places."""
    view = CreateView(kind)
    show(view, FAINT_SCRIPT)
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [-2.4, 0, 0]
    view.CameraPosition = [2, 2, 0.5]
    view.CameraViewUp = [0, 0, 1]
    view.CameraParallelScale = 0.6
    return view


def expect_as_one_rank(folder, name, picture, tolerance):
    numpy.save(folder / f"{name} {NUMBER}.npy", picture)
    expect_near(picture, numpy.load(folder / f"{name} 1.npy"), tolerance, f"{name} on {NUMBER} ranks, against one")


def ranks_round(folder):
    """What is rounded before the ranks' parts are together adds up."""
    view = new_faint_view()
    # With samples, the mean of several ranks' edges in a pixel is not quite what the means of each are over each other.
    for samples, tolerance in ((1, 1), (4, 2)):
        view.TranslucencySamples = samples
        for background in (0, 1):
            view.Background = 3 * [background]
            expect_as_one_rank(folder, f"{samples} samples on {background}", draw(view), tolerance)
        found = numpy.array([view.TranslucencyFragments, view.TranslucencyDeepestPixel])
        numpy.save(folder / f"{samples}-{NUMBER}.npy", found)
        fragments, deepest = numpy.load(folder / f"{samples}-1.npy")
        assert found[0] == fragments, f"{found[0]} fragments of the ranks, {fragments} of one"
        assert NUMBER == 1 or found[1] < 0.6 * deepest, f"no ranks are behind each other: {found[1]} deep, {deepest} one"


def ranks_effects(folder):
    """What ParaView does beside, and what comes and goes: as with one rank, and with the technique None as without the plugin."""
    view = new_faint_view()
    if not hasattr(view, "TranslucencyTechnique"):
        numpy.save(folder / f"stock-{NUMBER}.npy", draw(view))
        return
    stock = numpy.load(folder / f"stock-{NUMBER}.npy")
    for technique in ("exact", "None", "additive", "None", "exact"):
        view.TranslucencyTechnique = technique
        if technique == "None":
            expect_near(draw(view), stock, 0, "None, against ParaView without the plugin")
        else:
            expect_as_one_rank(folder, technique, draw(view), 1)
    other = new_faint_view("RenderViewWithEDL")
    expect_as_one_rank(folder, "eye-dome lighting", draw(other), 1)
    expect_as_one_rank(folder, "beside another view", draw(view), 1)
    Delete(other)
    for size in ([80, 50], [SIZE, SIZE]):
        view.ViewSize = size
        expect_as_one_rank(folder, f"{size[0]} pixels wide", draw(view), 1)
    view.UseFXAA = 1
    expect_as_one_rank(folder, "FXAA", draw(view), 1)
    view.UseFXAA = 0
    name = str(folder / f"screenshot-{NUMBER}.png")
    for size in (SIZE, 4 * SIZE):
        SaveScreenshot(name, view, ImageResolution=[size, size], TransparentBackground=1)
        picture = read(name)
        expect_as_one_rank(folder, f"opacity at {size}", picture[..., 3], 2)
        expect_as_one_rank(folder, f"colour at {size}", picture[..., :3] * picture[..., 3:] // 255, 2)
    Show(Sphere(Radius=0.3, Center=[-1, 0.2, 0.1]), view)
    if NUMBER == 1 or MOVES:
        expect_as_one_rank(folder, "something opaque", draw(view), 2)


def ranks_differ(_folder):
    """In pvbatch --symmetric, where each rank sets its own properties. (All have to change some: ParaView itself hangs otherwise.)"""
    view = new_view()
    for root, other in (("mlab", "additive"), ("None", "peel")):  # in the latter one rank would put the parts together by itself
        view.TranslucencyTechnique = root if is_root() else other
        for _ in range(3):
            Render(view)
    view.TranslucencyTechnique = "exact"
    Render(view)
    print("went on", flush=True)


def enable(_folder):
    import vtktranslucency

    view = new_view()
    if hasattr(view, "TranslucencyTechnique"):
        view.TranslucencyTechnique = "None"
    before = draw(view)
    expect_far(before, over()[0], 5, "ParaView by itself")
    renderer = view.GetClientSideObject().GetRenderer()
    technique = vtktranslucency.enable(renderer, "exact", memory_limit=64)
    expect_near(draw(view), over()[0], 1, "enabled")
    view.UseFXAA = 1  # ParaView makes its passes anew
    expect_near(draw(view), over()[0], 1, "with FXAA")
    view.GetRenderWindow().MakeCurrent()
    assert technique.GetStatistics().GetFragments() == LAYERS * SIZE * SIZE
    view.UseFXAA = 0
    vtktranslucency.disable(renderer)
    expect_near(draw(view), before, 0, "disabled")


def enable_on_ranks(_folder):
    import vtktranslucency

    view = new_view()
    before = draw(view)
    try:
        vtktranslucency.enable(view.GetClientSideObject().GetRenderer(), "exact")
    except ValueError as error:
        print("refused:", error)
    expect_near(draw(view), before, 0, "after enable() was refused")


def save_state(folder):
    view = new_view()
    if hasattr(view, "TranslucencyTechnique"):
        view.TranslucencyTechnique = "kbuffer"
        view.TranslucencyKbufferLayers = 3
        SaveState(str(folder / "with.pvsm"))
    else:
        SaveState(str(folder / "without.pvsm"))


def load_state(folder, name):
    LoadState(str(folder / name))
    view = GetActiveView()
    view.ViewSize = [SIZE, SIZE]
    Render(view)  # resets the camera
    look_at_layers(view)
    return view


def load_with(folder):
    view = load_state(folder, "with.pvsm")
    if hasattr(view, "TranslucencyTechnique"):
        assert (view.TranslucencyTechnique, view.TranslucencyKbufferLayers) == ("kbuffer", 3)
        expect_near(draw(view), over(kept=3)[0], 1, "the state")
    else:
        expect_near(draw(view), numpy.load(folder / "stock.npy"), 0, "the state without the plugin")


def load_without(folder):
    view = load_state(folder, "without.pvsm")
    assert view.TranslucencyTechnique == "exact", view.TranslucencyTechnique
    expect_near(draw(view), over()[0], 1, "a state that knows no technique")


def remote(folder):
    """A server, which draws with RemoteRenderThreshold 0, and sends what it has otherwise."""
    view = new_view()
    right, wrong = over()[0], numpy.load(folder / "stock.npy")
    drawn = {}
    for threshold in (0, 1000):
        view.RemoteRenderThreshold = threshold
        if hasattr(view, "TranslucencyTechnique"):
            view.TranslucencyTechnique = "None"
            expect_near(draw(view), wrong, 0, f"None, threshold {threshold}")
            view.TranslucencyTechnique = "exact"
        drawn[threshold] = draw(view)
        if hasattr(view, "TranslucencyTechnique"):
            drawn["fragments", threshold] = view.TranslucencyFragments
    return drawn, right, wrong


def remote_both(folder):
    drawn, right, _ = remote(folder)
    for threshold in (0, 1000):
        expect_near(drawn[threshold], right, 1, f"threshold {threshold}")
        assert drawn["fragments", threshold] == LAYERS * SIZE * SIZE, drawn["fragments", threshold]


def remote_ranks(_folder):
    """A server of two ranks, one of which draws what lies behind the other's."""
    view = new_view(axis=0, squares=4)
    view.RemoteRenderThreshold = 0
    expect_near(draw(view), over()[0], 2, "drawn by the server's ranks")
    assert view.TranslucencyFragments == LAYERS * SIZE * SIZE, view.TranslucencyFragments
    assert view.TranslucencyDeepestPixel == LAYERS / 2, view.TranslucencyDeepestPixel


def remote_client_only(folder):
    drawn, _, wrong = remote(folder)
    for threshold in (0, 1000):
        expect_near(drawn[threshold], wrong, 0, f"threshold {threshold}")


def remote_server_only(folder):
    drawn, right, wrong = remote(folder)
    expect_near(drawn[0], right, 1, "drawn by the server")
    expect_near(drawn[1000], wrong, 0, "drawn by the client")


def gui(folder):
    """In paraview itself, in the view that is there when it starts."""
    view = GetActiveViewOrCreate("RenderView")
    assert view.TranslucencyTechnique == "exact", view.TranslucencyTechnique
    set_up(view)
    name = str(folder / "gui.png")
    SaveScreenshot(name, view, ImageResolution=[SIZE, SIZE])
    expect_near(read(name), over()[0], 1, "a screenshot")
