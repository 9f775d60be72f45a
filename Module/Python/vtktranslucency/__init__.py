"""Translucent geometry drawn right, whatever the order in which VTK draws it.

In these examples, and in those of the functions, renderer is a vtkRenderer in a window:

>>> import vtktranslucency
>>> technique_pass = vtktranslucency.enable(renderer)                        # adaptive transparency
>>> technique_pass = vtktranslucency.enable(renderer, "adaptive", nodes=32)  # with more nodes per pixel
>>> technique_pass = vtktranslucency.enable(renderer, "exact")               # every fragment, sorted
>>> vtktranslucency.disable(renderer)                                        # as it was

techniques() tells what there is, options(technique) what each can be told, statistics(renderer) what the last frame cost. The
classes behind the techniques are here, too, as VTK's are in its own package: vtktranslucency.vtkAdaptiveTransparencyPass and so on.

What is wrong is a ValueError, which names it and what was expected, and changes nothing.
"""

from __future__ import annotations

import contextlib
import difflib
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from ._vtk import RELEASE, vtkObject, vtkRenderer, vtkRenderPass  # first: it refuses a VTK that the next line can't be loaded beside
from .vtkRenderingTranslucency import *  # noqa: F401, F403
from .vtkRenderingTranslucency import (
    vtkAutomaticTransparencyPass,
    vtkTranslucencyDisplay,
    vtkTranslucencyFactory,
    vtkTranslucencyPass,
    vtkTranslucencyStatistics,
)

__version__ = RELEASE


def enable(renderer: Any, technique: str = "adaptive", **options: object) -> vtkRenderPass:
    """Draw a renderer's translucent props with a technique, and return the technique's pass.

    renderer is a vtkRenderer, or something that has one as its attribute `renderer`; technique is one of techniques(); options are
    those of options(technique), by keyword.

    A PyVista plotter's renderer is the one of its active subplot, as it is for the plotter's own enable_depth_peeling. For all:

        for renderer in plotter.renderers:
            vtktranslucency.enable(renderer)

    A renderer of a ParaView view that draws by itself can be given, too. Where ranks draw together, the view's property
    TranslucencyTechnique of the plugin for ParaView is what reaches all of them, and enable() says so.

    The renderer's effects (FXAA, SSAO, shadows, hidden lines) and the passes that it has, or is given later, stay; so do PyVista's
    enable_anti_aliasing, enable_eye_dome_lighting, enable_ssao, enable_shadows and the like, in any order. A second call changes
    the technique only.

    >>> vtktranslucency.enable(renderer, "exact", memory_limit=64).GetOption("memory_limit")
    '64'
    >>> vtktranslucency.enable(renderer, "exakt")
    Traceback (most recent call last):
    ValueError: there is no technique 'exakt', did you mean 'exact'? Expected one of: ...
    """
    renderer = _find_renderer(renderer)
    technique_pass = _create(technique, options)
    window = renderer.GetRenderWindow()
    missing = vtkTranslucencyDisplay.GetMissing(window) if window else ""
    if missing:
        raise ValueError(f"VTK can't draw in the renderer's window: {missing}")
    with _errors_of(renderer) as messages:
        enabled = vtkTranslucencyFactory.Enable(renderer, technique_pass)
    if not enabled:
        raise ValueError(" ".join(messages))
    return technique_pass


def disable(renderer: Any) -> None:
    """Give back what enable() took: the renderer and its passes are as they would be without.

    >>> technique_pass = vtktranslucency.enable(renderer)
    >>> vtktranslucency.disable(renderer)
    >>> vtktranslucency.disable(renderer)
    Traceback (most recent call last):
    ValueError: the renderer has no technique: expected one that enable() was called with, and disable() not since
    """
    renderer = _find_renderer(renderer)
    _find_technique(renderer)
    vtkTranslucencyFactory.Disable(renderer)


def techniques() -> dict[str, str]:
    """The techniques that enable() takes: one-line descriptions by name.

    >>> vtktranslucency.techniques()["exact"]
    'A-buffer: every fragment, sorted and blended'
    """
    return {
        vtkTranslucencyFactory.GetTechniqueName(i): vtkTranslucencyFactory.GetTechniqueHelp(i)
        for i in range(vtkTranslucencyFactory.GetNumberOfTechniques())
    }


def options(technique: str) -> dict[str, str]:
    """The options that enable() takes for a technique: descriptions by keyword, with range and default.

    >>> vtktranslucency.options("adaptive")["nodes"]
    'nodes of the visibility function; ... (1..64, default 16)'
    """
    technique_pass = _create(technique, {})
    if not isinstance(technique_pass, vtkTranslucencyPass):
        return {}
    return {
        technique_pass.GetOptionKeyword(i): technique_pass.GetOptionHelp(i)
        for i in range(technique_pass.GetNumberOfOptions())
    }


