"""pyvista_rings.py FILE [peeling | enable]: meshes that go through each other, by PyVista with its defaults, such as 8 samples."""

import sys

import pyvista
from balls import PAGE_SIZE

plotter = pyvista.Plotter(off_screen=True, window_size=PAGE_SIZE)
for angle, color in ((0, "orangered"), (60, "seagreen"), (120, "royalblue")):
    ring = pyvista.ParametricTorus(ringradius=1, crosssectionradius=0.35).rotate_x(angle).rotate_z(angle)
    plotter.add_mesh(ring, color=color, opacity=0.45, smooth_shading=True)
plotter.camera.zoom(1.5)
if "peeling" in sys.argv:
    plotter.enable_depth_peeling()
if "enable" in sys.argv:
    import vtktranslucency

    vtktranslucency.enable(plotter)
plotter.screenshot(sys.argv[1])
