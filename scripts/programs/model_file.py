"""model_file.py FILE: the balls as one mesh, for viewers. Draws nothing."""

import sys

from balls import BALLS, RADIUS
from vtkmodules import all as vtk

balls = vtk.vtkAppendPolyData()
for center, color in BALLS:
    source = vtk.vtkSphereSource()
    source.SetCenter(center)
    source.SetRadius(RADIUS)
    source.SetThetaResolution(64)
    source.SetPhiResolution(64)
    source.Update()
    ball = source.GetOutput()
    colors = vtk.vtkUnsignedCharArray()
    colors.SetName("Colors")
    colors.SetNumberOfComponents(3)
    for _ in range(ball.GetNumberOfPoints()):
        colors.InsertNextTuple3(*(round(255 * part) for part in color))
    ball.GetPointData().AddArray(colors)
    balls.AddInputData(ball)
writer = vtk.vtkXMLPolyDataWriter()
writer.SetFileName(sys.argv[1])
writer.SetInputConnection(balls.GetOutputPort())
writer.Write()
