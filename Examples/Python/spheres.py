"""Three translucent spheres that overlap, drawn into spheres.png or the file named on the command line."""

import sys

import vtk
import vtktranslucency

sphere = vtk.vtkSphereSource()
sphere.SetThetaResolution(64)
sphere.SetPhiResolution(64)
renderer = vtk.vtkRenderer()
renderer.SetBackground(1, 1, 1)
for x, y, color in ((-0.25, 0, (0.9, 0.3, 0.1)), (0.25, 0, (0.1, 0.6, 0.2)), (0, 0.4, (0.1, 0.3, 0.9))):
    actor = vtk.vtkActor()
    actor.SetMapper(vtk.vtkPolyDataMapper())
    actor.GetMapper().SetInputConnection(sphere.GetOutputPort())
    actor.SetPosition(x, y, 0)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(0.7)
    renderer.AddActor(actor)

vtktranslucency.enable(renderer, "adaptive", nodes=16)

window = vtk.vtkRenderWindow()
window.OffScreenRenderingOn()
window.SetSize(400, 300)
window.AddRenderer(renderer)
window.Render()

image = vtk.vtkWindowToImageFilter()
image.SetInput(window)
writer = vtk.vtkPNGWriter()
writer.SetInputConnection(image.GetOutputPort())
writer.SetFileName((sys.argv[1:] or ["spheres.png"])[0])
writer.Write()
