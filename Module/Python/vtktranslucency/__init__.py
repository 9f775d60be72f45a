"""Translucent geometry drawn right, whatever the order in which VTK draws it.

    import vtktranslucency

    vtktranslucency.enable(renderer)                        # adaptive transparency
    vtktranslucency.enable(renderer, "adaptive", nodes=32)  # with more nodes a pixel
    vtktranslucency.enable(renderer, "exact")               # every fragment, sorted
    vtktranslucency.disable(renderer)                       # as it was

techniques() tells what there is, options(technique) what each can be told. The classes behind the techniques are here, too,
as VTK's are in vtkmodules: vtktranslucency.vtkAdaptiveTransparencyPass and so on.
"""

import re as _re

from vtkmodules.vtkCommonCore import vtkObject as _vtkObject
from vtkmodules.vtkRenderingCore import vtkRenderer as _vtkRenderer

from .vtkRenderingTranslucency import *  # noqa: F401, F403
from .vtkRenderingTranslucency import vtkTranslucencyFactory, vtkTranslucencyPass


def enable(renderer, technique="adaptive", **options):
    """Draw a renderer's translucent props with a technique.

    renderer is a vtkRenderer, or something that has one as its attribute `renderer`, such as a PyVista plotter; technique is
    one of techniques(); options are those of options(technique), by keyword.

    Returns the technique's pass; this module's own have GetStatistics(), which tells what the last frame cost. If anything is
    wrong, raises ValueError, which names it and what was expected, and leaves the renderer as it was.

    The renderer's effects (FXAA, SSAO, shadows, hidden lines) and the passes that it has, or is given later, stay; so do PyVista's
    enable_anti_aliasing, enable_eye_dome_lighting, enable_ssao, enable_shadows and the like, in any order. A second call changes the technique only.
    """
    renderer = _find_renderer(renderer)
    _check_technique(technique)
    technique_pass = vtkTranslucencyFactory.CreateTechnique(technique)
    _set_options(technique_pass, technique, options)
    vtkTranslucencyFactory.Enable(renderer, technique_pass)
    return technique_pass


def disable(renderer):
    """Give back what enable() took: the renderer and its passes are as they would be without. Does nothing where there is no technique."""
    vtkTranslucencyFactory.Disable(_find_renderer(renderer))


def techniques():
    """The techniques that enable() takes: a dictionary of one-line descriptions by name."""
    return {
        vtkTranslucencyFactory.GetTechniqueName(i): vtkTranslucencyFactory.GetTechniqueHelp(i)
        for i in range(vtkTranslucencyFactory.GetNumberOfTechniques())
    }


def options(technique):
    """The options that enable() takes for a technique: a dictionary of descriptions by keyword, with range and default."""
    _check_technique(technique)
    technique_pass = vtkTranslucencyFactory.CreateTechnique(technique)
    if not isinstance(technique_pass, vtkTranslucencyPass):
        return {}
    return {
        technique_pass.GetOptionKeyword(i): technique_pass.GetOptionHelp(i)
        for i in range(technique_pass.GetNumberOfOptions())
    }


def _find_renderer(candidate):
    for renderer in (candidate, getattr(candidate, "renderer", None)):
        if isinstance(renderer, _vtkRenderer):
            return renderer
    raise ValueError(
        f"renderer is of type {type(candidate).__name__}, "
        "expected a vtkRenderer or something that has one as its attribute 'renderer'"
    )


def _check_technique(name):
    if name not in techniques():
        raise ValueError(f"there is no technique {name!r}, expected one of: {', '.join(techniques())}")


def _set_options(technique_pass, technique, options):
    """Sets them one by one; VTK's own words for a bad one become the exception's text instead of being printed."""
    if not options:
        return
    if not isinstance(technique_pass, vtkTranslucencyPass):
        raise ValueError(f"there is no option {next(iter(options))!r}, the technique {technique!r} takes none")

    messages = []

    def collect(_sender, _event, text):
        messages.append(_re.sub(r"^ERROR: In .*, line \d+\nvtk\w+ \(\w+\): ", "", text).strip())

    collect.CallDataType = "string0"
    observer = technique_pass.AddObserver("ErrorEvent", collect)
    displayed = _vtkObject.GetGlobalWarningDisplay()
    _vtkObject.GlobalWarningDisplayOn()  # else there is no event
    try:
        for keyword, value in options.items():
            if not technique_pass.SetOption(keyword, str(value)):
                raise ValueError(" ".join(messages))
    finally:
        _vtkObject.SetGlobalWarningDisplay(displayed)
        technique_pass.RemoveObserver(observer)
