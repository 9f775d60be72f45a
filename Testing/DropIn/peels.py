"""A program that knows nothing of this project: draws a scene by depth peeling into a PNG file.

    peels.py FILE HOW [SAMPLES [EFFECT]]    HOW: renderer, dual, single, volumes, or blending, which does not peel
                                            EFFECT: a flag of vtkRenderer, such as UseSSAO, or the class of a pass around a pass of its own
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


def cloud(renderer):
    source = vtk.vtkRTAnalyticSource()
    source.SetWholeExtent(-8, 8, -8, 8, -8, 8)
    mapper = vtk.vtkGPUVolumeRayCastMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    volume.SetScale(0.06)
    opacity = vtk.vtkPiecewiseFunction()
    opacity.AddPoint(100, 0)
    opacity.AddPoint(280, 0.3)
    volume.GetProperty().SetScalarOpacity(opacity)
    renderer.AddVolume(volume)


def main():
    file, how = sys.argv[1:3]
    window = vtk.vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(int(sys.argv[3]) if len(sys.argv) > 3 else 0)
    window.SetSize(160, 120)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.2, 0.3, 0.4)
    window.AddRenderer(renderer)
    ball(renderer, (0, 0, 0), (1, 0.2, 0.2))
    ball(renderer, (0.2, 0.1, -0.4), (0.2, 1, 0.2))
    ball(renderer, (-0.1, 0.2, 0.5), (0.2, 0.3, 1))
    if how == "volumes":
        cloud(renderer)
    effect = sys.argv[4] if len(sys.argv) > 4 else None
    if effect:
        ball(renderer, (0.5, -0.3, 0.1), (1, 1, 1), 1)
        ball(renderer, (0.7, 0, 0.2), (1, 1, 0.5), 1).GetProperty().SetRepresentationToWireframe()
    if how in ("dual", "single"):
        peeling = vtk.vtkDualDepthPeelingPass() if how == "dual" else vtk.vtkDepthPeelingPass()
        peeling.SetTranslucentPass(vtk.vtkTranslucentPass())
        peeling.SetMaximumNumberOfPeels(100)
        peeling.SetOcclusionRatio(0)
        steps = vtk.vtkRenderStepsPass()
        steps.SetTranslucentPass(peeling)
        renderer.SetPass(steps)
        if effect:
            outer = getattr(vtk, effect)()
            outer.SetDelegatePass(steps)
            renderer.SetPass(outer)
    elif how != "blending":
        renderer.UseDepthPeelingOn()
        renderer.SetMaximumNumberOfPeels(100)
        renderer.SetOcclusionRatio(0)
        renderer.SetUseDepthPeelingForVolumes(how == "volumes")
        if effect:
            getattr(renderer, effect + "On")()
    window.Render()
    reader = vtk.vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.ReadFrontBufferOff()
    reader.ShouldRerenderOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(file)
    writer.SetInputConnection(reader.GetOutputPort())
    writer.Write()
    return 7


if __name__ == "__main__":
    sys.exit(main())
