"""The package vtktranslucency: enable, techniques, options, and what they say of bad input."""

import contextlib
import hashlib
import importlib.metadata
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import vtktranslucency
from vtk_under_test import PACKAGE, vtk


def translucent_scene():
    """A window with two spheres, one inside the other: four fragments in the middle."""
    renderer = vtk.vtkRenderer()
    for radius in (1, 2):
        sphere = vtk.vtkSphereSource()
        sphere.SetRadius(radius)
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(sphere.GetOutputPort())
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetOpacity(0.3)
        renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(100, 100)
    window.AddRenderer(renderer)
    return window, renderer


def two_planes():
    """A window of 100 x 100 pixels with two planes of 50 x 50, which overlap in 20 x 20."""
    renderer = vtk.vtkRenderer()
    for corner in (10, 40):
        plane = vtk.vtkPlaneSource()
        plane.SetOrigin(corner, corner, corner / 100)
        plane.SetPoint1(corner + 50, corner, corner / 100)
        plane.SetPoint2(corner, corner + 50, corner / 100)
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(plane.GetOutputPort())
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetOpacity(0.3)
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(50)
    camera.SetPosition(50, 50, 2)
    camera.SetFocalPoint(50, 50, 0)
    camera.SetClippingRange(1, 3)
    window = vtk.vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(100, 100)
    window.AddRenderer(renderer)
    return window, renderer


@contextlib.contextmanager
def printed():
    """What the process itself, not only Python, writes to stderr: a list of one text."""
    texts = []
    sys.stderr.flush()
    kept = os.dup(2)
    with tempfile.TemporaryFile() as file:
        os.dup2(file.fileno(), 2)
        try:
            yield texts
        finally:
            sys.stderr.flush()
            os.dup2(kept, 2)
            os.close(kept)
            file.seek(0)
            texts.append(file.read().decode())


class HasRenderer:
    """Such as PyVista's plotter."""

    def __init__(self, renderer):
        self.renderer = renderer


class Toolkit:
    """Such as PyVista, which builds a chain of its own around vtkRenderStepsPass and sets it anew with each effect, or null without any."""

    def __init__(self, window, renderer):
        self.window = window
        self.renderer = renderer
        self.steps = vtk.vtkRenderStepsPass()
        self.collection = vtk.vtkRenderPassCollection()
        self.collection.AddItem(self.steps)
        sequence = vtk.vtkSequencePass()
        sequence.SetPasses(self.collection)
        self.camera = vtk.vtkCameraPass()
        self.camera.SetDelegatePass(sequence)
        self.shadows = vtk.vtkShadowMapPass()
        self.effects = {name: getattr(vtk, name)() for name in ("vtkEDLShading", "vtkSSAOPass", "vtkSSAAPass")}
        self.enabled = set()

    def enable(self, name):
        self.enabled.add(name)
        self.update()

    def disable(self, name):
        self.enabled.discard(name)
        self.update()

    def update(self):
        for item in (self.shadows.GetShadowMapBakerPass(), self.shadows):
            self.collection.RemoveItem(item)
            if "shadows" in self.enabled:
                self.collection.AddItem(item)
        outer = self.camera
        for name, effect in self.effects.items():
            if name in self.enabled:
                effect.SetDelegatePass(outer)
                outer = effect
        self.renderer.SetPass(outer if self.enabled else None)

    def picture(self):
        return picture(self.window)

    def release(self):
        for each in (*self.effects.values(), self.shadows, self.shadows.GetShadowMapBakerPass()):
            each.ReleaseGraphicsResources(self.window)


def picture(window):
    """What stands for the window's picture: the same where that is."""
    window.Render()
    grabber = vtk.vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    grabber.ShouldRerenderOff()
    grabber.Update()
    return hashlib.sha256(memoryview(grabber.GetOutput().GetPointData().GetScalars())).hexdigest()


