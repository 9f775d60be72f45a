"""PyVista's plotters: with its defaults, off screen, in notebooks, with subplots, with its effects, and in pyvista-render-passes.

Exits with 77, which ctest takes for skipped, where PyVista is not installed.
"""

import importlib.util
import pathlib
import runpy
import sys
import tempfile
import unittest

if importlib.util.find_spec("pyvista") is None:
    print("skipped: this Python has no PyVista")
    sys.exit(77)

import numpy
import pyvista
import vtktranslucency

SPHERES = (((-0.25, 0, 0), "orangered"), ((0.25, 0, 0), "seagreen"), ((0, 0, 0.4), "royalblue"))
EXAMPLE = pathlib.Path(__file__).parents[2] / "Examples" / "Python" / "pyvista_spheres.py"


def new_plotter(samples=None, **settings):
    """Three translucent spheres. PyVista asks for 8 samples unless it is told otherwise."""
    plotter = pyvista.Plotter(off_screen=True, window_size=(300, 200), **settings)
    if samples is not None:
        plotter.render_window.SetMultiSamples(samples)
    add_spheres(plotter)
    return plotter


def add_spheres(plotter):
    for center, color in SPHERES:
        plotter.add_mesh(pyvista.Sphere(center=center), color=color, opacity=0.4)


def picture(plotter):
    """Of a new frame, as floats, so that pictures can be subtracted."""
    plotter.render()
    return plotter.screenshot(return_img=True).astype(float)


