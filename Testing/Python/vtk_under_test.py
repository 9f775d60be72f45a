"""vtk: VTK's classes, of the distribution that vtktranslucency was built with."""

import importlib

from vtktranslucency._vtk import PACKAGE

vtk = importlib.import_module("vtkmodules.all" if PACKAGE == "vtkmodules" else PACKAGE)  # others have them in their root
