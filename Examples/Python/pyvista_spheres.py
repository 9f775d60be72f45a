"""Three translucent spheres that overlap, in PyVista, drawn into spheres.png or the file named on the command line."""

import sys

import pyvista
import vtktranslucency

plotter = pyvista.Plotter(off_screen=True)
for center, color in (((-0.25, 0, 0), "orangered"), ((0.25, 0, 0), "seagreen"), ((0, 0, 0.4), "royalblue")):
    plotter.add_mesh(pyvista.Sphere(center=center), color=color, opacity=0.4)
vtktranslucency.enable(plotter)
plotter.screenshot((sys.argv[1:] or ["spheres.png"])[0])
