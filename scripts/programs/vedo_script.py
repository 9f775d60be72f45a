"""vedo_script.py FILE [peeling]"""

import sys

import vedo
from balls import BALLS, CAMERA, OPACITY, RADIUS, SIZE

vedo.settings.use_depth_peeling = "peeling" in sys.argv
plotter = vedo.Plotter(offscreen=True, size=SIZE)
for center, color in BALLS:
    plotter += vedo.Sphere(pos=center, r=RADIUS, c=color, alpha=OPACITY)
position, focal_point, up = CAMERA
plotter.show(camera={"pos": position, "focal_point": focal_point, "viewup": up}, resetcam=False)
plotter.screenshot(sys.argv[1])
