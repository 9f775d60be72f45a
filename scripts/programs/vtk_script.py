"""vtk_script.py FILE [peeling]"""

import sys

from balls import BALLS, CAMERA, OPACITY, RADIUS, SIZE
from vtkmodules import all as vtk

window = vtk.vtkRenderWindow()
window.OffScreenRenderingOn()
window.SetMultiSamples(0)
window.SetSize(SIZE)
renderer = vtk.vtkRenderer()
renderer.SetBackground(1, 1, 1)
window.AddRenderer(renderer)
for center, color in BALLS:
    source = vtk.vtkSphereSource()
    source.SetCenter(center)
    source.SetRadius(RADIUS)
    source.SetThetaResolution(64)
    source.SetPhiResolution(64)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(OPACITY)
    renderer.AddActor(actor)
camera = renderer.GetActiveCamera()
camera.SetPosition(CAMERA[0])
camera.SetFocalPoint(CAMERA[1])
camera.SetViewUp(CAMERA[2])
renderer.ResetCameraClippingRange()
if "peeling" in sys.argv:
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(100)
    renderer.SetOcclusionRatio(0)
window.Render()
reader = vtk.vtkWindowToImageFilter()
reader.SetInput(window)
writer = vtk.vtkPNGWriter()
writer.SetFileName(sys.argv[1])
writer.SetInputConnection(reader.GetOutputPort())
writer.Write()
