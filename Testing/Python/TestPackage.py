"""The package vtktranslucency: enable, techniques, options, and what they say of bad input."""

import contextlib
import os
import sys
import tempfile
import unittest

import vtkmodules.vtkRenderingOpenGL2  # the classes that draw
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

import vtktranslucency


def translucent_scene():
    """A window with two spheres, one inside the other: four fragments in the middle."""
    renderer = vtkRenderer()
    for radius in (1, 2):
        sphere = vtkSphereSource()
        sphere.SetRadius(radius)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(sphere.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetOpacity(0.3)
        renderer.AddActor(actor)
    window = vtkRenderWindow()
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


class TestEnable(unittest.TestCase):
    def test_default_is_adaptive(self):
        renderer = vtkRenderer()
        technique_pass = vtktranslucency.enable(renderer)
        self.assertIsInstance(technique_pass, vtktranslucency.vtkAdaptiveTransparencyPass)
        self.assertEqual(technique_pass.GetNodeCount(), 16)
        self.assertIs(renderer.GetPass().GetTranslucentPass(), technique_pass)

    def test_options_reach_the_pass(self):
        technique_pass = vtktranslucency.enable(vtkRenderer(), "adaptive", nodes=8, removal="mixed", memory_limit=12.5)
        self.assertEqual(technique_pass.GetNodeCount(), 8)
        self.assertEqual(technique_pass.GetNodeRemoval(), technique_pass.Mixed)
        self.assertEqual(technique_pass.GetStorage().GetMemoryLimit(), 12.5)
        self.assertEqual(technique_pass.GetOption("removal"), "mixed")

    def test_takes_what_has_a_renderer(self):
        renderer = vtkRenderer()
        technique_pass = vtktranslucency.enable(HasRenderer(renderer), "exact")
        self.assertIs(renderer.GetPass().GetTranslucentPass(), technique_pass)

    def test_every_technique(self):
        for name in vtktranslucency.techniques():
            self.assertIsNotNone(vtktranslucency.enable(vtkRenderer(), name))

    def test_a_second_call_replaces_the_first(self):
        renderer = vtkRenderer()
        vtktranslucency.enable(renderer, "exact")
        technique_pass = vtktranslucency.enable(renderer, "adaptive")
        self.assertIs(renderer.GetPass().GetTranslucentPass(), technique_pass)


class TestBadInput(unittest.TestCase):
    def check(self, renderer, technique, options, expected):
        """The error is the exception and nothing else: no output, no change."""
        target = getattr(renderer, "renderer", renderer)
        previous = target.GetPass() if isinstance(target, vtkRenderer) else None
        with printed() as texts, self.assertRaisesRegex(ValueError, expected):
            vtktranslucency.enable(renderer, technique, **options)
        self.assertEqual(texts, [""])
        if isinstance(target, vtkRenderer):
            self.assertIs(target.GetPass(), previous)

    def test_technique(self):
        self.check(vtkRenderer(), "exakt", {}, "^there is no technique 'exakt', expected one of: exact, adaptive, ")
        self.check(vtkRenderer(), None, {}, "^there is no technique None, ")

    def test_option(self):
        self.check(vtkRenderer(), "exact", {"nodes": 3}, "^there is no option 'nodes', expected one of: ")
        self.check(vtkRenderer(), "blend", {"nodes": 3}, "^there is no option 'nodes', the technique 'blend' takes none$")

    def test_value(self):
        for value in (0, 65, -1, 1.5, "many", None, float("nan"), float("inf")):
            self.check(vtkRenderer(), "adaptive", {"nodes": value}, "^nodes is '.*', expected an integer in 1..64$")
        self.check(vtkRenderer(), "adaptive", {"removal": "none"}, "^removal is 'none', expected underestimate, ")
        self.check(vtkRenderer(), "exact", {"memory_limit": -1}, "^memory_limit is '-1', expected a number in ")

    def test_good_options_before_a_bad_one_change_nothing(self):
        renderer = vtkRenderer()
        vtktranslucency.enable(renderer, "exact")
        self.check(renderer, "adaptive", {"nodes": 8, "removal": "none"}, "^removal is ")

    def test_renderer(self):
        for candidate in (None, 3, vtkRenderWindow(), HasRenderer(None)):
            self.check(candidate, "exact", {}, "^renderer is of type .*, expected a vtkRenderer or ")

    def test_while_vtk_is_silent(self):
        vtkObject.GlobalWarningDisplayOff()
        try:
            self.check(vtkRenderer(), "adaptive", {"nodes": 0}, "^nodes is '0', ")
            self.assertFalse(vtkObject.GetGlobalWarningDisplay())
        finally:
            vtkObject.GlobalWarningDisplayOn()

    def test_options_of_no_technique(self):
        with self.assertRaisesRegex(ValueError, "^there is no technique 'exakt', "):
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
            technique_pass = vtktranslucency.enable(vtkRenderer(), technique)
            for keyword in vtktranslucency.options(technique):
                value = technique_pass.GetOption(keyword)
                self.assertTrue(technique_pass.SetOption(keyword, value), f"{technique}, {keyword}={value}")
                self.assertEqual(technique_pass.GetOption(keyword), value)


class TestTransmission(unittest.TestCase):
    def test_color(self):
        actor = vtkActor()
        vtktranslucency.vtkTranslucencyPass.SetTransmissionColor(actor, 1, 0.5, 0.25)
        color = [0, 0, 0]
        self.assertTrue(vtktranslucency.vtkTranslucencyPass.GetTransmissionColor(actor, color))
        self.assertEqual(color, [1, 0.5, 0.25])
        key = vtktranslucency.vtkTranslucencyPass.TRANSMISSION_COLOR()
        self.assertEqual(actor.GetPropertyKeys().Get(key), (1, 0.5, 0.25))


class TestStatistics(unittest.TestCase):
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


if __name__ == "__main__":
    unittest.main()
