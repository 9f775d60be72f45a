"""Techniques in the chain of passes of pyvista-render-passes, which saves and restores them with its other settings.

    import pyvista_render_passes
    from vtktranslucency.render_passes import TranslucencyProvider

    pyvista_render_passes.register_pass_provider(plotter, TranslucencyProvider("adaptive", nodes=32))

The chain has one place for what draws translucent props. So this is registered by hand, for the plotter's active subplot, and is no
entry point, which would take the place from others wherever both packages are installed.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pyvista_render_passes import BasePassProvider

from . import _create, _describe, vtkTranslucencyPass


class TranslucencyProvider(BasePassProvider):
    """Draws translucent props, and volumes among them, with a technique and its options: those of vtktranslucency.enable."""

    name = "vtktranslucency"
    stages = ("translucent",)

    def __init__(self, technique: str = "adaptive", **options: object) -> None:
        self._state = self._checked({"technique": technique, "options": options})
        self._pass: Any = None

    def build_pass(self, stage: Any, renderer: Any, chain: Any, delegate: Any) -> Any:
        """A new pass. As soon as the renderer has the chain, the pass takes over the chain's next step, the volumes."""
        technique_pass = _create(self._state["technique"], self._state["options"])
        self._pass = technique_pass

        def take_volumes(*_: object) -> None:
            if renderer.GetPass() is not None:
                renderer.RemoveObserver(observer)
                _take_volumes(renderer.GetPass(), technique_pass)

        if isinstance(technique_pass, vtkTranslucencyPass):
            observer = renderer.AddObserver("ModifiedEvent", take_volumes)
        return technique_pass

    def statistics(self) -> dict[str, int | float | str]:
        """What the last frame drew and cost, as vtktranslucency.statistics has it of a renderer."""
        if self._pass is None:
            raise ValueError("the provider has drawn no frame: expected one that is registered, of a plotter that has rendered")
        return _describe(self._pass)

    def default_state(self) -> dict[str, Any]:
        return {"technique": "adaptive", "options": {}}

    def get_state(self) -> dict[str, Any]:
        return {"technique": self._state["technique"], "options": dict(self._state["options"])}

    def set_state(self, state: Mapping[str, Any]) -> None:
        """Raises ValueError, and keeps the present one, if the technique or one of its options is none of enable()'s."""
        self._state = self._checked({**self._state, **state})

    @staticmethod
    def _checked(state: dict[str, Any]) -> dict[str, Any]:
        _create(state["technique"], state["options"])
        return state


def _take_volumes(step: Any, technique_pass: vtkTranslucencyPass) -> None:
    """Of the passes below step, the one that draws volumes right after the technique becomes the technique's own."""
    if step.IsA("vtkSequencePass"):
        passes = step.GetPasses()
        steps = [passes.GetItemAsObject(i) for i in range(passes.GetNumberOfItems())]
        for each, following in zip(steps, [*steps[1:], None]):
            if each is technique_pass and following is not None and following.IsA("vtkVolumetricPass"):
                passes.RemoveItem(following)
                technique_pass.SetVolumetricPass(following)
            else:
                _take_volumes(each, technique_pass)
    elif hasattr(step, "GetDelegatePass") and step.GetDelegatePass() is not None:
        _take_volumes(step.GetDelegatePass(), technique_pass)
