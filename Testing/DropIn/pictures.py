"""Pictures of programs, read, compared and put on a page."""

import html

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGReader, vtkPNGWriter


def read(file):
    """Rows of pixels of red, green and blue, the lowest row first."""
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[..., :3]


def to_image(pixels):
    height, width, channels = pixels.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, channels), deep=True))
    return image


def write(file, pixels):
    writer = vtkPNGWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(to_image(pixels))
    writer.Write()


def write_small(file, pixels):
    """As JPEG, as good as it gets in 60 kB."""
    writer = vtkJPEGWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(to_image(pixels))
    for quality in range(90, 0, -5):
        writer.SetQuality(quality)
        writer.Write()
        if file.stat().st_size < 60_000:
            return


def difference(a, b, file=None):
    """The share of pixels within 3/255 and the largest difference; writes the absolute difference times 8 if there is a file for it."""
    if a.shape != b.shape:
        raise ValueError(f"the pictures are of the shapes {a.shape} and {b.shape}, expected the same")
    differences = numpy.abs(a.astype(int) - b)
    if file:
        write(file, numpy.minimum(8 * differences, 255).astype(numpy.uint8))
    pixels = differences.max(axis=2)
    return (pixels <= 3).mean(), pixels.max()


def join(rows, scale=1):
    """Pictures of one size in rows, the first one above; each of them shrunk by a whole number. An incomplete row is filled with white."""
    def shrink(picture):
        height, width, channels = picture.shape
        return picture.reshape(height // scale, scale, width // scale, scale, channels).mean(axis=(1, 3)).astype(numpy.uint8)

    longest = max(map(len, rows))
    white = numpy.full_like(rows[0][0], 255)
    filled = [[*row, *[white] * (longest - len(row))] for row in rows]
    return numpy.concatenate([numpy.concatenate([shrink(picture) for picture in row], axis=1) for row in reversed(filled)])


def page(file, title, columns, rows):
    """Rows are a name, what there is to say of it, and a file beside the page, or None, for each of the columns."""
    head = "".join(f"<th>{html.escape(column)}" for column in columns)
    body = "".join(f"<tr><th>{html.escape(name)}" + "".join(f"<td><img src='{picture}'>" if picture else "<td>" for picture in pictures)
                   + f"<td>{html.escape(text)}" for name, text, pictures in rows)
    file.write_text(f"<!doctype html><meta charset=utf-8><title>{html.escape(title)}</title><h1>{html.escape(title)}</h1>"
                    f"<table><tr><th>{head}<th>{body}</table>\n")
