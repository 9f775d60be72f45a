"""paraview_script.py FILE [peeling]

By pvpython; by pvbatch, whose ranks each have a part of every ball; or by ParaView's window, which gives its scripts no arguments: there PICTURE in
the environment names the file, and the window is closed in the end.
"""

import os
import sys

from balls import BALLS, CAMERA, OPACITY, RADIUS, SIZE
from paraview.simple import GetActiveViewOrCreate, Render, SaveScreenshot, Show, Sphere, _DisableFirstRenderCameraReset

_DisableFirstRenderCameraReset()
view = GetActiveViewOrCreate("RenderView")
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
SaveScreenshot(os.environ.get("PICTURE") or sys.argv[1], view, ImageResolution=SIZE)
if "PICTURE" in os.environ:
    os._exit(0)
