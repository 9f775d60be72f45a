"""A program that knows nothing of this project: plots translucent surfaces by PyVista into a PNG file.

    plots.py FILE HOW [peeling]    HOW: one, subplots, or shaded (eye dome lighting); peeling: asks for it
"""

import sys

import pyvista

BALLS = {(0, 0, 0): (1, 0.2, 0.2), (0.2, 0.1, -0.4): (0.2, 1, 0.2), (-0.1, 0.2, 0.5): (0.2, 0.3, 1)}


def main():
    file, how = sys.argv[1:3]
    shape = (1, 2) if how == "subplots" else (1, 1)
    plotter = pyvista.Plotter(off_screen=True, shape=shape, window_size=(160, 120), border=False)
    for column in range(shape[1]):
        plotter.subplot(0, column)
        for center, color in BALLS.items():
            plotter.add_mesh(pyvista.Sphere(radius=0.5, center=center), color=color, opacity=0.5)
        if how == "shaded":
            plotter.enable_eye_dome_lighting()
        if "peeling" in sys.argv:
            plotter.enable_depth_peeling()
    plotter.screenshot(file)
    return 7


if __name__ == "__main__":
    sys.exit(main())
