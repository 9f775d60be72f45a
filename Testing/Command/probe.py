"""The tests of translucency probe."""

import json
import math
import struct

from checks import fails, files_in, succeeds

SIZE = ["--size", "40x30"]


def probe(*arguments):
    return ["probe", *arguments, *SIZE]


def probe_is_exact(scene, pixel, nearest, farthest):
    """The fragments are the trace's, at distances in this range. The exact visibility is theirs, and that of techniques which draw it."""

    def case(command, folder):
        techniques = ["exact", "peel", "adaptive:nodes=64"]
        succeeds(command, folder, ["trace", scene, *SIZE, "-o", "a.csv"])
        rows = [[float(cell) for cell in line.split(",")] for line in (folder / "a.csv").read_text().splitlines()[2:]]
        traced = sorted((row[3], row[7]) for row in rows if row[1:3] == list(pixel))
        succeeds(command, folder, probe(scene, "--pixel", *map(str, pixel), "--depths", "1500", "--techniques", ",".join(techniques),
                                        "-o", "out.json"))
        report = json.loads((folder / "out.json").read_text())
        fragments = report["fragments"]
        assert len(traced) > 3 and [fragment["opacity"] for fragment in fragments] == [round_trip(opacity) for _, opacity in traced]
        assert all(abs(fragment["depth"] - depth) < 1e-6 for fragment, (depth, _) in zip(fragments, traced))
        assert all(nearest < distance < farthest for distance in report["distances"]), report["distances"][::100]
        assert len(report["depths"]) > 1400 and report["depths"] == sorted(report["depths"]), len(report["depths"])
        assert {fragment["depth"] for fragment in fragments} <= set(report["depths"])
        for depth, visibility in zip(report["depths"], report["exact"]):
            expected = math.prod(1 - fragment["opacity"] for fragment in fragments if fragment["depth"] < depth)
            assert abs(visibility - expected) < 1e-6, (depth, visibility, expected)
        transmittance = math.prod(1 - opacity for _, opacity in traced)
        assert abs(fragments[-1]["transmittance"] - transmittance) < 1e-6
        for row in report["techniques"]:
            off = max(abs(a - b) for a, b in zip(row["visibility"], report["exact"]))
            assert off < 1e-4 and abs(row["largest_difference"] - off) < 1e-9, (row["technique"], off)
        assert [row["technique"] for row in report["techniques"]] == techniques

    return case


def round_trip(number):
    return struct.unpack("<f", struct.pack("<f", number))[0]


def probe_approximates(command, folder):
    """A function of few sums is near the exact one and falls, but for rounding; .csv has what .json has, and nothing is written without -o."""
    arguments = probe("scene:smoke", "--pixel", "20", "15", "--techniques", "wavelet:alpha_correction=off,blend,weighted,weighted:method=average")
    for name in ("a.json", "a.csv"):
        text = succeeds(command, folder, [*arguments, "-o", name])
    before = files_in(folder)
    assert succeeds(command, folder, arguments) == text and files_in(folder) == before
    report = json.loads((folder / "a.json").read_text())
    wavelet, blend, weighted, average = [row["visibility"] for row in report["techniques"]]
    assert all(later < earlier + 1e-3 for earlier, later in zip(wavelet, wavelet[1:]))
    assert 1e-3 < report["techniques"][0]["largest_difference"] < 0.2 and f"{len(report['fragments'])} fragments" in text, text
    assert all(abs(visibility - 1) < 1e-6 for visibility in blend)  # what is drawn last is not hidden
    assert weighted[0] > weighted[-1]
    # The mean of Bavoil and Myers, to which the probe itself adds next to nothing.
    opacities = [fragment["opacity"] for fragment in report["fragments"]] + [0]
    hidden = 1 - (1 - sum(opacities) / len(opacities)) ** len(opacities)
    assert all(abs(visibility - hidden / sum(opacities)) < 1e-3 for visibility in average), (average[0], hidden / sum(opacities))
    lines = (folder / "a.csv").read_text().splitlines()
    assert lines[0] == "depth,distance,exact," + ",".join(row["technique"] for row in report["techniques"])
    columns = [report["depths"], report["distances"], report["exact"], wavelet, blend, weighted, average]
    for line, *values in zip(lines[1:], *columns):
        assert all(abs(float(cell) - value) < 1e-6 for cell, value in zip(line.split(","), values)), line
    assert len(lines) == len(report["depths"]) + 1


