"""Every class of VTK's props that draws in a scene, made translucent: a function for those that don't draw as they are made.

A class that is not made to draw stands in NOT_DRAWN, with the reason. What of a release's classes is in neither list, or in both, is in
get_unlisted().
"""

import inspect
import re

from vtkmodules import all as vtk

from kinds import checkers, configured, surface

OPACITY = 0.4
BOUNDS = (-0.6, 0.6, -0.5, 0.5, -0.4, 0.4)

RECIPES = {}
NOT_DRAWN = {}


def recipe(*names):
    def register(build):
        RECIPES.update((name, build) for name in names)
        return build

    return register


def as_made(*names):
    RECIPES.update((name, lambda prop, renderer: None) for name in names)


def not_drawn(why, *names):
    NOT_DRAWN.update((name, why) for name in names)


def prop_classes():
    """The names of all that can be made, one of each that VTK's factory gives."""
    names = []
    for name in dir(vtk):
        candidate = getattr(vtk, name)
        if not (inspect.isclass(candidate) and issubclass(candidate, vtk.vtkProp)):
            continue
        try:
            candidate()
        except (TypeError, NotImplementedError):  # abstract
            continue
        if not (name.startswith("vtkOpenGL") and hasattr(vtk, name.replace("OpenGL", ""))):
            names.append(name)
    return names


def get_unlisted():
    """Classes that VTK has and the lists have not, and those that are in both, with what is wrong, one text for each."""
    return [f"{name} is a prop that {'both' if name in RECIPES else 'none'} of RECIPES and NOT_DRAWN names, expected one: see Testing/Props/props.py"
            for name in prop_classes() if (name in RECIPES) == (name in NOT_DRAWN)]


def make(name, renderer):
    """The prop, in the renderer. What it refers to but does not keep lives as long as the Python object."""
    prop = getattr(vtk, name)()
    if isinstance(prop, vtk.vtkWidgetRepresentation):
        prop.SetRenderer(renderer)
        prop.SetPlaceFactor(1)
    prop.kept = RECIPES[name](prop, renderer)
    if isinstance(prop, vtk.vtkWidgetRepresentation):
        prop.PlaceWidget(BOUNDS)
        prop.BuildRepresentation()
        prop.SetVisibility(True)
    renderer.AddViewProp(prop)
    soften(prop, set())
    return prop


PARTS = re.compile(r"Get(\w*Property|\w*Actor|\w*Representation|\w*Handle|\w*Prop|\w*Prop3D)$")
PROPERTIES = (vtk.vtkProperty, vtk.vtkImageProperty, vtk.vtkTextProperty)


def soften(thing, seen):
    """Makes all properties translucent that a prop or its parts have a getter for."""
    if thing in seen:
        return
    seen.add(thing)
    if isinstance(thing, PROPERTIES):
        thing.SetOpacity(OPACITY)
        if isinstance(thing, vtk.vtkProperty):
            thing.SetAmbient(0)  # light above 1 is cut off by a picture of eight bits, but not by a pass
    elif isinstance(thing, vtk.vtkProp):
        for name in filter(PARTS.match, dir(thing)):
            try:
                soften(getattr(thing, name)(), seen)
            except TypeError:  # it wants arguments
                continue


def ball(radius=0.5, center=(0, 0, 0)):
    return surface(vtk.vtkSphereSource(), Radius=radius, Center=center, ThetaResolution=24, PhiResolution=24)


def soft_ball(*arguments):
    actor = ball(*arguments)
    actor.GetProperty().SetOpacity(OPACITY)
    return actor


def slice_of(image):
    mapper = vtk.vtkImageSliceMapper()
    mapper.SetInputData(image)
    image_slice = vtk.vtkImageSlice()
    image_slice.SetMapper(mapper)
    image_slice.GetProperty().SetOpacity(OPACITY)
    image_slice.ForceTranslucentOn()  # VTK draws slices as if they were opaque otherwise
    return image_slice


