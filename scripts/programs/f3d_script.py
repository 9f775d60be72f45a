"""f3d_script.py FILE MODEL [peeling]    By F3D's package of Python, 4.0 or later."""

import sys

import f3d
from balls import OPACITY, SIZE

engine = f3d.Engine.create(True)
engine.window.size = SIZE
engine.options.update({
    "model.color.opacity": OPACITY,
    "model.coloring": "scivis",
    "model.scivis.array_name": "Colors",
    "render.effect.blending.mode": "ddp" if "peeling" in sys.argv else "none",
})
engine.scene.add(sys.argv[2])
engine.window.render_to_image().save(sys.argv[1])
