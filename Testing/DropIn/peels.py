"""A program that knows nothing of this project: draws a scene of translucent surfaces into a PNG file.

    peels.py FILE HOW [SAMPLES [EFFECT]]

HOW is one of
    renderer, layers, volumes    the renderer, several of them, and one with a volume, peel
    dual, single                 a pass of its own peels
    blending, layers-blending, volumes-blending, projected
                                 nothing peels; projected is a volume that is not cast by rays
    switched-off                 nor here, which is seen to before each frame
    subclass                     nor does a renderer of a class of this program
    steps, default, weighted     nor do passes of its own; weighted has VTK's weighted average
    selecting                    as blending; afterwards it says which props are seen where
EFFECT is a flag of vtkRenderer, such as UseSSAO, or the class of a pass around a pass of its own.
"""

import sys

from vtkmodules import all as vtk


def ball(renderer, center, rgb, opacity=0.5):
    source = vtk.vtkSphereSource()
    source.SetCenter(*center)
    source.SetPhiResolution(40)
    source.SetThetaResolution(40)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*rgb)
    actor.GetProperty().SetOpacity(opacity)
    renderer.AddActor(actor)
    return actor


def cloud(renderer, mapper):
    source = vtk.vtkRTAnalyticSource()
    source.SetWholeExtent(-8, 8, -8, 8, -8, 8)
    mapper.SetInputConnection(source.GetOutputPort())
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    volume.SetScale(0.06)
    opacity = vtk.vtkPiecewiseFunction()
    opacity.AddPoint(100, 0)
    opacity.AddPoint(280, 0.3)
    volume.GetProperty().SetScalarOpacity(opacity)
    renderer.AddVolume(volume)


class Renderer(vtk.vtkOpenGLRenderer):
    """As PyVista has one."""


def new_renderer(window, how):
    renderer = Renderer() if how == "subclass" else vtk.vtkRenderer()
    renderer.SetBackground(0.2, 0.3, 0.4)
    window.AddRenderer(renderer)
    ball(renderer, (0, 0, 0), (1, 0.2, 0.2))
    ball(renderer, (0.2, 0.1, -0.4), (0.2, 1, 0.2))
    ball(renderer, (-0.1, 0.2, 0.5), (0.2, 0.3, 1))
    if how == "volumes" or how == "volumes-blending":
        cloud(renderer, vtk.vtkGPUVolumeRayCastMapper())
    if how == "projected":
        cloud(renderer, vtk.vtkFixedPointVolumeRayCastMapper())
    return renderer


def peel(renderer, how):
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(100)
    renderer.SetOcclusionRatio(0)
    renderer.SetUseDepthPeelingForVolumes(how == "volumes")


def new_pass(how):
    """None for a renderer without one."""
    if how == "default":
        collection = vtk.vtkRenderPassCollection()
        collection.AddItem(vtk.vtkLightsPass())
        collection.AddItem(vtk.vtkDefaultPass())
        sequence = vtk.vtkSequencePass()
        sequence.SetPasses(collection)
        camera = vtk.vtkCameraPass()
        camera.SetDelegatePass(sequence)
        return camera
    if how not in ("dual", "single", "weighted", "steps"):
        return None
    steps = vtk.vtkRenderStepsPass()
    if how in ("dual", "single"):
        peeling = vtk.vtkDualDepthPeelingPass() if how == "dual" else vtk.vtkDepthPeelingPass()
        peeling.SetTranslucentPass(vtk.vtkTranslucentPass())
        peeling.SetMaximumNumberOfPeels(100)
        peeling.SetOcclusionRatio(0)
        steps.SetTranslucentPass(peeling)
    if how == "weighted":
        average = vtk.vtkOrderIndependentTranslucentPass()
        average.SetTranslucentPass(vtk.vtkTranslucentPass())
        steps.SetTranslucentPass(average)
    return steps


def add_layers(window, renderer, how):
    """Three more renderers: beside the first one, before it, and before it with the depths that are there."""
    renderer.SetViewport(0, 0, 0.5, 1)
    window.SetNumberOfLayers(3)
    for viewport, layer in (((0.5, 0, 1, 1), 0), ((0.2, 0.3, 0.7, 0.9), 1), ((0, 0, 0.5, 1), 2)):
        other = new_renderer(window, how)
        other.SetViewport(*viewport)
        other.SetLayer(layer)
        other.SetPreserveDepthBuffer(layer == 2)
        other.GetActiveCamera().Azimuth(40 * layer)
        if how == "layers":
            peel(other, how)


def select(renderer):
    """Says how many props are seen in each part of the window."""
    selector = vtk.vtkHardwareSelector()
    selector.SetRenderer(renderer)
    for x in range(0, 160, 40):
        selector.SetArea(x, 30, x + 39, 90)
        print(selector.Select().GetNumberOfNodes())


def main():
    file, how = sys.argv[1:3]
    samples = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    effect = sys.argv[4] if len(sys.argv) > 4 else None
    window = vtk.vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(samples)
    window.SetSize(160, 120)
    renderer = new_renderer(window, how)
    if effect:
        ball(renderer, (0.5, -0.3, 0.1), (1, 1, 1), 1)
        ball(renderer, (0.7, 0, 0.2), (1, 1, 0.5), 1).GetProperty().SetRepresentationToWireframe()
    chain = new_pass(how)
    if chain:
        renderer.SetPass(chain)
        if effect:
            outer = getattr(vtk, effect)()
            outer.SetDelegatePass(chain)
            renderer.SetPass(outer)
    elif effect:
        getattr(renderer, effect + "On")()
    if how in ("renderer", "volumes", "layers"):
        peel(renderer, how)
    if how.startswith("layers"):
        add_layers(window, renderer, how)
    if how == "switched-off":
        renderer.AddObserver("StartEvent", lambda *_: renderer.UseDepthPeelingOff())
    window.Render()
    time = renderer.GetMTime()
    window.Render()
    if renderer.GetMTime() != time and not effect:  # some of VTK's passes do it
        print("drawing modifies the renderer", file=sys.stderr)
    if how == "selecting":
        select(renderer)
        window.Render()
    reader = vtk.vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.ReadFrontBufferOff()
    reader.ShouldRerenderOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(file)
    writer.SetInputConnection(reader.GetOutputPort())
    writer.Write()
    if (renderer.GetUseDepthPeeling(), renderer.GetUseDepthPeelingForVolumes()) != (how in ("renderer", "volumes", "layers"), how == "volumes"):
        print("somebody has changed whether the renderer peels", file=sys.stderr)
    return 7


if __name__ == "__main__":
    sys.exit(main())
