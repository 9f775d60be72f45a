"""The examples' pictures, named on the command line: the same from C++ and from Python, and of three spheres that overlap."""

import sys
import unittest

from vtkmodules.vtkIOImage import vtkPNGReader


def read(name):
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def color(picture, x, y):
    return tuple(picture.GetScalarComponentAsFloat(x, y, 0, channel) for channel in range(3))


class TestExamples(unittest.TestCase):
    pictures = [read(name) for name in sys.argv[1:]]

    def test_same_in_both_languages(self):
        cxx, python = self.pictures
        self.assertEqual(cxx.GetDimensions(), (400, 300, 1))
        self.assertEqual(python.GetDimensions(), (400, 300, 1))
        different = [
            (x, y) for x in range(400) for y in range(300) if color(cxx, x, y) != color(python, x, y)
        ]
        self.assertEqual(different, [])

    def test_overlap_is_darker_than_each_sphere(self):
        for picture in self.pictures:
            background = sum(color(picture, 0, 0))
            red, green, blue = (sum(color(picture, x, y)) for x, y in ((140, 120), (260, 120), (200, 210)))
            overlap = sum(color(picture, 200, 130))
            self.assertEqual(background, 3 * 255)
            self.assertLess(max(red, green, blue), background)
            self.assertLess(overlap, min(red, green, blue))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
