"""Beside another VTK than the one that it was built with, the package says so, and loads nothing that could end the process."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from vtktranslucency import _vtk

LOADED = "import sys; sys.excepthook = lambda kind, error, trace: print(kind.__name__, error, *sys.modules); import vtktranslucency"


class TestWrongVTK(unittest.TestCase):
    def check(self, files, *expected):
        """The package is imported where these files, by their names, come before all others."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            code = f"import sys; sys.path.insert(0, {folder!r}); {LOADED}"
            run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (1, ""))
        self.assertTrue(run.stdout.startswith("ImportError "), run.stdout)
        for text in expected:
            self.assertIn(text, run.stdout)
        self.assertNotIn("vtktranslucency.vtkRenderingTranslucency", run.stdout)

    def test_other_release(self):
        core = "class vtkObject: pass\nclass vtkVersion:\n    GetVTKVersion = staticmethod(lambda: '8.2.0')\n"
        rendering = "class vtkRenderer: pass\nclass vtkRenderPass: pass\n"
        names = ("__init__", "vtkCommonCore", "vtkRenderingCore")
        self.check(
            {f"{_vtk.PACKAGE}/{name}.py": text for name, text in zip(names, ("", core, rendering))},
            f"the package {_vtk.PACKAGE} is of version 8.2.0, but vtktranslucency was built with {_vtk.VERSION}. ")

    def test_parts_missing(self):
        self.check(
            {f"{_vtk.PACKAGE}/__init__.py": "", f"{_vtk.PACKAGE}/vtkCommonCore.py": "class vtkObject: pass\nvtkVersion = vtkObject"},
            f"vtktranslucency was built with VTK {_vtk.VERSION} of the package {_vtk.PACKAGE}, which can't be imported: ",
            "vtkRenderingCore")

    @unittest.skipUnless(_vtk.DISTRIBUTION, "not installed as a wheel")
    def test_other_wheel(self):
        name, _, version = _vtk.DISTRIBUTION.partition("==")
        name = name.partition("[")[0]
        self.check(
            {f"{name}-0.1.dist-info/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: 0.1\n"},
            f"the distribution {name} is of version 0.1, but vtktranslucency was built with {version}. Install that: pip install ")


if __name__ == "__main__":
    unittest.main()
