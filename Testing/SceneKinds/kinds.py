"""Scenes of every kind that VTK draws with translucent props: one function a kind, which fills a Stage.

Each scene has more than its kind asks for, so that the order of drawing matters: a translucent ball, drawn first, that reaches through
what the kind adds, and an opaque box that both reach through.
"""

import math

from vtkmodules import all as vtk

KINDS = {}

# The mapper of composite data that keeps its blocks: the one of that name draws each by a mapper of its own up to VTK 9.2, and is the same since.
BlocksMapper = getattr(vtk, "vtkCompositePolyDataMapper2", vtk.vtkCompositePolyDataMapper)


class Kind:
    def __init__(self, build, what, share, share_of_samples, known, why, may_fail):
        self.build = build
        self.what = what
        self.share = share  # of the pixels that have to be within 3/255 of the truth, one sample a pixel
        self.share_of_samples = share_of_samples  # the same with four samples: within 8/255
        self.known = known  # of the pixels of which the truth has to be known
        self.why = why  # what explains the rest, for the table
        self.may_fail = may_fail  # in VTK itself, without this module: on some release it does, even of opaque props


def kind(what, share=0.9998, share_of_samples=0.995, known=0.95, why="", may_fail=False):
    def register(build):
        KINDS[build.__name__] = Kind(build, what, share, share_of_samples, known, why, may_fail)
        return build

    return register


class Stage:
    """A window and what was added to it. Kinds that do more than add props set what else it has."""

    def __init__(self, window):
        self.window = window
        self.renderer = self.add_renderer()
        self.translucent = []  # those that a picture without is drawn of, to see that they are seen
        self.arrange = lambda renderer, steps: None  # after a pass was set; steps is it, or None with VTK's own drawing
        self.shoot = window.Render
        self.scale = 1  # of the picture, to the window's size
        self.tiles = 1  # how many windows' widths the picture has of which the window is a part
        self.undivided = (0, 0)  # distances between which the truth has no slabs
        self.keep = []

    def add_renderer(self, viewport=(0, 0, 1, 1), layer=0):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(viewport)
        renderer.SetLayer(layer)
        renderer.SetBackground(0.1, 0.2, 0.35)
        self.window.AddRenderer(renderer)
        return renderer

    def add(self, prop, renderer=None, translucent=True):
        if translucent:
            self.translucent.append(prop)
        (renderer or self.renderer).AddViewProp(prop)
        return prop

    def companions(self, renderer=None):
        ball = surface(vtk.vtkSphereSource(), ThetaResolution=24, PhiResolution=24, Radius=0.55, Center=(0.35, 0.2, 0.25))
        look(ball, (0.9, 0.5, 0.1), 0.45)
        self.add(ball, renderer)
        box = surface(vtk.vtkCubeSource(), XLength=0.5, YLength=0.7, ZLength=0.4, Center=(-0.45, -0.35, 0))
        look(box, (0.3, 0.7, 0.4), 1)
        self.add(box, renderer, translucent=False)


def configured(source, **settings):
    for name, value in settings.items():
        getattr(source, "Set" + name)(value)
    source.Update()
    return source


