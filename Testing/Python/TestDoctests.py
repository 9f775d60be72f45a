"""The examples in the docstrings of vtktranslucency do what they say. renderer is one with a translucent square, of 50 x 50 pixels."""

import doctest
import sys

import vtktranslucency
from vtk_under_test import vtk


def square():
    plane = vtk.vtkPlaneSource()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(0.5)
    renderer = vtk.vtkRenderer()
    renderer.AddActor(actor)
    renderer.GetActiveCamera().ParallelProjectionOn()
    renderer.GetActiveCamera().SetParallelScale(1)
    window = vtk.vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(100, 100)
    window.AddRenderer(renderer)
    return renderer, window


renderer, window = square()
names = {"renderer": renderer, "vtktranslucency": vtktranslucency}
failed, tried = doctest.testmod(vtktranslucency, extraglobs=names, optionflags=doctest.ELLIPSIS)
print(f"{tried - failed} passed, {failed} failed")
sys.exit(failed > 0 or tried < 10)  # what is documented has examples