class TestEnable(unittest.TestCase):
    def test_version(self):
        """That of the distribution, where pip has installed one."""
        self.assertRegex(vtktranslucency.__version__, r"^\d+\.\d+\.\d+$")
        for distribution in importlib.metadata.distributions(name="vtktranslucency"):
            self.assertEqual(distribution.version, vtktranslucency.__version__)

    def test_default_is_adaptive(self):
        renderer = vtk.vtkRenderer()
        technique_pass = vtktranslucency.enable(renderer)
        self.assertIsInstance(technique_pass, vtktranslucency.vtkAdaptiveTransparencyPass)
        self.assertEqual(technique_pass.GetNodeCount(), 16)
        self.assertIs(renderer.GetPass().GetTranslucentPass(), technique_pass)

    def test_options_reach_the_pass(self):
        technique_pass = vtktranslucency.enable(vtk.vtkRenderer(), "adaptive", nodes=8, removal="mixed", memory_limit=12.5)
        self.assertEqual(technique_pass.GetNodeCount(), 8)
        self.assertEqual(technique_pass.GetNodeRemoval(), technique_pass.Mixed)
        self.assertEqual(technique_pass.GetStorage().GetMemoryLimit(), 12.5)
        self.assertEqual(technique_pass.GetOption("removal"), "mixed")

    def test_storage_and_its_sections_in_any_order(self):
        for options in ({"storage": "t-buffer", "section_length": 2}, {"section_length": 2, "storage": "t-buffer"}):
            technique_pass = vtktranslucency.enable(vtk.vtkRenderer(), "exact", **options)
            self.assertEqual(technique_pass.GetStorageDesign(), technique_pass.TBuffer)
            self.assertEqual(technique_pass.GetStorage().GetSectionLength(), 2)

    def test_takes_what_has_a_renderer(self):
        renderer = vtk.vtkRenderer()
        technique_pass = vtktranslucency.enable(HasRenderer(renderer), "exact")
        self.assertIs(renderer.GetPass().GetTranslucentPass(), technique_pass)

    def test_every_technique(self):
        for name in vtktranslucency.techniques():
            self.assertIsNotNone(vtktranslucency.enable(vtk.vtkRenderer(), name))

    def test_a_second_call_replaces_the_first(self):
        renderer = vtk.vtkRenderer()
        vtktranslucency.enable(renderer, "exact")
        technique_pass = vtktranslucency.enable(renderer, "adaptive")
        self.assertIs(renderer.GetPass().GetTranslucentPass(), technique_pass)


