"""paraview_nested.py FILE [PLUGIN]

Nested balls before an opaque wall, by pvpython or pvbatch. Or in ParaView's window, which gives its scripts no arguments: there DRAWN in the environment
names a file that is made when all is drawn. The plugin has to be there from the start, and the window stays open.
"""

import os
import pathlib
import sys

from balls import PAGE_SIZE
from paraview.simple import GetActiveViewOrCreate, LoadPlugin, Plane, Render, SaveScreenshot, Show, Sphere, _DisableFirstRenderCameraReset

COLORS = ([1, 0, 0], [1, 0.8, 0], [0, 0.7, 0], [0, 0.7, 1], [0, 0, 1], [0.8, 0, 0.8], [0.4, 0.4, 0.4])


def show(source, view, color):
    display = Show(source, view)
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = color
    return display


def draw(technique):
    _DisableFirstRenderCameraReset()
    view = GetActiveViewOrCreate("RenderView")
    if technique:
        view.TranslucencyTechnique = technique
    view.OrientationAxesVisibility = 0
    show(Plane(Origin=[-9, -9, -2], Point1=[9, -9, -2], Point2=[-9, 9, -2]), view, [0.95, 0.95, 0.9])
    for i, color in enumerate(COLORS):
        ball = Sphere(Radius=0.25 + 0.1 * i, Center=[0.12 * i, 0.06 * i, 0], ThetaResolution=64, PhiResolution=64)
        show(ball, view, color).Opacity = 0.3
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [2.3, 1.2, 4.2], [0.5, 0.25, 0], [0, 1, 0]
    Render(view)
    return view


if "DRAWN" in os.environ:
    draw("adaptive")
    pathlib.Path(os.environ["DRAWN"]).touch()
else:
    for plugin in sys.argv[2:]:
        LoadPlugin(plugin, remote=False, ns=globals())
    drawn = draw("exact" if sys.argv[2:] else None)
    drawn.ViewSize = PAGE_SIZE
    SaveScreenshot(sys.argv[1], drawn, ImageResolution=PAGE_SIZE)
