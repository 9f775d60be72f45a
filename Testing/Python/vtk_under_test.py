"""vtk: VTK's classes, of the distribution that vtktranslucency was built with."""

import importlib

from vtktranslucency._vtk import PACKAGE

# Others than Kitware's give each class in their root, from a module that is loaded when its first class is asked for.
vtk = importlib.import_module("vtkmodules.all" if PACKAGE == "vtkmodules" else PACKAGE)
importlib.import_module(f"{PACKAGE}.vtkRenderingVolumeOpenGL2")  # by whose classes those of vtkRenderingVolume draw