def centered(image):
    image.SetSpacing(0.04, 0.04, 1)
    image.SetOrigin(-0.62, -0.62, 0)
    return image


as_made("vtkAnnotatedCubeActor", "vtkBoxRepresentation", "vtkCameraPathRepresentation", "vtkFinitePlaneRepresentation",
        "vtkImplicitCylinderRepresentation", "vtkImplicitPlaneRepresentation",
        "vtkLineRepresentation", "vtkPolyLineRepresentation",
        "vtkSplineRepresentation", "vtkTensorRepresentation")


@recipe("vtkActor", "vtkLODActor", "vtkQuadricLODActor")
def _(prop, _):
    prop.SetMapper(ball().GetMapper())


@recipe("vtkFollower")
def _(prop, renderer):
    prop.SetMapper(ball().GetMapper())
    prop.SetCamera(renderer.GetActiveCamera())


def axis_on(prop, renderer):
    prop.SetPoint1(-0.6, -0.3, -0.4)
    prop.SetPoint2(0.6, 0.4, 0.4)
    prop.SetBounds(BOUNDS)
    prop.SetRange(0, 1)
    prop.SetCamera(renderer.GetActiveCamera())
    prop.SetMajorTickSize(0.4)
    prop.SetMinorTicksVisible(True)
    prop.GetProperty().SetLineWidth(3)
    prop.SetTitle("axis")
    return prop


@recipe("vtkAxisActor")
def _(prop, renderer):
    axis_on(prop, renderer)


@recipe("vtkAxisFollower")
def _(prop, renderer):
    prop.SetMapper(ball().GetMapper())
    prop.SetCamera(renderer.GetActiveCamera())
    axis = axis_on(vtk.vtkAxisActor(), renderer)
    prop.SetAxis(axis)
    return axis


@recipe("vtkProp3DFollower")
def _(prop, renderer):
    prop.SetProp3D(soft_ball())
    prop.SetCamera(renderer.GetActiveCamera())


@recipe("vtkProp3DAxisFollower")
def _(prop, renderer):
    prop.SetProp3D(soft_ball())
    prop.SetCamera(renderer.GetActiveCamera())
    prop.SetViewport(renderer)
    axis = axis_on(vtk.vtkAxisActor(), renderer)
    prop.SetAxis(axis)
    return axis


@recipe("vtkAssembly", "vtkPropAssembly")
def _(prop, _):
    prop.AddPart(soft_ball())
    prop.AddPart(soft_ball(0.3, (0.4, 0, 0)))


@recipe("vtkLODProp3D")
def _(prop, _):
    actor = soft_ball()
    prop.AddLOD(actor.GetMapper(), actor.GetProperty(), 0)


@recipe("vtkAxesActor")
def _(prop, _):
    prop.AxisLabelsOff()  # in the plane of the picture
    prop.SetShaftTypeToCylinder()


@recipe("vtkCubeAxesActor")
def _(prop, renderer):
    prop.SetBounds(BOUNDS)
    prop.SetCamera(renderer.GetActiveCamera())
    prop.SetFlyModeToStaticEdges()
    prop.DrawXGridpolysOn()
    prop.DrawYGridpolysOn()


@recipe("vtkImageActor")
def _(prop, _):
    prop.SetInputData(centered(checkers()))
    prop.SetOpacity(OPACITY)


@recipe("vtkImageSlice")
def _(prop, _):
    prop.SetMapper(slice_of(centered(checkers())).GetMapper())
    prop.ForceTranslucentOn()


@recipe("vtkImageStack")
def _(prop, _):
    prop.AddImage(slice_of(centered(checkers())))
    prop.ForceTranslucentOn()


@recipe("vtkTextActor3D")
def _(prop, _):
    prop.SetInput("Text")
    prop.GetTextProperty().SetFontSize(40)
    prop.SetScale(0.012)
    prop.SetPosition(-0.6, -0.2, 0.1)


@recipe("vtkBillboardTextActor3D")
def _(prop, _):
    prop.SetInput("Text")
    prop.GetTextProperty().SetFontSize(20)
    prop.SetPosition(-0.3, -0.1, 0.1)


