"""Pictures of programs, read, compared and put on a page."""

import html

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter


def read(file):
    """Rows of pixels of red, green and blue, the lowest row first."""
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[..., :3]


def write(file, pixels):
    height, width, channels = pixels.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, channels), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(image)
    writer.Write()


def difference(a, b, file=None):
    """The share of pixels within 3/255 and the largest difference; writes the absolute difference times 8 if there is a file for it."""
    if a.shape != b.shape:
        raise ValueError(f"the pictures are of the shapes {a.shape} and {b.shape}, expected the same")
    differences = numpy.abs(a.astype(int) - b)
    if file:
        write(file, numpy.minimum(8 * differences, 255).astype(numpy.uint8))
    pixels = differences.max(axis=2)
    return (pixels <= 3).mean(), pixels.max()


def montage(file, rows):
    """Pictures of one size, of even numbers of pixels, in rows; each in half its size."""
    def half(picture):
        height, width, channels = picture.shape
        return picture.reshape(height // 2, 2, width // 2, 2, channels).mean(axis=(1, 3)).astype(numpy.uint8)

    write(file, numpy.concatenate([numpy.concatenate([half(picture) for picture in row], axis=1) for row in reversed(rows)]))


def page(file, title, columns, rows):
    """Rows are a name, what there is to say of it, and a file beside the page, or None, for each of the columns."""
    head = "".join(f"<th>{html.escape(column)}" for column in columns)
    body = "".join(f"<tr><th>{html.escape(name)}" + "".join(f"<td><img src='{picture}'>" if picture else "<td>" for picture in pictures)
                   + f"<td>{html.escape(text)}" for name, text, pictures in rows)
    file.write_text(f"<!doctype html><meta charset=utf-8><title>{html.escape(title)}</title><h1>{html.escape(title)}</h1>"
                    f"<table><tr><th>{head}<th>{body}</table>\n")
