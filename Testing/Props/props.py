"""Every class of VTK's props that draws in a scene, made translucent: a function for those that don't draw as they are made.

A class that is not made to draw stands in NOT_DRAWN, with the reason; the tests fail when VTK has a class that is in neither list, or one that is in
both.
"""

import inspect
import re

from vtkmodules import all as vtk

OPACITY = 0.4

RECIPES = {}
NOT_DRAWN = {}


def recipe(*names):
    def register(build):
        RECIPES.update((name, build) for name in names)
        return build

    return register


def not_drawn(why, *names):
    NOT_DRAWN.update((name, why) for name in names)


def prop_classes():
    """All that can be made, one of each that VTK's factory gives."""
    classes = {}
    for name in dir(vtk):
        candidate = getattr(vtk, name)
        if not (inspect.isclass(candidate) and issubclass(candidate, vtk.vtkProp)):
            continue
        try:
            candidate()
        except (TypeError, NotImplementedError):  # abstract
            continue
        if not (name.startswith("vtkOpenGL") and hasattr(vtk, name.replace("OpenGL", ""))):
            classes[name] = candidate
    return classes


def make(name, renderer):
    """The prop, in the renderer."""
    made = getattr(vtk, name)()
    prop = RECIPES.get(name, lambda prop, _renderer: prop)(made, renderer) or made
    if isinstance(prop, vtk.vtkWidgetRepresentation):
        prop.SetRenderer(renderer)
        if name not in RECIPES:
            place(prop)
        prop.BuildRepresentation()
        prop.SetVisibility(True)
    renderer.AddViewProp(prop)
    soften(prop, set())
    return prop


def place(representation):
    representation.SetPlaceFactor(1)
    representation.PlaceWidget((-0.6, 0.6, -0.5, 0.5, -0.4, 0.4))


PARTS = re.compile(r"Get(\w*Property|\w*Actor|\w*Representation|\w*Handle|\w*Prop|\w*Prop3D)$")


def soften(thing, seen):
    """Makes all properties translucent that a prop or its parts have a getter for."""
    if thing in seen:
        return
    seen.add(thing)
    if isinstance(thing, vtk.vtkProperty):
        thing.SetOpacity(OPACITY)
        return
    if not isinstance(thing, vtk.vtkProp):
        return
    for name in dir(thing):
        if PARTS.match(name):
            try:
                part = getattr(thing, name)()
            except TypeError:  # it wants arguments
                continue
            if isinstance(part, (vtk.vtkProperty, vtk.vtkProp)):
                soften(part, seen)