@recipe("vtkFlagpoleLabel")
def _(prop, _):
    prop.SetInput("Text")
    prop.SetBasePosition(0, -0.6, 0)
    prop.SetTopPosition(0, 0.3, 0)
    prop.SetFlagSize(2)
    prop.ForceTranslucentOn()


@recipe("vtkAngleRepresentation3D")
def _(prop, _):
    prop.SetHandleRepresentation(vtk.vtkPointHandleRepresentation3D())
    prop.InstantiateHandleRepresentation()
    prop.SetPoint1WorldPosition((-0.6, -0.5, -0.3))
    prop.SetCenterWorldPosition((0, 0, 0))
    prop.SetPoint2WorldPosition((0.6, -0.4, 0.3))
    for ray in (prop.GetRay1(), prop.GetRay2(), prop.GetArc()):
        ray.GetProperty().SetOpacity(OPACITY)
        ray.GetProperty().SetLineWidth(4)


@recipe("vtkDistanceRepresentation3D")
def _(prop, _):
    prop.SetHandleRepresentation(vtk.vtkPointHandleRepresentation3D())
    prop.InstantiateHandleRepresentation()
    prop.SetPoint1WorldPosition((-0.6, -0.5, -0.3))
    prop.SetPoint2WorldPosition((0.6, 0.4, 0.3))
    prop.GetLineProperty().SetLineWidth(5)
    prop.RulerModeOn()


@recipe("vtkMeasurementCubeHandleRepresentation3D")
def _(prop, _):
    prop.SetAdaptiveScaling(False)  # each drawing would change its size


@recipe("vtkFixedSizeHandleRepresentation3D")
def _(prop, _):
    prop.SetHandleSizeInPixels(30)


@recipe("vtkConstrainedPointHandleRepresentation")
def _(prop, _):
    prop.SetCursorShape(configured(vtk.vtkDiskSource(), InnerRadius=0.2, OuterRadius=0.6).GetOutput())


@recipe("vtkPointHandleRepresentation3D", "vtkSphereHandleRepresentation")
def _(prop, _):
    prop.SetHandleSize(30)


@recipe("vtkSliderRepresentation3D")
def _(prop, _):
    prop.GetPoint1Coordinate().SetValue(-0.6, -0.4, 0.3)
    prop.GetPoint2Coordinate().SetValue(0.6, 0.4, -0.3)
    prop.SetSliderWidth(0.2)
    prop.SetTubeWidth(0.1)
    prop.ShowSliderLabelOff()


@recipe("vtkPolygonalHandleRepresentation3D", "vtkOrientedPolygonalHandleRepresentation3D")
def _(prop, _):
    prop.SetHandle(configured(vtk.vtkCubeSource(), XLength=0.6, YLength=0.5, ZLength=0.4).GetOutput())


@recipe("vtkPointCloudRepresentation")
def _(prop, _):
    prop.PlacePointCloud(configured(vtk.vtkSphereSource(), Radius=0.5, ThetaResolution=20, PhiResolution=20).GetOutput())
    prop.GetPointCloudActor().GetProperty().SetPointSize(4)


@recipe("vtkProp3DButtonRepresentation")
def _(prop, _):
    prop.SetNumberOfStates(1)
    prop.SetButtonProp(0, soft_ball())
    prop.SetState(0)


@recipe("vtkTexturedButtonRepresentation")
def _(prop, _):
    prop.SetNumberOfStates(1)
    prop.SetButtonGeometry(configured(vtk.vtkPlaneSource()).GetOutput())
    prop.SetButtonTexture(0, checkers())
    prop.SetState(0)


@recipe("vtkLightRepresentation")
def _(prop, _):
    prop.SetLightPosition((0.2, 0.4, 0.4))
    prop.SetFocalPoint((-0.3, -0.4, -0.3))
    prop.SetPositional(True)
    prop.SetConeAngle(30)