def surface(source, **settings):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(configured(source, **settings).GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def look(actor, color, opacity):
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def sphere(opacity=0.5, color=(0.3, 0.4, 0.9), center=(0, 0, 0), radius=0.7, resolution=24):
    return look(surface(vtk.vtkSphereSource(), ThetaResolution=resolution, PhiResolution=resolution, Radius=radius,
                        Center=center), color, opacity)


def wavy(cells=20):
    """A plane in waves with point scalars from -1 to 1 and texture coordinates."""
    plane = configured(vtk.vtkPlaneSource(), Origin=(-0.9, -0.9, 0), Point1=(0.9, -0.9, 0.1), Point2=(-0.9, 0.9, -0.1))
    plane.SetResolution(cells, cells)
    plane.Update()
    data = vtk.vtkPolyData()
    data.DeepCopy(plane.GetOutput())
    heights = vtk.vtkDoubleArray()
    heights.SetName("height")
    points = data.GetPoints()
    for i in range(points.GetNumberOfPoints()):
        x, y, z = points.GetPoint(i)
        height = math.sin(4 * x) * math.cos(3 * y)
        points.SetPoint(i, x, y, z + 0.3 * height)
        heights.InsertNextValue(height)
    data.GetPointData().SetScalars(heights)
    return data


def apart(data):
    """The cells of a mesh with gaps between them: a point or an edge that cells share is drawn by each of them, at one depth."""
    return configured(vtk.vtkShrinkPolyData(), InputData=data, ShrinkFactor=0.8).GetOutput()


def mesh(data, scalars=False):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetScalarVisibility(scalars)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def opacity_table(lowest=0.1, highest=0.8):
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(32)
    table.SetRange(-1, 1)
    for i in range(32):
        t = i / 31
        table.SetTableValue(i, t, 0.3, 1 - t, lowest + (highest - lowest) * t)
    return table


def checkers():
    """An image of 32 x 32 with opacities from 0.1 to 0.9."""
    image = vtk.vtkImageData()
    image.SetDimensions(32, 32, 1)
    image.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 4)
    pixels = image.GetPointData().GetScalars()
    for i in range(32 * 32):
        x, y = i % 32, i // 32
        on = (x // 4 + y // 4) % 2
        pixels.SetTuple4(i, 255 * on, 120, 255 - 7 * x, 230 if on else 30 + 4 * y)
    return image


# ---------------------------------------------------------------------------------------------------------------------
# Where opacity comes from.


@kind("opacity by property")
def opacity_by_property(stage):
    stage.add(sphere())


@kind("opacity by scalars and a lookup table")
def opacity_by_lookup_table(stage):
    actor = mesh(wavy(), scalars=True)
    actor.GetMapper().SetLookupTable(opacity_table())
    actor.GetMapper().UseLookupTableScalarRangeOn()
    stage.add(actor)


@kind("the same, looked up after interpolation (by texture)")
def opacity_by_interpolated_scalars(stage):
    actor = mesh(wavy(), scalars=True)
    actor.GetMapper().SetLookupTable(opacity_table())
    actor.GetMapper().UseLookupTableScalarRangeOn()
    actor.GetMapper().InterpolateScalarsBeforeMappingOn()
    stage.add(actor)


@kind("opacity by cell scalars")
def opacity_by_cell_scalars(stage):
    data = wavy()
    to_cells = vtk.vtkPointDataToCellData()
    to_cells.SetInputData(data)
    to_cells.Update()
    actor = mesh(to_cells.GetOutput(), scalars=True)
    actor.GetMapper().SetScalarModeToUseCellData()
    actor.GetMapper().SetLookupTable(opacity_table())
    actor.GetMapper().UseLookupTableScalarRangeOn()
    stage.add(actor)


@kind("opacity by a texture's alpha", share_of_samples=0.96, why="texels are seen once a pixel: their borders are not smoothed")
def opacity_by_texture(stage):
    actor = mesh(wavy())
    texture = vtk.vtkTexture()
    texture.SetInputData(checkers())
    actor.SetTexture(texture)
    stage.add(actor)


@kind("opacity by colours of four components at the vertices")
def opacity_by_vertex_colors(stage):
    data = wavy()
    colors = vtk.vtkUnsignedCharArray()
    colors.SetNumberOfComponents(4)
    for i in range(data.GetNumberOfPoints()):
        colors.InsertNextTuple4((37 * i) % 256, 90, 200, 40 + (53 * i) % 160)
    data.GetPointData().SetScalars(colors)
    stage.add(mesh(data, scalars=True))


@kind("opacity by block of a composite data set")
def opacity_by_block(stage):
    blocks = vtk.vtkMultiBlockDataSet()
    for i in range(4):
        blocks.SetBlock(i, configured(vtk.vtkSphereSource(), Radius=0.4, Center=(-0.6 + 0.4 * i, 0.1, 0.1 * i)).GetOutput())
    actor = vtk.vtkActor()
    mapper = BlocksMapper()
    mapper.SetInputDataObject(blocks)
    attributes = vtk.vtkCompositeDataDisplayAttributes()
    mapper.SetCompositeDataDisplayAttributes(attributes)
    for i in range(4):
        mapper.SetBlockOpacity(i + 1, 0.2 + 0.2 * i)
        mapper.SetBlockColor(i + 1, 0.2 * i, 0.5, 1 - 0.2 * i)
    actor.SetMapper(mapper)
    stage.add(actor)


@kind("glyphs, opacity by glyph (vtkGlyph3DMapper)")
def opacity_by_glyph(stage):
    points = vtk.vtkPoints()
    colors = vtk.vtkUnsignedCharArray()
    colors.SetName("colors")
    colors.SetNumberOfComponents(4)
    for i in range(27):
        points.InsertNextPoint(0.5 * (i % 3 - 1), 0.5 * (i // 3 % 3 - 1), 0.5 * (i // 9 - 1))
        colors.InsertNextTuple4(9 * i, 255 - 9 * i, 120, 50 + 6 * i)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.GetPointData().SetScalars(colors)
    mapper = vtk.vtkGlyph3DMapper()
    mapper.SetInputData(data)
    source = configured(vtk.vtkSphereSource(), Radius=0.3)
    mapper.SetSourceConnection(source.GetOutputPort())
    mapper.ScalingOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(0.6)
    stage.add(actor)


# ---------------------------------------------------------------------------------------------------------------------
# What is drawn.


def splats(emissive):
    data = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    for i in range(40):
        points.InsertNextPoint(0.8 * math.sin(2.1 * i), 0.8 * math.sin(1.3 * i + 1), 0.8 * math.sin(0.7 * i + 2))
    data.SetPoints(points)
    mapper = vtk.vtkPointGaussianMapper()
    mapper.SetInputData(data)
    mapper.SetScaleFactor(0.1)
    mapper.SetEmissive(emissive)
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return look(actor, (0.9, 0.9, 0.3), 0.7)


@kind("point gaussians")
def point_gaussians(stage):
    stage.add(splats(emissive=False))


@kind("point gaussians that are emissive")
def emissive_gaussians(stage):
    stage.add(splats(emissive=True))


@kind("points as spheres", share_of_samples=0.9, why="outlines are found once a pixel")
def points_as_spheres(stage):
    data = vtk.vtkPolyData()
    data.SetPoints(wavy(6).GetPoints())
    glyphs = configured(vtk.vtkVertexGlyphFilter(), InputData=data)
    actor = look(mesh(glyphs.GetOutput()), (0.3, 0.6, 0.9), 0.5)
    actor.GetProperty().RenderPointsAsSpheresOn()
    actor.GetProperty().SetPointSize(24)
    stage.add(actor)


@kind("lines as tubes", share_of_samples=0.98, known=0.94, why="outlines are found once a pixel")
def lines_as_tubes(stage):
    actor = look(mesh(apart(wavy(6))), (0.3, 0.6, 0.9), 0.5)
    actor.GetProperty().SetRepresentationToWireframe()
    actor.GetProperty().RenderLinesAsTubesOn()
    actor.GetProperty().SetLineWidth(8)
    stage.add(actor)


@kind("wireframe", share_of_samples=0.9, why="lines are as wide in each of the four pictures as in one")
def wireframe(stage):
    actor = look(mesh(apart(wavy(10))), (1, 1, 0.6), 0.5)
    actor.GetProperty().SetRepresentationToWireframe()
    stage.add(actor)


@kind("wide lines", share_of_samples=0.9, why="lines are as wide in each of the four pictures as in one")
def wide_lines(stage):
    actor = look(mesh(apart(wavy(6))), (1, 1, 0.6), 0.5)
    actor.GetProperty().SetRepresentationToWireframe()
    actor.GetProperty().SetLineWidth(5)
    stage.add(actor)


@kind("surface with edges", share_of_samples=0.985, why="edges are found once a pixel")
def surface_with_edges(stage):
    actor = look(mesh(wavy(8)), (0.4, 0.6, 0.8), 0.5)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(1, 1, 1)
    actor.GetProperty().SetLineWidth(2)
    stage.add(actor)


@kind("surface with vertices")
def surface_with_vertices(stage):
    actor = look(mesh(wavy(8)), (0.4, 0.6, 0.8), 0.5)
    actor.GetProperty().VertexVisibilityOn()
    actor.GetProperty().SetVertexColor(1, 0.9, 0.2)
    actor.GetProperty().SetPointSize(5)
    stage.add(actor)


@kind("vertices, lines, polygons and strips in one mesh", share_of_samples=0.99, why="lines are as wide in each of the four pictures as in one")
def mixed_cells(stage):
    data = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    for i in range(24):
        points.InsertNextPoint(-0.9 + 0.3 * (i % 6), -0.7 + 0.4 * (i // 6), 0.3 * math.sin(i))
    data.SetPoints(points)
    data.AllocateExact(40, 200)

    def cell(kind_of_cell, *ids):
        data.InsertNextCell(kind_of_cell, len(ids), ids)

    cell(vtk.VTK_VERTEX, 3)
    cell(vtk.VTK_POLY_VERTEX, 9, 15)
    cell(vtk.VTK_LINE, 0, 20)
    cell(vtk.VTK_POLY_LINE, 2, 9, 14, 23)
    cell(vtk.VTK_TRIANGLE, 0, 1, 7)
    cell(vtk.VTK_QUAD, 2, 3, 9, 8)
    cell(vtk.VTK_POLYGON, 4, 5, 11, 17, 10)
    cell(vtk.VTK_TRIANGLE_STRIP, 12, 18, 13, 19, 14, 20, 15, 21)
    actor = look(mesh(data), (0.9, 0.5, 0.6), 0.5)
    actor.GetProperty().SetPointSize(7)
    actor.GetProperty().SetLineWidth(3)
    stage.add(actor)


def shaded(stage, arrange):
    actor = sphere(resolution=16)
    arrange(actor.GetProperty())
    actor.GetProperty().SetSpecular(0.6)
    actor.GetProperty().SetSpecularPower(20)
    stage.add(actor)


@kind("flat shading")
def flat_shading(stage):
    shaded(stage, lambda p: p.SetInterpolationToFlat())


@kind("Gouraud shading")
def gouraud_shading(stage):
    shaded(stage, lambda p: p.SetInterpolationToGouraud())


@kind("Phong shading")
def phong_shading(stage):
    shaded(stage, lambda p: p.SetInterpolationToPhong())


@kind("physically based shading")
def pbr_shading(stage):
    def arrange(p):
        p.SetInterpolationToPBR()
        p.SetMetallic(0.4)
        p.SetRoughness(0.3)

    shaded(stage, arrange)


@kind("clipping planes")
def clipping_planes(stage):
    actor = sphere()
    plane = vtk.vtkPlane()
    plane.SetNormal(0.6, 0.3, -0.7)
    actor.GetMapper().AddClippingPlane(plane)
    stage.add(actor)


@kind("follower")
def follower(stage):
    made = vtk.vtkFollower()
    made.SetMapper(sphere().GetMapper())
    made.SetScale(1, 0.5, 1)
    made.SetCamera(stage.renderer.GetActiveCamera())
    stage.add(look(made, (0.8, 0.3, 0.8), 0.5))


@kind("text in the scene (vtkVectorText, vtkTextActor3D)", share_of_samples=0.98, why="texels are seen once a pixel")
def text_in_scene(stage):
    text = vtk.vtkVectorText()
    text.SetText("VTK")
    actor = surface(text)
    actor.SetScale(0.6)
    actor.SetPosition(-0.8, -0.1, 0.5)
    stage.add(look(actor, (1, 1, 1), 0.6))
    flat = vtk.vtkTextActor3D()
    flat.SetInput("see")
    flat.GetTextProperty().SetFontSize(40)
    flat.GetTextProperty().SetOpacity(0.6)
    flat.SetScale(0.01)
    flat.SetPosition(-0.6, 0.3, 0.7)
    stage.add(flat)


@kind("billboard text", share_of_samples=0.97, why="stands on whole pixels in each of the four pictures")
def billboard_text(stage):
    text = vtk.vtkBillboardTextActor3D()
    text.SetInput("billboard")
    text.SetPosition(-0.6, 0.1, 0.6)
    text.GetTextProperty().SetFontSize(34)
    text.GetTextProperty().SetOpacity(0.6)
    stage.add(text)


@kind("actors in an assembly")
def assembly(stage):
    made = vtk.vtkAssembly()
    made.AddPart(sphere(0.4, (0.9, 0.2, 0.2), (-0.3, 0, 0), 0.4))
    inner = vtk.vtkAssembly()
    inner.AddPart(sphere(0.6, (0.2, 0.9, 0.2), (0.3, 0, 0), 0.4))
    inner.RotateZ(40)
    made.AddPart(inner)
    made.RotateY(30)
    stage.add(made)


@kind("prop assembly and level of detail (vtkPropAssembly, vtkLODProp3D)")
def prop_assembly(stage):
    made = vtk.vtkPropAssembly()
    made.AddPart(sphere(0.4, (0.9, 0.2, 0.2), (-0.3, 0, 0), 0.4))
    lod = vtk.vtkLODProp3D()
    actor = sphere(0.6, (0.2, 0.9, 0.2), (0.3, 0.3, 0), 0.4)
    lod.AddLOD(actor.GetMapper(), actor.GetProperty(), 0)
    made.AddPart(lod)
    stage.add(made)


@kind("2-D actors above")
def actors_2d(stage):
    stage.add(sphere())
    text = vtk.vtkTextActor()
    text.SetInput("above all")
    text.SetPosition(60, 140)
    text.GetTextProperty().SetFontSize(36)
    text.GetTextProperty().SetOpacity(0.7)
    stage.add(text)
    legend = vtk.vtkScalarBarActor()
    legend.SetLookupTable(opacity_table(1, 1))
    stage.add(legend, translucent=False)


@kind("a property of its own for back faces")
def backface_property(stage):
    actor = sphere(0.5)
    back = vtk.vtkProperty()
    back.SetColor(1, 0.2, 0.2)
    back.SetOpacity(0.5)
    actor.SetBackfaceProperty(back)
    plane = vtk.vtkPlane()
    plane.SetNormal(0, 0.3, -1)
    actor.GetMapper().AddClippingPlane(plane)
    stage.add(actor)


@kind("back faces culled")
def backface_culling(stage):
    actor = sphere()
    actor.GetProperty().BackfaceCullingOn()
    stage.add(actor)


@kind("front faces culled")
def frontface_culling(stage):
    actor = sphere()
    actor.GetProperty().FrontfaceCullingOn()
    stage.add(actor)


@kind("multi-block data")
def multi_block(stage):
    blocks = vtk.vtkMultiBlockDataSet()
    inner = vtk.vtkMultiBlockDataSet()
    blocks.SetBlock(0, configured(vtk.vtkSphereSource(), Radius=0.5, Center=(-0.3, 0, 0)).GetOutput())
    inner.SetBlock(0, configured(vtk.vtkConeSource(), Radius=0.5, Center=(0.4, 0, 0)).GetOutput())
    blocks.SetBlock(1, inner)
    mapper = BlocksMapper()
    mapper.SetInputDataObject(blocks)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    stage.add(look(actor, (0.5, 0.8, 0.9), 0.5))


@kind("partitioned data")
def partitioned(stage):
    parts = vtk.vtkPartitionedDataSetCollection()
    for i in range(2):
        part = vtk.vtkPartitionedDataSet()
        part.SetPartition(0, configured(vtk.vtkSphereSource(), Radius=0.5, Center=(0.6 * i - 0.3, 0, 0)).GetOutput())
        parts.SetPartitionedDataSet(i, part)
    mapper = BlocksMapper()
    mapper.SetInputDataObject(parts)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    stage.add(look(actor, (0.5, 0.8, 0.9), 0.5))


@kind("hidden lines removed", share_of_samples=0.98, why="lines are as wide in each of four pictures")
def hidden_line_removal(stage):
    stage.add(sphere())
    cone = look(surface(vtk.vtkConeSource(), Resolution=12, Height=1.5, Radius=0.5), (1, 1, 1), 1)
    cone.GetProperty().SetRepresentationToWireframe()
    stage.add(cone, translucent=False)
    stage.renderer.UseHiddenLineRemovalOn()


def volume(mapper, center=(0, 0, 0)):
    source = vtk.vtkRTAnalyticSource()
    source.SetWholeExtent(-16, 16, -16, 16, -16, 16)
    information = vtk.vtkImageChangeInformation()
    information.SetInputConnection(source.GetOutputPort())
    information.SetOutputSpacing(0.05, 0.05, 0.05)
    information.SetOutputOrigin(*center)
    mapper.SetInputConnection(information.GetOutputPort())
    opacity = vtk.vtkPiecewiseFunction()
    for value, alpha in ((60, 0), (130, 0.01), (200, 0.12), (280, 0.5)):
        opacity.AddPoint(value, alpha)
    colors = vtk.vtkColorTransferFunction()
    for value, rgb in ((60, (0.2, 0.3, 1)), (160, (0.9, 0.9, 0.5)), (280, (1, 0.3, 0.2))):
        colors.AddRGBPoint(value, *rgb)
    prop = vtk.vtkVolume()
    prop.SetMapper(mapper)
    prop.GetProperty().SetScalarOpacity(opacity)
    prop.GetProperty().SetColor(colors)
    prop.GetProperty().SetScalarOpacityUnitDistance(0.05)
    prop.GetProperty().SetInterpolationTypeToLinear()
    return prop


def ray_caster(**settings):
    mapper = vtk.vtkGPUVolumeRayCastMapper()
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(0.02)
    for name, value in settings.items():
        getattr(mapper, "Set" + name)(value)
    return mapper


def planes(stage, places=(1, -0.2, -1.1)):
    for z, rgb in zip(places, ((0.3, 0.9, 0.4), (0.9, 0.3, 0.9), (0.9, 0.9, 0.2))):
        plane = surface(vtk.vtkPlaneSource(), Center=(-0.3 + 0.3 * z, 0.1, z))
        look(plane, rgb, 0.5)
        stage.add(plane)


@kind("volume, and surfaces in front of it, inside of it and behind it")
def volume_first(stage):
    stage.add(volume(ray_caster()))
    planes(stage)


@kind("the same, added in another order")
def volume_last(stage):
    planes(stage)
    stage.add(volume(ray_caster()))


@kind("volume by vtkSmartVolumeMapper, shaded")
def volume_smart(stage):
    prop = stage.add(volume(vtk.vtkSmartVolumeMapper()))
    prop.GetProperty().ShadeOn()
    planes(stage)


@kind("volume by vtkMultiBlockVolumeMapper")
def volume_multi_block(stage):
    source = configured(vtk.vtkRTAnalyticSource())
    information = vtk.vtkImageChangeInformation()
    information.SetInputConnection(source.GetOutputPort())
    information.SetOutputSpacing(0.07, 0.07, 0.07)
    information.Update()
    blocks = vtk.vtkMultiBlockDataSet()
    blocks.SetBlock(0, information.GetOutput())
    mapper = vtk.vtkMultiBlockVolumeMapper()
    stage.add(volume(mapper))
    mapper.SetInputDataObject(blocks)
    stage.keep.append(source)
    planes(stage)


@kind("volume cut by clipping planes")
def volume_clipped(stage):
    mapper = ray_caster()
    for normal in ((0.6, 0.2, -0.8), (-1, 0.3, 0)):
        plane = vtk.vtkPlane()
        plane.SetOrigin(0.3, 0, 0.2)
        plane.SetNormal(*normal)
        mapper.AddClippingPlane(plane)
    stage.add(volume(mapper))
    planes(stage)


@kind("volume, cropped")
def volume_cropped(stage):
    stage.add(volume(ray_caster(Cropping=True, CroppingRegionPlanes=(-0.4, 0.3, -0.5, 0.4, -0.6, 0.2))))
    planes(stage)


@kind("volume, scaled and turned")
def volume_transformed(stage):
    prop = stage.add(volume(ray_caster()))
    prop.SetScale(1.2, 0.7, 0.9)
    prop.RotateX(30)
    prop.RotateZ(-50)
    planes(stage)


@kind("volume with the camera inside of it")
def volume_around_camera(stage):
    prop = stage.add(volume(ray_caster()))
    prop.SetScale(6)
    planes(stage)


@kind("volume in parallel projection")
def volume_parallel(stage):
    stage.renderer.GetActiveCamera().ParallelProjectionOn()
    stage.add(volume(ray_caster()))
    planes(stage)


def whole_volume(stage, blend_mode):
    """What such a volume shows is no sum along the ray, of which slabs could draw a part: no surface reaches into it."""
    prop = stage.add(volume(ray_caster(BlendMode=blend_mode)))
    prop.SetScale(0.5)
    planes(stage, (1, 0.85, -1.1))
    stage.translucent[0].SetPosition(0, 0, 1)  # the ball
    stage.undivided = (3.6, 4.75)
    return prop


@kind("volume, maximum intensity")
def volume_maximum(stage):
    whole_volume(stage, vtk.vtkVolumeMapper.MAXIMUM_INTENSITY_BLEND)


@kind("volume, isosurfaces")
def volume_isosurfaces(stage):
    prop = whole_volume(stage, vtk.vtkVolumeMapper.ISOSURFACE_BLEND)
    prop.GetProperty().GetIsoSurfaceValues().GenerateValues(3, 120, 240)
    prop.GetProperty().ShadeOn()


@kind("volume, a slice of it")
def volume_slice(stage):
    prop = whole_volume(stage, vtk.vtkVolumeMapper.SLICE_BLEND)
    plane = vtk.vtkPlane()
    plane.SetNormal(0.4, 0.3, 0.9)
    prop.GetProperty().SetSliceFunction(plane)


@kind("two volumes, one behind the other")
def volumes(stage):
    stage.add(volume(ray_caster(), (0.1, 0, 0.2))).SetScale(0.5)
    stage.add(volume(ray_caster(), (-0.5, 0.2, -2))).SetScale(0.6)
    planes(stage)


@kind("image slice (vtkImageSlice)")
def image_slice(stage):
    made = vtk.vtkImageSlice()
    mapper = vtk.vtkImageSliceMapper()
    mapper.SetInputData(checkers())
    made.SetMapper(mapper)
    made.GetProperty().SetOpacity(0.6)
    made.SetScale(0.05)
    made.SetPosition(-0.8, -0.8, 0.1)
    made.ForceTranslucentOn()  # VTK draws slices as if they were opaque otherwise
    stage.add(made)


@kind("image actor (vtkImageActor)")
def image_actor(stage):
    made = vtk.vtkImageActor()
    made.SetInputData(checkers())
    made.SetScale(0.05)
    made.SetPosition(-0.8, -0.8, 0.1)
    made.RotateY(30)
    stage.add(made)


@kind("user matrices that mirror")
def mirroring_matrix(stage):
    transform = vtk.vtkTransform()
    transform.Scale(-1, 1, 1)
    transform.RotateY(25)
    actor = look(mesh(wavy()), (0.4, 0.8, 0.6), 0.5)
    actor.SetUserMatrix(transform.GetMatrix())
    actor.GetProperty().BackfaceCullingOn()
    stage.add(actor)
    cone = look(surface(vtk.vtkConeSource(), Resolution=20, Radius=0.4), (0.9, 0.8, 0.3), 0.5)
    cone.SetUserMatrix(transform.GetMatrix())
    stage.add(cone)


@kind("shader replacements by the user")
def shader_replacements(stage):
    actor = sphere()
    replacement = actor.GetShaderProperty()
    replacement.AddFragmentShaderReplacement(
        "//VTK::Light::Impl", True, "//VTK::Light::Impl\n  gl_FragData[0] = vec4(0.9, 0.3 * gl_FragData[0].g, 0.4, 0.45);\n", False)
    stage.add(actor)


@kind("opaque and translucent parts in one actor", share_of_samples=0.98, why="where opacity reaches 1 is found once a pixel")
def mixed_opacity(stage):
    actor = mesh(wavy(), scalars=True)
    table = opacity_table()
    for i in range(16, 32):
        table.SetTableValue(i, 0.9, 0.8, 0.2, 1)
    actor.GetMapper().SetLookupTable(table)
    actor.GetMapper().UseLookupTableScalarRangeOn()
    actor.GetMapper().InterpolateScalarsBeforeMappingOn()
    stage.add(actor)


@kind("polygon offset and coincident topology", share_of_samples=0.9, why="lines are as wide in each of the four pictures as in one")
def coincident_topology(stage):
    data = apart(wavy(8))
    under = look(mesh(data), (0.4, 0.6, 0.8), 0.5)
    over = look(mesh(data), (1, 0.9, 0.2), 0.7)
    over.GetProperty().SetRepresentationToWireframe()
    over.GetProperty().SetLineWidth(3)
    for actor in (under, over):
        actor.GetMapper().SetResolveCoincidentTopologyToPolygonOffset()
    under.GetMapper().SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 1000)  # by more than a slab
    stage.add(under)
    stage.add(over)


@kind("deep: forty shells", share=0.998, known=0.9, why="80 fragments: several share a slab")
def deep(stage):
    for i in range(40):
        stage.add(sphere(0.1, (0.5 + 0.4 * math.sin(i), 0.5 + 0.4 * math.cos(2 * i), 0.5), (0.02 * i - 0.4, 0, 0),
                         0.3 + 0.01 * i, 24))


@kind("parallel projection")
def parallel_projection(stage):
    stage.add(sphere())
    stage.renderer.GetActiveCamera().ParallelProjectionOn()


@kind("textured background and gradient")
def gradient_background(stage):
    stage.add(sphere())
    stage.renderer.GradientBackgroundOn()
    stage.renderer.SetBackground2(0.9, 0.7, 0.5)


@kind("several lights, one of them in the scene")
def several_lights(stage):
    stage.add(sphere())
    for position, color in (((3, 1, 2), (1, 0.4, 0.4)), ((-2, 2, 1), (0.4, 0.4, 1))):
        light = vtk.vtkLight()
        light.SetPosition(position)
        light.SetColor(color)
        light.SetIntensity(0.7)
        stage.renderer.AddLight(light)


# ---------------------------------------------------------------------------------------------------------------------
# Renderers and windows.


@kind("layered renderers")
def layered_renderers(stage):
    stage.add(sphere())
    stage.window.SetNumberOfLayers(2)
    above = stage.add_renderer(layer=1)
    above.SetActiveCamera(stage.renderer.GetActiveCamera())
    stage.add(sphere(0.5, (0.9, 0.9, 0.2), (-0.2, 0.3, 0), 0.4), above)


@kind("several viewports")
def viewports(stage):
    stage.renderer.SetViewport(0, 0, 0.5, 0.8)
    stage.add(sphere())
    other = stage.add_renderer((0.5, 0.2, 1, 1))
    stage.add_renderer((0, 0.8, 0.5, 1))  # what no renderer clears is whatever it was
    stage.add_renderer((0.5, 0, 1, 0.2))
    other.SetActiveCamera(stage.renderer.GetActiveCamera())
    stage.companions(other)
    stage.add(sphere(0.4, (0.8, 0.2, 0.5)), other)


def stereo(name):
    def build(stage):
        stage.add(sphere())
        stage.window.StereoCapableWindowOn()
        getattr(stage.window, "SetStereoTypeTo" + name)()
        stage.window.StereoRenderOn()

    build.__name__ = "stereo_" + name.lower()
    kind("stereo: " + name)(build)


for _mode in ("RedBlue", "Anaglyph", "Interlaced", "Left", "Right", "Dresden", "Checkerboard", "SplitViewportHorizontal", "Fake",
              "Emulate"):
    stereo(_mode)


@kind("tiled display")
def tiled_display(stage):
    stage.add(sphere())
    stage.tiles = 2
    stage.window.SetTileScale(2, 2)
    stage.window.SetTileViewport(0.5, 0.25, 1, 0.75)


@kind("window resized while running")
def resized(stage):
    stage.add(sphere())

    def shoot():
        width, height = stage.window.GetSize()
        for size in ((width, height), (120, 90), (2 * width, height // 2), (width, height)):
            stage.window.SetSize(size)
            stage.window.Render()

    stage.shoot = shoot


@kind("on-screen window", may_fail=True)
def on_screen(stage):
    stage.add(sphere())
    stage.window.OffScreenRenderingOff()


@kind("window-to-image with scale 3")
def scale_3(stage):
    stage.add(sphere())
    stage.scale = 3


# ---------------------------------------------------------------------------------------------------------------------
# On top of the passes. The truth takes the same chain, with slabs in the place of the technique.


def chained(stage, wrap):
    stage.add(sphere())

    def arrange(renderer, steps):
        outer = wrap(renderer)
        outer.SetDelegatePass(steps)
        renderer.SetPass(outer)
        stage.keep.append(outer)

    stage.arrange = arrange


@kind("FXAA (vtkOpenGLFXAAPass)", share_of_samples=0, why="VTK's FXAA turns multi-sampled windows black, whatever draws in them", may_fail=True)
def fxaa(stage):
    chained(stage, lambda renderer: vtk.vtkOpenGLFXAAPass())


@kind("SSAA (vtkSSAAPass)")
def ssaa(stage):
    chained(stage, lambda renderer: vtk.vtkSSAAPass())


@kind("tone mapping (vtkToneMappingPass)", share_of_samples=0.98, why="the pass draws into a framebuffer of its own, of one sample")
def tone_mapping(stage):
    chained(stage, lambda renderer: vtk.vtkToneMappingPass())


def framebuffer(stage, depth_format):
    def wrap(renderer):
        outer = vtk.vtkFramebufferPass()
        outer.SetDepthFormat(depth_format)
        return outer

    chained(stage, wrap)


@kind("a depth buffer of 32 bits (vtkFramebufferPass)", share_of_samples=0.98, why="the pass draws into a framebuffer of its own, of one sample")
def depth_of_32_bits(stage):
    framebuffer(stage, vtk.vtkTextureObject.Fixed32)


@kind("a depth buffer of 32-bit floats (vtkFramebufferPass)", share_of_samples=0.98, why="the pass draws into a framebuffer of its own, of one sample")
def depth_of_floats(stage):
    framebuffer(stage, vtk.vtkTextureObject.Float32)


@kind("Gaussian blur (vtkGaussianBlurPass)")
def gaussian_blur(stage):
    chained(stage, lambda renderer: vtk.vtkGaussianBlurPass())


@kind("SSAO (vtkSSAOPass) of the opaque props", share_of_samples=0.99, why="the pass draws opaque props into a framebuffer of its own, of one sample",
      may_fail=True)
def ssao(stage):
    stage.add(sphere())

    def arrange(renderer, steps):
        occlusion = vtk.vtkSSAOPass()
        occlusion.SetRadius(0.3)
        occlusion.SetKernelSize(32)
        occlusion.SetDelegatePass(vtk.vtkOpaquePass())
        camera = vtk.vtkCameraPass()
        camera.SetDelegatePass(occlusion)
        steps.SetOpaquePass(occlusion)

    stage.arrange = arrange


@kind("gamma: frames in sRGB", may_fail=True)
def srgb(stage):
    stage.add(sphere())
    stage.window.SetUseSRGBColorSpace(True)


if __name__ == "__main__":
    print("\n".join(KINDS))
