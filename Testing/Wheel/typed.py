"""For mypy --strict: what the package's types allow, and, in the lines with comments, what they refuse."""

import vtktranslucency

technique_pass = vtktranslucency.vtkAdaptiveTransparencyPass()
nodes: int = technique_pass.GetNodeCount()
text: str = technique_pass.GetNodeCount()  # type: ignore[assignment]

version: str = vtktranslucency.__version__
numbers: dict[str, int | float | str] = vtktranslucency.statistics(object())
help_of_options: dict[str, str] = vtktranslucency.options("adaptive")
vtktranslucency.enable(object(), "adaptive", nodes=nodes, removal="mixed")
vtktranslucency.enable(object(), nodes)  # type: ignore[arg-type]
vtktranslucency.disable()  # type: ignore[call-arg]