class TestEffects(unittest.TestCase):
    """What a toolkit enables before or after the technique is drawn together with it, and goes without it."""

    @staticmethod
    def scene():
        """The translucent spheres, with something opaque before and behind them, and a light that throws shadows."""
        window, renderer = translucent_scene()
        for radius, center in ((3, (0, 0, -5)), (0.6, (1, 1, 2))):
            sphere = vtk.vtkSphereSource()
            sphere.SetRadius(radius)
            sphere.SetCenter(center)
            mapper = vtk.vtkPolyDataMapper()
            mapper.SetInputConnection(sphere.GetOutputPort())
            actor = vtk.vtkActor()
            actor.SetMapper(mapper)
            renderer.AddActor(actor)
        light = vtk.vtkLight()
        light.PositionalOn()
        light.SetPosition(3, 3, 12)
        light.SetFocalPoint(0, 0, -3)
        light.SetConeAngle(40)
        renderer.AddLight(light)
        return window, renderer

    def test_in_any_order(self):
        for effect in ("vtkEDLShading", "vtkSSAOPass", "vtkSSAAPass", "shadows"):
            for samples in (0, 4):
                pictures = []
                for first in (True, False):
                    with self.subTest(effect=effect, samples=samples, first=first):
                        window, renderer = self.scene()
                        window.SetMultiSamples(samples)
                        toolkit = Toolkit(window, renderer)
                        stock = toolkit.picture()
                        vtktranslucency.enable(renderer, "exact")
                        alone = toolkit.picture()
                        if first:
                            vtktranslucency.disable(renderer)
                            toolkit.enable(effect)
                            toolkit.picture()
                            vtktranslucency.enable(renderer, "exact")
                        else:
                            toolkit.enable(effect)
                        pictures += [toolkit.picture() for _ in range(2)]
                        self.assertNotEqual(pictures[-1], alone)
                        toolkit.disable(effect)
                        self.assertEqual(toolkit.picture(), alone)
                        vtktranslucency.disable(renderer)
                        self.assertEqual(toolkit.picture(), stock)
                        self.assertIsNone(renderer.GetPass())
                        self.assertIsInstance(toolkit.steps.GetTranslucentPass(), vtk.vtkTranslucentPass)
                        toolkit.release()
                self.assertEqual(set(pictures), {pictures[0]})

    def test_of_the_renderer(self):
        window, renderer = self.scene()
        vtktranslucency.enable(renderer, "exact")
        without = picture(window)
        renderer.UseFXAAOn()
        smoothed = picture(window)
        self.assertNotEqual(smoothed, without)
        vtktranslucency.disable(renderer)
        vtktranslucency.enable(renderer, "exact")
        self.assertEqual(picture(window), smoothed)
        renderer.UseFXAAOff()
        self.assertEqual(picture(window), without)

    def test_of_a_toolkit_that_sets_passes_when_a_frame_starts(self):
        window, renderer = self.scene()
        vtktranslucency.enable(renderer, "exact")
        expected = picture(window)
        camera = vtk.vtkCameraPass()
        camera.SetDelegatePass(vtk.vtkRenderStepsPass())
        for chain in (camera, None):
            for before in (True, False):
                vtktranslucency.disable(renderer)
                if not before:
                    vtktranslucency.enable(renderer, "exact")
                observer = renderer.AddObserver("StartEvent", lambda *_: renderer.SetPass(chain))
                if before:
                    vtktranslucency.enable(renderer, "exact")
                self.assertEqual(picture(window), expected)
                renderer.RemoveObserver(observer)

    def test_volumes_of_a_chain_are_drawn_among_the_surfaces(self):
        window, renderer = translucent_scene()
        source = vtk.vtkRTAnalyticSource()
        source.SetWholeExtent(-8, 8, -8, 8, -8, 8)
        mapper = vtk.vtkGPUVolumeRayCastMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        opacity = vtk.vtkPiecewiseFunction()
        opacity.AddPoint(100, 0)
        opacity.AddPoint(280, 0.3)
        volume = vtk.vtkVolume()
        volume.SetMapper(mapper)
        volume.SetScale(0.2)
        volume.GetProperty().SetScalarOpacity(opacity)
        renderer.AddVolume(volume)
        vtktranslucency.enable(renderer, "exact")
        expected = picture(window)
        vtktranslucency.disable(renderer)
        sequence = vtk.vtkSequencePass()
        sequence.SetPasses(vtk.vtkRenderPassCollection())
        for name in ("vtkLightsPass", "vtkOpaquePass", "vtkTranslucentPass", "vtkVolumetricPass"):
            sequence.GetPasses().AddItem(getattr(vtk, name)())
        camera = vtk.vtkCameraPass()
        camera.SetDelegatePass(sequence)
        for chain in (vtk.vtkRenderStepsPass(), camera):
            renderer.SetPass(chain)
            stock = picture(window)
            self.assertNotEqual(stock, expected)
            vtktranslucency.enable(renderer, "exact")
            self.assertEqual(picture(window), expected)
            vtktranslucency.disable(renderer)
            self.assertEqual(picture(window), stock)