@recipe("vtkOrientedGlyphContourRepresentation")
def _(prop, _):
    prop.GetLinesProperty().SetLineWidth(4)
    for at in ((-0.5, -0.4, -0.2), (0.5, -0.4, 0.2), (0.3, 0.5, -0.2), (-0.4, 0.4, 0.3)):
        prop.AddNodeAtWorldPosition(at)
    prop.ClosedLoopOn()


@recipe("vtkSphereRepresentation")
def _(prop, _):
    prop.HandleTextOff()  # in the plane of the picture: each slab would draw it


@recipe("vtkCheckerboardRepresentation")
def _(prop, renderer):
    board = vtk.vtkImageCheckerboard()
    board.SetInputData(0, centered(checkers()))
    board.SetInputData(1, centered(checkers()))
    board.SetNumberOfDivisions(2, 2, 1)
    board.Update()
    actor = vtk.vtkImageActor()
    actor.SetInputData(board.GetOutput())
    prop.SetCheckerboard(board)
    prop.SetImageActor(actor)
    for side in ("Top", "Right", "Bottom", "Left"):
        getattr(prop, f"Get{side}Representation")().SetRenderer(renderer)  # without it all four stay where they were made


@recipe("vtkCameraOrientationRepresentation")
def _(prop, _):
    prop.SetContainerVisibility(True)


not_drawn("in the plane of the picture, above the scene", "vtkActor2D", "vtkAxisActor2D", "vtkBarChartActor", "vtkCaptionActor2D",
          "vtkContextActor", "vtkCornerAnnotation", "vtkCubeAxesActor2D", "vtkLeaderActor2D", "vtkLegendBoxActor", "vtkLegendScaleActor",
          "vtkParallelCoordinatesActor", "vtkPieChartActor", "vtkScalarBarActor", "vtkScaledTextActor", "vtkSpiderPlotActor", "vtkTextActor",
          "vtkTexturedActor2D", "vtkXYPlotActor")
not_drawn("its parts are 2-D actors, above the scene", "vtkAffineRepresentation2D", "vtkAngleRepresentation2D", "vtkBalloonRepresentation",
          "vtkBiDimensionalRepresentation2D", "vtkBorderRepresentation", "vtkCameraRepresentation", "vtkCaptionRepresentation",
          "vtkCenteredSliderRepresentation", "vtkCompassRepresentation", "vtkDistanceRepresentation2D", "vtkLogoRepresentation", "vtkMagnifierRepresentation",
          "vtkOrientedGlyphFocalPlaneContourRepresentation", "vtkPlaybackRepresentation", "vtkPointHandleRepresentation2D",
          "vtkProgressBarRepresentation", "vtkRectilinearWipeRepresentation", "vtkScalarBarRepresentation", "vtkSliderRepresentation2D",
          "vtkTextRepresentation", "vtkTexturedButtonRepresentation2D")
not_drawn("a volume: see Documentation/SceneKinds.md", "vtkMultiVolume", "vtkVolume")
not_drawn("VTK draws its parts among opaque props only, so that none is drawn that is translucent", "vtkCameraActor",
          "vtkEllipsoidTensorProbeRepresentation", "vtkLightActor", "vtkParallelopipedRepresentation", "vtkPolarAxesActor", "vtkResliceCursorActor")
not_drawn("draws nothing itself: its handles are props of their own", "vtkSeedRepresentation")
not_drawn("draws nothing as it is made, whatever is set", "vtkAxesTransformRepresentation")
not_drawn("draws nothing but in virtual reality", "vtkAvatar")
not_drawn("a background, behind all there is", "vtkSkybox")
not_drawn("turns the camera to its plane in every frame, so that slabs of depth can't be had of it", "vtkResliceCursorLineRepresentation",
          "vtkResliceCursorThickLineRepresentation")
not_drawn("not made to draw: VTK 9.1 crashes at what was tried; its plane is drawn as that of vtkImplicitPlaneRepresentation",
          "vtkImplicitImageRepresentation")