def statistics(renderer: Any) -> dict[str, int | float | str]:
    """What the last frame of a renderer drew and cost, under the names of vtkTranslucencyStatistics.

    Counts are of that frame, bytes of graphics memory. Times are in milliseconds, and negative unless MeasureTimesOn() of the pass,
    which enable() returns, was called before the frame. fallback is empty where the technique itself has drawn. Of the technique
    'auto', chosen and reason tell what has drawn, and why. Asking waits for the frame to end.

    >>> technique_pass = vtktranslucency.enable(renderer, "exact")
    >>> renderer.GetRenderWindow().Render()
    >>> numbers = vtktranslucency.statistics(renderer)
    >>> numbers["fragments"], numbers["deepest_pixel"], numbers["fallback"]
    (2500, 1, '')
    """
    renderer = _find_renderer(renderer)
    technique_pass = _find_technique(renderer)
    window = renderer.GetRenderWindow()
    if window is None or window.GetNeverRendered():
        lack = "is in no window" if window is None else "has drawn no frame"
        raise ValueError(f"the renderer {lack}: expected one whose window's Render() has been called")
    window.MakeCurrent()
    return _describe(technique_pass)


def _describe(technique_pass: vtkRenderPass) -> dict[str, int | float | str]:
    if not isinstance(technique_pass, vtkTranslucencyPass):
        raise ValueError(f"the renderer draws with VTK's own {technique_pass.GetClassName()}, which keeps no statistics")
    kept = technique_pass.GetStatistics()
    getters = sorted(name for name in set(dir(vtkTranslucencyStatistics)) - set(dir(vtkObject)) if name.startswith("Get"))
    numbers = {re.sub("(?<=[a-z])(?=[A-Z])", "_", name[3:]).lower(): getattr(kept, name)() for name in getters}
    if isinstance(technique_pass, vtkAutomaticTransparencyPass):
        numbers.update(chosen=technique_pass.GetChosen(), reason=technique_pass.GetReason())
    return numbers


def _find_renderer(candidate: Any) -> vtkRenderer:
    for renderer in (candidate, getattr(candidate, "renderer", None)):
        if isinstance(renderer, vtkRenderer):
            return renderer
        for base in type(renderer).__mro__:
            if base.__name__ == "vtkRenderer":
                raise ValueError(
                    f"the renderer is one of {base.__module__}, expected one of {vtkRenderer.__module__}, with which "
                    "vtktranslucency was built; of PyVista, PYVISTA_VTK_BACKEND in the environment chooses"
                )
    kind = type(candidate)
    raise ValueError(
        f"renderer is of type {kind.__module__}.{kind.__qualname__}, expected a {vtkRenderer.__module__}.vtkRenderer or something "
        "that has one as its attribute 'renderer'"
    )


def _find_technique(renderer: vtkRenderer) -> vtkRenderPass:
    technique_pass = vtkTranslucencyFactory.GetTechnique(renderer)
    if technique_pass is None:
        raise ValueError(
            "the renderer has no technique: expected one that enable() was called with, and disable() not since"
        )
    return technique_pass


def _create(technique: str, values: Mapping[str, object]) -> vtkRenderPass:
    """A new pass of the technique, with these values of its options."""
    _check_name(f"technique {technique!r}", technique, techniques())
    technique_pass = vtkTranslucencyFactory.CreateTechnique(technique)
    if values:
        _set_options(technique_pass, technique, values)
    return technique_pass


def _check_name(what: str, name: object, known: Iterable[str]) -> None:
    known = list(known)
    if name not in known:
        similar = difflib.get_close_matches(str(name).lower(), known, 1)
        suggestion = f", did you mean {similar[0]!r}?" if similar else "."
        raise ValueError(f"there is no {what}{suggestion} Expected one of: {', '.join(known)}")


def _set_options(technique_pass: vtkRenderPass, technique: str, values: Mapping[str, object]) -> None:
    """Sets them one by one; VTK's own words for a bad value become the exception's text instead of being printed."""
    known = options(technique)
    if not known:
        raise ValueError(f"there is no option {next(iter(values))!r} of the technique {technique!r}: it takes none")

    with _errors_of(technique_pass) as messages:
        for keyword, value in values.items():
            _check_name(f"option {keyword!r} of the technique {technique!r}", keyword, known)
            if not technique_pass.SetOption(keyword, str(value)):
                raise ValueError(" ".join(messages))


@contextlib.contextmanager
def _errors_of(vtk_object: vtkObject) -> Iterator[list[str]]:
    """A list of the errors that an object tells, in VTK's own words, instead of printing them."""
    messages: list[str] = []

    def collect(_sender: vtkObject, _event: str, text: str) -> None:
        messages.append(re.sub(r"^ERROR: In .*, line \d+\nvtk\w+ \(\w+\): ", "", text).strip())

    collect.CallDataType = "string0"  # type: ignore[attr-defined]
    observer = vtk_object.AddObserver("ErrorEvent", collect)
    displayed = vtkObject.GetGlobalWarningDisplay()
    vtkObject.GlobalWarningDisplayOn()  # else there is no event
    try:
        yield messages
    finally:
        vtkObject.SetGlobalWarningDisplay(displayed)
        vtk_object.RemoveObserver(observer)
