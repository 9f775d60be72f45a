"""Techniques in the chain of passes of pyvista-render-passes, which saves and restores them with its other settings.

    import pyvista_render_passes
    from vtktranslucency.render_passes import TranslucencyProvider

    pyvista_render_passes.register_pass_provider(plotter, TranslucencyProvider("adaptive", nodes=32))

The chain has one place for what draws translucent props. So this is registered by hand, for the plotter's active subplot, and is no
entry point, which would take the place from others wherever both packages are installed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from pyvista_render_passes import BasePassProvider

from . import _create, vtkTranslucencyFactory


class TranslucencyProvider(BasePassProvider):
    """Draws translucent props, and volumes among them, with a technique and its options: those of vtktranslucency.enable."""

    name = "vtktranslucency"
    stages = ("translucent",)

    def __init__(self, technique: str = "adaptive", **options: object) -> None:
        self._renderer: Any = None
        self._state = self._checked({"technique": technique, "options": options})

    def build_pass(self, stage: Any, renderer: Any, chain: Any, delegate: Any) -> Any:
        """A new pass. The technique is enabled, too, so that it also takes the volumes, which are the chain's next step."""
        technique_pass = _create(self._state["technique"], self._state["options"])
        vtkTranslucencyFactory.Enable(renderer, technique_pass)
        self._renderer = renderer
        return technique_pass

    def bind(self, invalidate: Callable[[], object] | None) -> None:
        super().bind(invalidate)
        if invalidate is None and self._renderer is not None:
            vtkTranslucencyFactory.Disable(self._renderer)
            self._renderer = None

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
