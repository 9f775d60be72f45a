"""paraview_script.py FILE [peeling]    By pvpython, or by pvbatch, whose ranks each have a part of every ball."""

import os
import sys

from paraview.simple import CreateRenderView, Render, SaveScreenshot, Show, Sphere, _DisableFirstRenderCameraReset

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from balls import BALLS, CAMERA, OPACITY, RADIUS, SIZE  # noqa: E402

_DisableFirstRenderCameraReset()
view = CreateRenderView()
view.ViewSize = SIZE
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
view.DepthPeeling = "peeling" in sys.argv
view.MaximumNumberOfPeels = 100
for center, color in BALLS:
    ball = Sphere(Center=center, Radius=RADIUS, ThetaResolution=64, PhiResolution=64)
    display = Show(ball, view)
    display.Opacity = OPACITY
    display.AmbientColor = display.DiffuseColor = color
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = CAMERA
Render(view)
SaveScreenshot(sys.argv[1], view, ImageResolution=SIZE)
