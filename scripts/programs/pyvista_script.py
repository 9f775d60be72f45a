"""pyvista_script.py FILE [peeling]"""

import sys

import pyvista
from balls import BALLS, CAMERA, OPACITY, RADIUS, SIZE

plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
for center, color in BALLS:
    plotter.add_mesh(pyvista.Sphere(radius=RADIUS, center=center), color=color, opacity=OPACITY)
plotter.camera_position = CAMERA
if "peeling" in sys.argv:
    plotter.enable_depth_peeling(100)
plotter.screenshot(sys.argv[1])