def behind_opaque(command, folder):
    """A fragment of opacity 1 hides those behind it from a sum that knows of depth, and from no other."""
    succeeds(command, folder, probe("scene:rectangles:count=100", "--opacity", "1", "--pixel", "20", "15", "--techniques",
                                    "exact,additive,wavelet:alpha_correction=off", "-o", "out.json"))
    report = json.loads((folder / "out.json").read_text())
    assert len(report["fragments"]) > 3 and all(fragment["opacity"] == 1 for fragment in report["fragments"])
    assert report["exact"][0] == 1 and not any(report["exact"][1:])
    exact, additive, wavelet = [row["visibility"] for row in report["techniques"]]
    assert exact == report["exact"] and all(abs(visibility - 1) < 1e-6 for visibility in additive)
    assert wavelet[0] == 1 and 0 < wavelet[-1] < 1e-3, (wavelet[0], wavelet[-1])


def every_technique(command, folder):
    """All techniques have a visibility, which is a number."""
    succeeds(command, folder, probe("ok.vtp", "--pixel", "20", "15", "--depths", "1", "-o", "out.json"))
    names = [technique["name"] for technique in json.loads(succeeds(command, folder, ["list", "--json"]))["techniques"]]
    report = json.loads((folder / "out.json").read_text())
    assert [row["technique"] for row in report["techniques"]] == names
    for row in report["techniques"]:
        assert row["fallback"] is None and len(row["visibility"]) == len(report["depths"]), row
        assert all(0 <= visibility < 3 for visibility in row["visibility"]), row


CASES = {
    "ProbeParallel": probe_is_exact("scene:rectangles:count=100", (20, 15), 10, 11),
    "ProbePerspective": probe_is_exact("scene:smoke", (20, 15), 4, 6.02),
    "ProbeApproximates": probe_approximates,
    "ProbeBehindOpaque": behind_opaque,
    "ProbeEveryTechnique": every_technique,
    "BadProbePixel": fails(probe("ok.vtp", "--pixel", "40", "3"), r"pixel is 40 3, expected one of the picture, 0 0 to 39 29"),
    "BadProbePixelNegative": fails(probe("ok.vtp", "--pixel", "0", "-1"), r"pixel is 0 -1, expected one of the picture"),
    "BadProbePixelHalf": fails(["probe", "ok.vtp", "--pixel", "3"], r"--pixel: 2 required"),
    "BadProbeNoPixel": fails(probe("ok.vtp"), r"--pixel is required"),
    "BadProbeDepths": fails(probe("ok.vtp", "--pixel", "3", "3", "--depths", "-1"), r"--depths: is '-1', expected a number in 0\.\.100000"),
    "BadProbeEmpty": fails(probe("ok.vtp", "--pixel", "0", "0", "-o", "out.csv"), r"ok\.vtp: pixel 0 0 has no translucent fragments, expected at least one"),
    "BadProbeTechnique": fails(probe("ok.vtp", "--pixel", "3", "3", "--techniques", "wavlet"), r"no technique 'wavlet', expected one of: exact, adaptive"),
    "BadProbeSuffix": fails(probe("ok.vtp", "--pixel", "3", "3", "-o", "out.txt"), r"'out\.txt' has the suffix '\.txt', expected \.csv or \.json"),
    "BadProbeOutputFolder": fails(probe("ok.vtp", "--pixel", "3", "3", "-o", "gone/out.csv"), r"'gone/out\.csv' can't be written"),
    "BadProbeSamples": fails(probe("ok.vtp", "--samples", "4", "--pixel", "20", "15"), r"a pixel has 4 samples, expected 1"),
}