class TestBadInput(unittest.TestCase):
    def check(self, renderer, technique, options, expected):
        """The error is the exception and nothing else: no output, no change."""
        target = getattr(renderer, "renderer", renderer)
        previous = target.GetPass() if isinstance(target, vtk.vtkRenderer) else None
        with printed() as texts, self.assertRaisesRegex(ValueError, expected):
            vtktranslucency.enable(renderer, technique, **options)
        self.assertEqual(texts, [""])
        if isinstance(target, vtk.vtkRenderer):
            self.assertIs(target.GetPass(), previous)

    def test_technique(self):
        self.check(
            vtk.vtkRenderer(), "exakt", {},
            "^there is no technique 'exakt', did you mean 'exact'\\? Expected one of: exact, adaptive, ")
        self.check(vtk.vtkRenderer(), "Sort", {}, "^there is no technique 'Sort', did you mean 'sorted'\\? ")
        for name in (None, [], "depth test"):
            self.check(vtk.vtkRenderer(), name, {}, "^there is no technique .*. Expected one of: exact, adaptive, ")

    def test_option(self):
        self.check(
            vtk.vtkRenderer(), "exact", {"nodes": 3},
            "^there is no option 'nodes' of the technique 'exact'. Expected one of: .*storage, ")
        self.check(
            vtk.vtkRenderer(), "adaptive", {"node": 3},
            "^there is no option 'node' of the technique 'adaptive', did you mean 'nodes'\\? Expected one of: ")
        self.check(
            vtk.vtkRenderer(), "blend", {"nodes": 3},
            "^there is no option 'nodes' of the technique 'blend': it takes none$")

    def test_value(self):
        for value in (0, 65, -1, 1.5, "many", None, float("nan"), float("inf")):
            self.check(vtk.vtkRenderer(), "adaptive", {"nodes": value}, "^nodes is '.*', expected an integer in 1..64$")
        self.check(vtk.vtkRenderer(), "adaptive", {"removal": "none"}, "^removal is 'none', expected underestimate, ")
        self.check(vtk.vtkRenderer(), "exact", {"memory_limit": -1}, "^memory_limit is '-1', expected a number in ")

    def test_storage(self):
        self.check(
            vtk.vtkRenderer(), "exact", {"storage": "x-buffer"},
            "^storage is 'x-buffer', expected linked-list, t-buffer, r-buffer or m-buffer$")
        for value in (0, -1, 65, 10000, 2.5, "long", None):
            for storage in ("linked-list", "t-buffer", "m-buffer"):
                self.check(
                    vtk.vtkRenderer(), "exact", {"storage": storage, "section_length": value},
                    "^section_length is '.*', expected an integer in 1..64$")

    def test_good_options_before_a_bad_one_change_nothing(self):
        renderer = vtk.vtkRenderer()
        technique_pass = vtktranslucency.enable(renderer, "exact")
        self.check(renderer, "adaptive", {"nodes": 8, "removal": "none"}, "^removal is ")
        self.assertIs(renderer.GetPass().GetTranslucentPass(), technique_pass)

    def test_renderer(self):
        expected = r"^renderer is of type \w+\.\w+.*, expected a \w+\.vtkRenderingCore\.vtkRenderer or "
        for candidate in (None, 3, vtk.vtkRenderWindow(), HasRenderer(None)):
            self.check(candidate, "exact", {}, expected)
            for function in (vtktranslucency.disable, vtktranslucency.statistics):
                with self.assertRaisesRegex(ValueError, expected):
                    function(candidate)

    def test_renderer_of_another_vtk(self):
        other = type("vtkRenderer", (), {"__module__": "other.vtkRenderingCore"})
        for candidate in (other(), HasRenderer(type("Renderer", (other,), {})())):
            self.check(
                candidate, "exact", {},
                r"^the renderer is one of other\.vtkRenderingCore, expected one of \w+\.vtkRenderingCore, with which ")

    def test_disabling_what_was_not_enabled(self):
        renderer = vtk.vtkRenderer()
        chain = vtk.vtkRenderStepsPass()
        renderer.SetPass(chain)
        for _ in range(2):
            with self.assertRaisesRegex(ValueError, r"^the renderer has no technique: expected one that enable\(\) was"):
                vtktranslucency.disable(HasRenderer(renderer))
            self.assertIs(renderer.GetPass(), chain)
            vtktranslucency.enable(renderer)
            vtktranslucency.disable(renderer)

    def test_statistics_of_no_frame(self):
        window, renderer = translucent_scene()
        with self.assertRaisesRegex(ValueError, "^the renderer has no technique: "):
            vtktranslucency.statistics(renderer)
        vtktranslucency.enable(renderer)
        with self.assertRaisesRegex(ValueError, "^the renderer has drawn no frame: expected one whose window's "):
            vtktranslucency.statistics(renderer)
        vtktranslucency.enable(renderer, "blend")
        window.Render()
        with self.assertRaisesRegex(ValueError, "^the renderer draws with VTK's own vtk.*TranslucentPass, which keeps no "):
            vtktranslucency.statistics(renderer)

    def test_a_renderer_without_a_window(self):
        renderer = vtk.vtkRenderer()
        vtktranslucency.enable(renderer)
        with self.assertRaisesRegex(ValueError, "^the renderer is in no window: expected one whose window's Render"):
            vtktranslucency.statistics(renderer)
        window, _ = translucent_scene()
        window.AddRenderer(renderer)
        window.Render()
        self.assertEqual(vtktranslucency.statistics(renderer)["fragments"], 0)
        vtktranslucency.disable(renderer)

    def enable_elsewhere(self, **environment):
        """What enable() raises in a process with this environment, which has to end well and says nothing else."""
        code = (
            "import vtktranslucency\n"
            f"from {PACKAGE} import vtkCommonCore, vtkRenderingCore\n"  # no more: others want an EGL before there is a window
            "vtkCommonCore.vtkObject.GlobalWarningDisplayOff()\n"
            "log = vtkCommonCore.vtkLogger; log.SetStderrVerbosity(log.VERBOSITY_OFF)\n"  # of what VTK tries first, it says so here
            "window = vtkRenderingCore.vtkRenderWindow()\n"
            "log.SetStderrVerbosity(log.VERBOSITY_INFO)\n"
            "renderer = vtkRenderingCore.vtkRenderer(); window.AddRenderer(renderer)\n"
            "try: vtktranslucency.enable(renderer)\n"
            "except ValueError as error: print(error)")
        changed = {name: value for name, value in {**os.environ, **environment}.items() if value is not None}
        run = subprocess.run([sys.executable, "-c", code], env=changed, capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return run.stdout

    def test_a_window_without_a_display(self):
        """Up to VTK 9.3 its first frame would end the process; since, there is EGL and OSMesa, which are taken away here."""
        with tempfile.TemporaryDirectory() as folder:
            for name in ("libEGL.so.1", "libEGL.so", "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
                pathlib.Path(folder, name).touch()
            said = self.enable_elsewhere(LD_LIBRARY_PATH=folder, DISPLAY=None, VTK_DEFAULT_OPENGL_WINDOW=None)
        self.assertRegex(said, r"^VTK can't draw in the renderer's window: there is no X display \(DISPLAY is not set\), .*expected one")

    @unittest.skipUnless(os.environ.get("DISPLAY"), "for X: EGL refuses what Mesa pretends to be old, and OSMesa does not pretend")
    def test_a_window_with_an_old_opengl(self):
        said = self.enable_elsewhere(MESA_GL_VERSION_OVERRIDE="2.1")
        self.assertRegex(said, "^VTK can't draw in the renderer's window: .* has no OpenGL 3.2, which VTK draws with: expected a driver")

    def test_what_no_window_lacks(self):
        self.assertEqual(vtktranslucency.vtkTranslucencyFactory.GetMissing("exact", None), "a window")
        self.assertEqual(vtktranslucency.vtkTranslucencyDisplay.GetMissing(None), "the window is null, expected a vtkRenderWindow")

    def test_while_vtk_is_silent(self):
        vtk.vtkObject.GlobalWarningDisplayOff()
        try:
            self.check(vtk.vtkRenderer(), "adaptive", {"nodes": 0}, "^nodes is '0', ")
            self.assertFalse(vtk.vtkObject.GetGlobalWarningDisplay())
        finally:
            vtk.vtkObject.GlobalWarningDisplayOn()

    def test_options_of_no_technique(self):
        with self.assertRaisesRegex(ValueError, "^there is no technique 'exakt', did you mean 'exact'"):
            vtktranslucency.options("exakt")


class TestTables(unittest.TestCase):
    def test_techniques(self):
        techniques = vtktranslucency.techniques()
        self.assertLessEqual({"exact", "adaptive", "blend"}, set(techniques))
        self.assertTrue(all(techniques.values()))

    def test_options(self):
        self.assertEqual(vtktranslucency.options("blend"), {})
        options = vtktranslucency.options("adaptive")
        self.assertLessEqual({"nodes", "removal", "memory_limit"}, set(options))
        self.assertIn("1..64", options["nodes"])

    def test_options_round_trip(self):
        """Each option takes back the text of its own value."""
        for technique in vtktranslucency.techniques():
            technique_pass = vtktranslucency.enable(vtk.vtkRenderer(), technique)
            for keyword in vtktranslucency.options(technique):
                value = technique_pass.GetOption(keyword)
                self.assertTrue(technique_pass.SetOption(keyword, value), f"{technique}, {keyword}={value}")
                self.assertEqual(technique_pass.GetOption(keyword), value)


class TestTransmission(unittest.TestCase):
    def test_color(self):
        actor = vtk.vtkActor()
        vtktranslucency.vtkTranslucencyPass.SetTransmissionColor(actor, 1, 0.5, 0.25)
        color = [0, 0, 0]
        self.assertTrue(vtktranslucency.vtkTranslucencyPass.GetTransmissionColor(actor, color))
        self.assertEqual(color, [1, 0.5, 0.25])
        key = vtktranslucency.vtkTranslucencyPass.TRANSMISSION_COLOR()
        self.assertEqual(actor.GetPropertyKeys().Get(key), (1, 0.5, 0.25))


class TestStatistics(unittest.TestCase):
    def test_as_a_dictionary(self):
        window, renderer = translucent_scene()
        technique_pass = vtktranslucency.enable(renderer, "exact")
        technique_pass.MeasureTimesOn()
        window.Render()
        kept = technique_pass.GetStatistics()
        numbers = vtktranslucency.statistics(HasRenderer(renderer))
        times = {name: numbers.pop(name) for name in ("gather_time", "resolve_time")}
        self.assertEqual(numbers, {
            "fragments": kept.GetFragments(), "deepest_pixel": 4, "bytes": kept.GetBytes(), "tiles": 1,
            "geometry_passes": kept.GetGeometryPasses(), "screen_passes": kept.GetScreenPasses(),
            "shader_builds": kept.GetShaderBuilds(), "fallback": ""})
        self.assertGreater(min(times.values()), 0)
        vtktranslucency.enable(renderer, "auto")
        window.Render()
        self.assertEqual(vtktranslucency.statistics(renderer)["chosen"], "exact")
        self.assertIn("budget", vtktranslucency.statistics(renderer)["reason"])

    def test_of_a_frame(self):
        for technique in ("exact", "adaptive"):
            window, renderer = translucent_scene()
            technique_pass = vtktranslucency.enable(renderer, technique)
            window.Render()
            statistics = technique_pass.GetStatistics()
            self.assertEqual(statistics.GetFallback(), "")
            self.assertEqual(statistics.GetDeepestPixel(), 4)
            self.assertGreater(statistics.GetFragments(), 1000)
            self.assertGreaterEqual(statistics.GetBytes(), 16 * statistics.GetFragments())
            self.assertEqual(statistics.GetTiles(), 1)

    def test_accesses_to_the_storage(self):
        window, renderer = two_planes()
        exact = vtktranslucency.enable(renderer, "exact", storage="t-buffer", section_length=2)
        window.Render()
        counting = vtktranslucency.vtkStorageCountPass()
        counting.SetOption("storage", "t-buffer")
        counting.SetOption("section_length", "2")
        self.assertEqual(counting.GetAccesses(), -1)
        vtktranslucency.vtkTranslucencyFactory.Enable(renderer, counting)
        window.Render()
        overlap, pixels, fragments = 20 * 20, 2 * 50 * 50 - 20 * 20, 2 * 50 * 50
        self.assertEqual(counting.GetStatistics().GetFragments(), fragments)
        self.assertEqual(counting.GetStores(), fragments)
        self.assertEqual(counting.GetReads(), fragments)
        self.assertEqual(counting.GetTableAccesses(), pixels)
        self.assertEqual(counting.GetSecondDepthAccesses(), 0)
        self.assertEqual(counting.GetFrameBufferAccesses(), 0)
        self.assertEqual(counting.GetAccesses(), 2 * fragments + pixels)
        self.assertEqual([counting.GetPixelsHolding(count) for count in (1, 2, 3)], [pixels - overlap, overlap, 0])
        self.assertEqual(counting.GetStatistics().GetDeepestPixel(), 2)
        self.assertEqual(counting.GetSectionFragments(), 2)
        self.assertGreater(counting.GetPackedBytes(), 0)
        self.assertGreaterEqual(counting.GetStatistics().GetBytes(),
            exact.GetStatistics().GetBytes() + 4 * 100 * 100)  # each pixel's count


if __name__ == "__main__":
    unittest.main()
