"""Translucent balls that overlap, the nearest first, which is the wrong order to blend them in. Each program here draws them."""

RADIUS = 0.5
OPACITY = 0.4
BALLS = [  # centres and colours
    ((0, 0, 0.8), (0.9, 0.2, 0.2)),
    ((0.45, 0.15, 0.4), (0.2, 0.7, 0.2)),
    ((-0.4, 0.25, 0.2), (0.2, 0.3, 0.9)),
    ((0.1, -0.4, -0.2), (0.9, 0.7, 0.1)),
    ((0, 0.2, -0.8), (0.6, 0.2, 0.8)),
]
CAMERA = (0, 0, 4.4), (0, 0, 0), (0, 1, 0)  # position, focal point, view up
SIZE = (400, 300)
PAGE_SIZE = (480, 360)  # of the programs that have a page of their own, and draw something else