def one_sample(technique, scale=1):
    """The picture where a pixel is scale x scale of one sample each."""
    plotter = new_plotter(samples=0)
    plotter.window_size = [scale * size for size in plotter.window_size]
    vtktranslucency.enable(plotter, technique)
    fine = picture(plotter)
    height, width = (size // scale for size in fine.shape[:2])
    return fine.reshape(height, scale, width, scale, 3).mean(axis=(1, 3))


def difference(one, other):
    """Of each pixel, the largest of its channels'."""
    return numpy.abs(one - other).max(axis=-1)


class TestDefaults(unittest.TestCase):
    def test_smooth_and_right_where_stock_peeling_draws_nothing(self):
        stock = new_plotter()
        stock.enable_depth_peeling()
        self.assertEqual(len(numpy.unique(picture(stock).reshape(-1, 3), axis=0)), 1, "only the background")

        coarse = one_sample("exact")
        right = one_sample("exact", scale=4)
        edges = sum(difference(coarse, numpy.roll(coarse, shift, axis)) > 8 for shift in (-1, 1) for axis in (0, 1)) > 0
        for technique in ("exact", "adaptive"):
            plotter = new_plotter()
            self.assertEqual(plotter.render_window.GetMultiSamples(), 8)
            vtktranslucency.enable(plotter, technique)
            drawn = picture(plotter)
            self.assertEqual(vtktranslucency.statistics(plotter)["fallback"], "")
            self.assertLessEqual(difference(drawn, right)[~edges].max(), 8, "right")
            jagged = difference(coarse, right)[edges].mean()
            self.assertLess(difference(drawn, right)[edges].mean(), 0.6 * jagged, "smooth")

    def test_disabled_as_it_was(self):
        plotter = new_plotter()
        stock = picture(plotter)
        vtktranslucency.enable(plotter)
        self.assertGreater(difference(picture(plotter), stock).max(), 20)
        vtktranslucency.disable(plotter)
        self.assertEqual(difference(picture(plotter), stock).max(), 0)


class TestPictures(unittest.TestCase):
    def test_of_notebooks(self):
        expected = one_sample("exact")
        plotter = new_plotter(samples=0, notebook=True)
        vtktranslucency.enable(plotter, "exact")
        shown = numpy.asarray(plotter.show(jupyter_backend="static", return_viewer=True), float)
        self.assertEqual(difference(shown, expected).max(), 0)

    def test_of_show(self):
        plotter = new_plotter(samples=0)
        vtktranslucency.enable(plotter, "exact")
        plotter.show(auto_close=False)
        self.assertEqual(difference(picture(plotter), one_sample("exact")).max(), 0)

    def test_of_the_example(self):
        plotter = new_plotter()
        vtktranslucency.enable(plotter)
        plotter.window_size = pyvista.global_theme.window_size
        with tempfile.TemporaryDirectory() as folder:
            name = str(pathlib.Path(folder) / "spheres.png")
            arguments, sys.argv = sys.argv, [str(EXAMPLE), name]
            try:
                runpy.run_path(str(EXAMPLE), run_name="__main__")
            finally:
                sys.argv = arguments
            drawn = pyvista.read_texture(name).to_array().astype(float)
        self.assertEqual(difference(drawn[..., :3], picture(plotter)).max(), 0)


class TestSubplots(unittest.TestCase):
    def test_the_active_one_is_meant(self):
        plotter = new_plotter(samples=0, shape=(1, 2))
        vtktranslucency.enable(plotter, "weighted")
        plotter.subplot(0, 1)
        add_spheres(plotter)
        vtktranslucency.enable(plotter, "exact")
        left, right = (vtktranslucency.vtkTranslucencyFactory.GetTechnique(each) for each in plotter.renderers)
        self.assertIsInstance(left, vtktranslucency.vtkWeightedTransparencyPass)
        self.assertIsInstance(right, vtktranslucency.vtkABufferPass)
        plotter.link_views()
        both = picture(plotter)
        self.assertGreater(difference(both[:, :149], both[:, 151:]).max(), 20)
        for renderer in plotter.renderers:
            vtktranslucency.enable(renderer, "exact")
        both = picture(plotter)
        self.assertLessEqual(difference(both[:, 1:149], both[:, 151:299]).max(), 1)


class TestEffects(unittest.TestCase):
    effects = {
        "ssaa": lambda plotter: plotter.enable_anti_aliasing("ssaa"),
        "fxaa": lambda plotter: plotter.enable_anti_aliasing("fxaa"),
        "eye-dome lighting": lambda plotter: plotter.enable_eye_dome_lighting(),
        "occlusion": lambda plotter: plotter.enable_ssao(radius=0.3),
        "shadows": lambda plotter: plotter.enable_shadows(),
        "depth peeling": lambda plotter: plotter.enable_depth_peeling(),
    }

    def draw(self, samples, *changes):
        plotter = new_plotter(samples)
        plotter.add_mesh(pyvista.Cube(center=(0, 0, -1)), color="gold")
        for change in changes:
            change(plotter)
        drawn = picture(plotter)
        self.assertEqual(difference(picture(plotter), drawn).max(), 0, "the second frame")
        self.assertEqual(vtktranslucency.statistics(plotter)["fallback"], "")
        self.assertGreater(vtktranslucency.statistics(plotter)["fragments"], 1000)
        plotter.close()
        return drawn

    def test_before_and_after(self):
        def enable(plotter):
            vtktranslucency.enable(plotter, "exact")

        for samples in (0, 8):
            without = self.draw(samples, enable)
            for name, effect in self.effects.items():
                with self.subTest(effect=name, samples=samples):
                    before = self.draw(samples, effect, enable)
                    after = self.draw(samples, enable, effect)
                    self.assertEqual(difference(before, after).max(), 0)
                    self.assertEqual(difference(before, without).max() > 0, name != "depth peeling")


@unittest.skipUnless(importlib.util.find_spec("pyvista_render_passes"), "this Python has no pyvista-render-passes")
class TestRenderPasses(unittest.TestCase):
    """Its chain's windows have one sample, unless they are told otherwise."""

    @staticmethod
    def with_volume():
        plotter = new_plotter(samples=0)
        volume = pyvista.Wavelet(extent=(-5, 5, -5, 5, -5, 5), maximum=250).scale(0.08)
        plotter.add_volume(volume, opacity=[0, 0.4], show_scalar_bar=False)
        return plotter

    @staticmethod
    def register(plotter, *technique, **options):
        from pyvista_render_passes import register_pass_provider
        from vtktranslucency.render_passes import TranslucencyProvider

        return register_pass_provider(plotter, TranslucencyProvider(*technique, **options))

    def expected_with_volume(self):
        plotter = self.with_volume()
        stock = picture(plotter)
        vtktranslucency.enable(plotter, "exact")
        expected = picture(plotter)
        self.assertGreater(difference(expected, stock).max(), 20)
        return expected

    def check(self, plotter, expected):
        for frame in range(2):
            self.assertEqual(difference(picture(plotter), expected).max(), 0, f"frame {frame}")

    def test_enable_before_and_after_the_chain(self):
        expected = self.expected_with_volume()
        for first in (True, False):
            plotter = self.with_volume()
            if first:
                vtktranslucency.enable(plotter, "exact")
            plotter.render_passes.enable_depth_peeling()
            if not first:
                vtktranslucency.enable(plotter, "exact")
            self.check(plotter, expected)

    def test_provider_with_volumes(self):
        from pyvista_render_passes import unregister_pass_provider

        expected = self.expected_with_volume()
        plotter = self.with_volume()
        plotter.render_passes.enable_depth_peeling()
        stock = picture(plotter)
        provider = self.register(plotter, "exact", memory_limit=100)
        with self.assertRaisesRegex(ValueError, "^the provider has drawn no frame: expected one that is registered, "):
            provider.statistics()
        self.check(plotter, expected)
        self.assertGreater(provider.statistics()["fragments"], 1000)
        state = plotter.render_passes.get_state()
        self.assertEqual(
            state["providers"]["vtktranslucency"], {"technique": "exact", "options": {"memory_limit": 100}})
        state["providers"]["vtktranslucency"] = {"technique": "adaptive", "options": {"nodes": 1}}
        plotter.render_passes.set_state(state)
        self.assertGreater(difference(picture(plotter), expected).max(), 4)
        unregister_pass_provider(plotter, provider)
        self.check(plotter, stock)

    def test_provider_with_effects(self):
        """Stock depth peeling is right, too, where windows have one sample."""
        for effect in ("enable_anti_aliasing", "enable_edl", "enable_ssao", "enable_shadows", "enable_blur"):
            with self.subTest(effect=effect):
                pictures = []
                for own in (False, True):
                    plotter = new_plotter(samples=0)
                    plotter.add_mesh(pyvista.Cube(center=(0, 0, -1)), color="gold")
                    plotter.render_passes.enable_depth_peeling(16)
                    getattr(plotter.render_passes, effect)()
                    if own:
                        self.register(plotter, "exact")
                    pictures.append(picture(plotter))
                self.assertLessEqual(difference(*pictures).max(), 4)

    def test_bad_input(self):
        plotter = new_plotter(samples=0)
        provider = self.register(plotter, "exact")
        drawn = picture(plotter)
        with self.assertRaisesRegex(ValueError, "^there is no technique 'exakt', did you mean 'exact'"):
            provider.set_state({"technique": "exakt"})
        provider.invalidate()
        self.check(plotter, drawn)
        with self.assertRaisesRegex(ValueError, "^there is no option 'node' of the technique 'adaptive', did you mean 'nodes'"):
            self.register(plotter, "adaptive", node=3)


if __name__ == "__main__":
    unittest.main()
