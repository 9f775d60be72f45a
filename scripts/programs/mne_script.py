"""mne_script.py FILE [peeling]    By MNE's 3D viewer: PyVista in a window of Qt. By itself it asks for peeling, but can be told not to."""

import sys

import mne
from balls import BALLS, CAMERA, OPACITY, RADIUS, SIZE

mne.viz.set_3d_backend("pyvistaqt")
mne.viz.set_3d_options(depth_peeling="peeling" in sys.argv)
scene = mne.viz.backends.renderer._get_renderer(size=SIZE, bgcolor="white")
for center, color in BALLS:
    scene.sphere(center, color, scale=1, radius=RADIUS, resolution=64, opacity=OPACITY)
scene.plotter.camera_position = CAMERA
scene.show()
for _ in range(20):  # until the window is there
    scene.plotter.app.processEvents()
    scene.plotter.render()
scene.plotter.screenshot(sys.argv[1])
