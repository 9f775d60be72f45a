"""vtk_orbital.py FILE [enable]: surfaces of equal density of a hydrogen atom's orbital, all in one mesh, without vtktranslucency and with it."""

import pathlib
import sys

from balls import PAGE_SIZE
from vtkmodules import all as vtk

reader = vtk.vtkXMLImageDataReader()
reader.SetFileName(str(pathlib.Path(__file__).parents[2] / "Examples/Data/hydrogen.vti"))
reader.Update()
lowest, highest = reader.GetOutput().GetScalarRange()
surfaces = vtk.vtkContourFilter()
surfaces.SetInputConnection(reader.GetOutputPort())
for i, part in enumerate((0.08, 0.2, 0.4, 0.65)):
    surfaces.SetValue(i, lowest + part * (highest - lowest))
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(surfaces.GetOutputPort())
mapper.SetScalarRange(lowest, highest)
actor = vtk.vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetOpacity(0.4)

renderer = vtk.vtkRenderer()
renderer.SetBackground(1, 1, 1)
renderer.AddActor(actor)
window = vtk.vtkRenderWindow()
window.OffScreenRenderingOn()
window.SetSize(PAGE_SIZE)
window.AddRenderer(renderer)
renderer.ResetCamera()
renderer.GetActiveCamera().Elevation(-70)
renderer.GetActiveCamera().Zoom(1.5)
renderer.ResetCameraClippingRange()
if "enable" in sys.argv:
    import vtktranslucency

    vtktranslucency.enable(renderer)
window.Render()

image = vtk.vtkWindowToImageFilter()
image.SetInput(window)
writer = vtk.vtkPNGWriter()
writer.SetInputConnection(image.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
