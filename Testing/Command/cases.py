"""The tests of the command, by name. One line is one test."""

import functools
import json
import os
import pathlib

from checks import fails, png_size, read_page, run, succeeds, warns, writes_picture
from inputs import SUFFIXES

SMALL = ["--size", "40x30"]
DATA = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Data"
FROG = str(DATA / "frog.json")
CAROTID = str(DATA / "carotid.json")


def render(*arguments):
    return ["render", *arguments, *SMALL, "-o", "out.png"]


def compare(*arguments):
    return ["compare", "ok.vti", *SMALL, "--frames", "1", "--warmup", "0", *arguments]


def bench(*arguments):
    return ["bench", "ok.vtp", *SMALL, "--frames", "2", "--warmup", "0", *arguments]


def sized(size):
    return ["render", "ok.vtp", "--size", size, "-o", "out.png"]


# ---------------------------------------------------------------------------------------------------------------------
# What the command has to do.


def list_text(command, folder):
    text = succeeds(command, folder, ["list"])
    for expected in ["exact", "adaptive", "blend", "--nodes (1..64; default 16)", "--memory-limit"]:
        assert expected in text, expected


def list_json(command, folder):
    listed = json.loads(succeeds(command, folder, ["list", "--json"]))
    techniques = {technique["name"]: technique for technique in listed["techniques"]}
    assert listed["driver"] and {"exact", "adaptive", "blend"} <= techniques.keys()
    nodes = {option["keyword"]: option for option in techniques["adaptive"]["options"]}["nodes"]
    assert (nodes["flag"], nodes["minimum"], nodes["maximum"], nodes["default"]) == ("--nodes", 1, 64, "16")
    transmittances = {name: techniques[name]["transmittances"] for name in ("exact", "screendoor", "blend")}
    assert transmittances == {"exact": 3, "screendoor": 1, "blend": 0}, transmittances
    assert all(technique["help"] and isinstance(technique["runs"], bool) for technique in techniques.values())


def schema_is_json(command, folder):
    schema = json.loads(succeeds(command, folder, ["schema"], {**os.environ, "DISPLAY": ""}))
    assert schema["type"] == "object" and "actors" in schema["properties"]


def help_teaches(command, folder):
    for subcommand in [[], ["render"], ["compare"], ["bench"]]:
        text = succeeds(command, folder, [*subcommand, "--help"], {**os.environ, "DISPLAY": ""})
        assert "xample" in text or "Start with" in text, text


def every_technique(command, folder):
    """Each technique of the list draws the scene, and those that are exact draw the same."""
    names = [technique["name"] for technique in json.loads(succeeds(command, folder, ["list", "--json"]))["techniques"]]
    for name in names:
        succeeds(command, folder, ["render", "ok.vtp", *SMALL, "--technique", name, "-o", name + ".png"])
    assert (folder / "exact.png").read_bytes() == (folder / "adaptive.png").read_bytes()


def same_twice(command, folder):
    for name in ["a.png", "b.png"]:
        succeeds(command, folder, ["render", "ok.mhd", "ok.vtp", *SMALL, "--technique", "exact", "-o", name])
    assert (folder / "a.png").read_bytes() == (folder / "b.png").read_bytes()


def limit_changes_nothing(command, folder):
    arguments = ["render", "scene:rectangles:count=400", "--size", "200x150", "--technique", "exact"]
    succeeds(command, folder, [*arguments, "-o", "whole.png"])
    succeeds(command, folder, [*arguments, "--memory-limit", "1", "-o", "tiles.png"])
    assert (folder / "whole.png").read_bytes() == (folder / "tiles.png").read_bytes()


def options_change_picture(first, second):
    """Two ways to draw that have to differ."""

    def case(command, folder):
        for name, arguments in [("a.png", first), ("b.png", second)]:
            succeeds(command, folder, ["render", *arguments, *SMALL, "-o", name])
        assert (folder / "a.png").read_bytes() != (folder / "b.png").read_bytes()

    return case


def scene_sets_size(command, folder):
    succeeds(command, folder, ["render", "--scene", "scene.json", "-o", "scene.png"])
    assert png_size((folder / "scene.png").read_bytes()) == (48, 32)


def scene_from_elsewhere(command, folder):
    """Files are looked for beside the scene file, not where the command runs."""
    elsewhere = folder / "elsewhere"
    elsewhere.mkdir()
    succeeds(command, elsewhere, ["render", "--scene", "../scene.json", "-o", "scene.png"])


def tubes_scene(folder, file="flow.vti", **settings):
    """The scene of streamtubes, of another file and with other settings."""
    scene = json.loads((folder / "tubes.json").read_text())
    scene["actors"][0]["file"] = file
    scene["actors"][0]["streamtubes"].update(settings)
    (folder / "changed.json").write_text(json.dumps(scene))
    return ["--scene", "changed.json"]


def tubes_follow_settings(command, folder):
    """The same scene is the same picture; each setting changes it."""
    names = ["seeds", "speed", "length", "radius", "sides"]
    pictures = []
    for settings in [{}, {}, {"seeds": 4}, {"speed": 0.8}, {"length": 2}, {"radius": 0.8}, {"sides": 3}]:
        succeeds(command, folder, ["render", *tubes_scene(folder, **settings), "-o", "tubes.png"])
        pictures.append((folder / "tubes.png").read_bytes())
    assert pictures[0] == pictures[1]
    same = [name for name, picture in zip(names, pictures[2:]) if picture == pictures[0]]
    assert not same, same


def one_tube(file, speed, steps):
    """A seed has one tube from end to end, with caps there and not at the seed: of n sides, 2 n triangles a step and n - 2
    at each end."""

    def case(command, folder):
        sides = 6
        arguments = tubes_scene(folder, file, seeds=1, speed=speed, length=3, sides=sides)
        succeeds(command, folder, ["bench", *arguments, "--frames", "1", "--warmup", "0", "--techniques", "exact",
                                   "-o", "times.json"])
        triangles = json.loads((folder / "times.json").read_text())["triangles"]
        assert triangles == 2 * sides * steps + 2 * (sides - 2), triangles

    return case


def transmission_of_scene(command, folder):
    """That of an actor and that of a label each change the picture."""
    pictures = set()
    for change in (lambda actors: None, lambda actors: actors[0].update(transmission="tomato"),
                   lambda actors: actors[1]["labels"][0].update(transmission="tomato")):
        scene = json.loads((folder / "scene.json").read_text())
        change(scene["actors"])
        (folder / "changed.json").write_text(json.dumps(scene))
        succeeds(command, folder, ["render", "--scene", "changed.json", "--technique", "exact", "-o", "a.png"])
        pictures.add((folder / "a.png").read_bytes())
    assert len(pictures) == 3


ROW_KEYS = {
    "technique", "name", "options", "help", "milliseconds", "ratio_to_blend", "gather_milliseconds",
    "resolve_milliseconds", "fragments", "deepest_pixel", "mebibytes", "tiles", "geometry_passes", "screen_passes",
    "shader_builds", "transmittances", "chosen", "reason", "fallback"}
DIFFERENCE_KEYS = {"rmse", "psnr", "largest_difference", "picture", "difference_picture"}
REPORT_KEYS = {"kind", "title", "inputs", "size", "samples", "driver", "actors", "triangles", "frames", "warmup", "techniques"}


def check_row(row):
    times = row["milliseconds"]
    assert 0 < times["lower_quartile"] <= times["median"] <= times["upper_quartile"]
    assert row["ratio_to_blend"] > 0
    if row["name"] in ("exact", "adaptive"):
        assert row["fragments"] > 0 and row["deepest_pixel"] >= 2 and row["mebibytes"] > 0
        assert row["gather_milliseconds"] >= 0 and row["resolve_milliseconds"] >= 0


def compare_writes_all(command, folder):
    text = succeeds(command, folder, compare("--techniques", "exact,adaptive:nodes=1,vtk-oit", "-o", "new/folder"))
    out = folder / "new" / "folder"
    report = json.loads((out / "comparison.json").read_text())
    assert report.keys() == REPORT_KEYS | {"reference"} and report["reference"] == "exact"
    rows = {row["technique"]: row for row in report["techniques"]}
    assert list(rows) == ["exact", "adaptive:nodes=1", "vtk-oit", "blend"], list(rows)
    for row in rows.values():
        assert row.keys() == ROW_KEYS | DIFFERENCE_KEYS, row.keys()
        check_row(row)
        assert png_size((out / row["picture"]).read_bytes()) == (40, 30)
        assert (row["technique"] == "exact") == (row["difference_picture"] is None)
    assert rows["exact"]["rmse"] is None and rows["vtk-oit"]["rmse"] > 0
    assert rows["adaptive:nodes=1"]["options"] == {"nodes": "1"}
    table = (out / "table.txt").read_text()
    assert table in text and all(name in table for name in rows)
    assert read_page((out / "index.html").read_text()).pictures == 7
    assert len(list(out.iterdir())) == 7 + 3


def compare_keeps_other_files(command, folder):
    (folder / "old").mkdir()
    (folder / "old" / "notes.txt").write_text("mine")
    succeeds(command, folder, compare("--techniques", "adaptive", "-o", "old"))
    assert (folder / "old" / "notes.txt").read_text() == "mine"


def compare_identical(command, folder):
    """The reference against itself by another way has no difference, which JSON and page can say."""
    succeeds(command, folder, compare("--techniques", "exact:resolve=iterative,adaptive:nodes=64", "-o", "out"))
    report = json.loads((folder / "out" / "comparison.json").read_text())
    row = {row["technique"]: row for row in report["techniques"]}["adaptive:nodes=64"]
    assert row["rmse"] == 0 and row["psnr"] is None and row["largest_difference"] == 0, row


def compare_tells_what_auto_chose(command, folder):
    succeeds(command, folder, compare("--techniques", "exact,auto:budget_mebibytes=1", "-o", "out"))
    report = json.loads((folder / "out" / "comparison.json").read_text())
    rows = {row["name"]: row for row in report["techniques"]}
    assert rows["exact"]["chosen"] is None and rows["auto"]["chosen"] == "exact", rows["auto"]
    assert "memory budget of 1 MiB" in rows["auto"]["reason"], rows["auto"]["reason"]
    for name in ("table.txt", "index.html"):
        assert rows["auto"]["reason"] in (folder / "out" / name).read_text(), name


def bench_writes_json(command, folder):
    text = succeeds(command, folder, bench("--techniques", "exact,adaptive", "-o", "times.json"))
    report = json.loads((folder / "times.json").read_text())
    assert report.keys() == REPORT_KEYS, report.keys()
    assert [row["technique"] for row in report["techniques"]] == ["exact", "adaptive", "blend"]
    for row in report["techniques"]:
        assert row.keys() == ROW_KEYS, row.keys()
        assert len(row["milliseconds"]["frames"]) == 2
        check_row(row)
        assert row["shader_builds"] in (0, None)
        assert row["technique"] in text


def bench_prints_only(command, folder):
    before = set(folder.iterdir())
    assert "x blend" in succeeds(command, folder, bench("--techniques", "adaptive"))
    assert set(folder.iterdir()) == before


def without_display(command, folder):
    """Starts under Xvfb by itself, and passes its output and its exit code on."""
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    result = run(command, folder, render("ok.vtp"), environment)
    assert result.returncode == 0 and (folder / "out.png").exists(), result.stderr
    result = run(command, folder, render("gone.vtp"), environment)
    assert result.returncode == 1 and len(result.stderr.splitlines()) == 1, result.stderr


def fragments_of(scene, least, most):
    """A built-in scene has the fragments that the figures in reports are about."""

    def case(command, folder):
        succeeds(command, folder, ["bench", scene, "--size", "800x600", "--frames", "1", "--warmup", "0",
                                   "--techniques", "exact", "-o", "times.json"])
        fragments = json.loads((folder / "times.json").read_text())["techniques"][0]["fragments"]
        assert least <= fragments <= most, fragments

    return case


CASES = {
    "List": list_text,
    "ListJson": list_json,
    "Schema": schema_is_json,
    "Help": help_teaches,
    "RenderEveryTechnique": every_technique,
    "RenderSameTwice": same_twice,
    "RenderMemoryLimit": limit_changes_nothing,
    **{f"RenderFrom-{suffix}": writes_picture(["render", f"ok.{suffix}", *SMALL], "a.png", (40, 30)) for suffix in SUFFIXES},
    **{f"RenderTo-{suffix}": writes_picture(["render", "ok.vtp", *SMALL], f"a.{suffix}")
       for suffix in ["png", "exr", "tif", "tiff", "jpg", "jpeg", "PNG"]},
    "RenderStructuredGrid": writes_picture(["render", "grid.vtk", *SMALL], "a.png", (40, 30)),
    "RenderSeveral": writes_picture(["render", "ok.vtp", "ok.mhd", "scene:spheres:count=2", *SMALL], "a.png", (40, 30)),
    "RenderOnePixel": writes_picture(["render", "ok.vtp", "--size", "1x1"], "a.png", (1, 1)),
    "RenderScene": scene_sets_size,
    "RenderSceneElsewhere": scene_from_elsewhere,
    "RenderFrog": writes_picture(["render", "--scene", FROG, "--size", "160x90"], "a.png", (160, 90)),
    "RenderCarotid": writes_picture(["render", "--scene", CAROTID, "--size", "160x90"], "a.png", (160, 90)),
    "RenderStreamtubes": writes_picture(["render", "--scene", "tubes.json"], "a.png", (48, 32)),
    "StreamtubesSettings": tubes_follow_settings,
    # Steps are a quarter of a voxel's diagonal, sqrt(3) / 4. Three voxels each way are seven of them, the last one shorter.
    "StreamtubesWhole": one_tube("straight.vti", 0.2, steps=2 * 7),
    # The seed lies on the side where the flow enters, at speed 12; after one step it is 11.57, after two 11.13: below 0.95 of
    # the largest, and left out.
    "StreamtubesEndWhereSlow": one_tube("slowing.vti", 0.95, steps=1),
    "RenderOpacity": options_change_picture(["ok.vtp"], ["ok.vtp", "--opacity", "0.9"]),
    "RenderTransmission": options_change_picture(["ok.vtp"], ["ok.vtp", "--transmission", "tomato"]),
    "RenderTransmissionOfScene": transmission_of_scene,
    "RenderTransmissionOfVtk": warns(["render", "ok.vtp", "--transmission", "red", "--technique", "blend", "-o", "a.png"],
                                    "technique 'blend' draws without transmission colours"),
    "RenderColor": options_change_picture(["ok.vtp"], ["ok.vtp", "--color", "tomato"]),
    "RenderSamples": options_change_picture(["ok.vtp"], ["ok.vtp", "--samples", "4"]),
    "RenderBackground": options_change_picture(["ok.vtp"], ["ok.vtp", "--background", "#123"]),
    "RenderAzimuth": options_change_picture(["ok.vtu"], ["ok.vtu", "--azimuth", "30"]),
    "RenderElevation": options_change_picture(["ok.vtu"], ["ok.vtu", "--elevation", "30"]),
    "RenderZoom": options_change_picture(["ok.vtp"], ["ok.vtp", "--zoom", "0.5"]),
    "RenderNodes": options_change_picture(["ok.vti", "-t", "adaptive", "--nodes", "1"], ["ok.vti", "-t", "adaptive"]),
    "RenderIsovalues": options_change_picture(["ok.vti"], ["ok.vti", "--isovalues", "3,5"]),
    "RenderLevels": options_change_picture(["ok.vti"], ["ok.vti", "--levels", "2"]),
    "RenderSmooth": options_change_picture(["ok.mhd"], ["ok.mhd", "--smooth", "0"]),
    "RenderLabelsAsIsosurfaces": options_change_picture(["ok.mhd"], ["ok.mhd", "--volume", "isosurfaces"]),
    "Compare": compare_writes_all,
    "CompareKeepsOtherFiles": compare_keeps_other_files,
    "CompareIdentical": compare_identical,
    "CompareTellsWhatAutoChose": compare_tells_what_auto_chose,
    "Bench": bench_writes_json,
    "BenchPrintsOnly": bench_prints_only,
    "WithoutDisplay": without_display,
    "SceneSpheres": fragments_of("scene:spheres", 4.0e6, 4.4e6),
    "SceneRectangles": fragments_of("scene:rectangles", 3.6e6, 3.8e6),
}

# ---------------------------------------------------------------------------------------------------------------------
# What the command has to refuse. What stands behind the name: the arguments, and what the one line has to say.

CASES.update({
    "BadFileMissing": fails(render("gone.vtp"), r"gone\.vtp: there is no such file"),
    "BadFileFolder": fails(render("folder.vtp"), r"folder\.vtp: is not a file"),
    "BadFileSuffix": fails(render("scene.json"), r"scene\.json: has the suffix '\.json', expected one of \.vtp"),
    **{f"BadFileEmpty-{suffix}": fails(render(f"empty.{suffix}"), rf"empty\.{suffix}: is empty") for suffix in SUFFIXES},
    **{f"BadFileGarbage-{suffix}": fails(render(f"garbage.{suffix}"), rf"garbage\.{suffix}: ") for suffix in SUFFIXES},
    **{f"BadFileCut-{suffix}": fails(render(f"cut.{suffix}"), rf"cut\.{suffix}: ") for suffix in SUFFIXES},
    "BadFileCutGrid": fails(render("cutgrid.vtk"), r"cutgrid\.vtk: can't be read as \.vtk"),
    "BadFileCutVoxels": fails(render("cutraw.mhd"), r"cutraw\.mhd: can't be read as \.mhd: .*not read completely"),
    "BadFileNoVoxels": fails(render("noraw.mhd"), r"noraw\.mhd: can't be read as \.mhd"),
    "BadMeshWithoutCells": fails(render("nocells.vtp"), r"nocells\.vtp: has no cells, expected at least one"),
    "BadMeshWithoutPoints": fails(render("nopoints.vtp"), r"nopoints\.vtp: has no cells, expected at least one"),
    "BadMeshNan": fails(render("nan.ply"), r"nan\.ply: coordinate y of point 2 is nan, expected a finite number"),
    "BadMeshInfinite": fails(render("inf.ply"), r"inf\.ply: coordinate x of point 0 is inf, expected a finite number"),
    "BadMeshNanGlb": fails(render("nan.glb"), r"nan\.glb: coordinate z of point 5 is nan, expected a finite number"),
    "BadMeshWrongPoint": fails(render("wrongpoint.vtp"), r"wrongpoint\.vtp: a cell has point 99, expected 0 to 5"),
    "BadVolumeConstant": fails(render("constant.vti"), r"constant\.vti: has no surface to show, expected"),
    "BadVolumeNoLabels": fails(render("ok.vti", "--volume", "labels"), r"ok\.vti: is not a label volume, expected integer"),
    "BadVolumeIsovalue": fails(render("ok.vti", "--isovalues", "1e9"), r"ok\.vti: has no surface to show"),
    "BadOpacityLarge": fails(render("ok.vtp", "--opacity", "1.5"), r"--opacity.*'1\.5', expected a number in 0\.\.1"),
    "BadOpacityNegative": fails(render("ok.vtp", "--opacity", "-0.1"), r"--opacity.*'-0\.1', expected a number in 0\.\.1"),
    "BadTransmission": fails(render("ok.vtp", "--transmission", "#12"), r"--transmission is '#12', expected #rrggbb or"),
    "BadOpacityNan": fails(render("ok.vtp", "--opacity", "nan"), r"--opacity.*'nan', expected a number in 0\.\.1"),
    "BadColor": fails(render("ok.vtp", "--color", "reddish"), r"--color is 'reddish', expected #rrggbb or the name"),
    "BadBackground": fails(render("ok.vtp", "--background", "#12"), r"--background is '#12', expected #rrggbb"),
    "BadSamples": fails(render("ok.vtp", "--samples", "3"), r"--samples: 3 not in \{1,2,4,8\}"),
    "BadSizeZero": fails(sized("0x30"), r"--size.*'0x30', expected WIDTHxHEIGHT"),
    "BadSizeNegative": fails(sized("-4x30"), r"--size.*'-4x30', expected WIDTHxHEIGHT"),
    "BadSizeWord": fails(sized("large"), r"--size.*'large', expected WIDTHxHEIGHT"),
    "BadSizeAboveLimit": fails(sized("999999x2"), r"size is 999999x2, expected at most \d+x\d+"),
    "BadSizeHuge": fails(sized("99999999999x2"), r"--size.*'99999999999x2', expected WIDTHxHEIGHT"),
    "BadTechnique": fails(render("ok.vtp", "--technique", "magic"), r"no technique 'magic', expected one of: exact, adaptive"),
    "BadTechniqueInList": fails(compare("--techniques", "exact,magic", "-o", "out"), r"no technique 'magic', expected one of"),
    "BadTechniqueTwice": fails(compare("--techniques", "exact,exact", "-o", "out"), r"'exact' is named twice, expected once"),
    "BadReference": fails(compare("--reference", "truth", "-o", "out"), r"no technique 'truth', expected one of"),
    "BadNodesZero": fails(render("ok.vtp", "--nodes", "0"), r"nodes is '0', expected an integer in 1\.\.64"),
    "BadNodesMany": fails(render("ok.vtp", "--nodes", "1000"), r"nodes is '1000', expected an integer in 1\.\.64"),
    "BadNodesFraction": fails(render("ok.vtp", "--nodes", "2.5"), r"nodes is '2\.5', expected an integer in 1\.\.64"),
    "BadNodesInList": fails(compare("--techniques", "adaptive:nodes=0", "-o", "out"), r"nodes is '0', expected an integer"),
    "BadChoice": fails(render("ok.vtp", "--removal", "best"), r"removal is 'best', expected underestimate, overestimate or mixed"),
    "BadOptionOfOther": fails(render("ok.vtp", "-t", "exact", "--nodes", "8"), r"'exact' has no option 'nodes', expected one of"),
    "BadOptionOfNone": fails(render("ok.vtp", "-t", "blend", "--nodes", "8"), r"'blend' has no option 'nodes', expected none"),
    "BadOptionInList": fails(compare("--techniques", "adaptive:size=3", "-o", "out"), r"'adaptive' has no option 'size', expected one of: nodes"),
    "BadOptionForm": fails(compare("--techniques", "adaptive:nodes", "-o", "out"), r"'nodes' in 'adaptive:nodes' is not a setting, expected KEY=VALUE"),
    "BadMemoryLimitNegative": fails(render("ok.vtp", "--memory-limit", "-1"), r"memory_limit is '-1', expected a number in 0\.\."),
    "BadMemoryLimitTiny": fails(["render", "ok.vtp", "--size", "4000x2", "--memory-limit", "0.001", "-o", "out.png"], r"[Ll]imit.*row"),
    "BadMemoryLimitTinyInCompare": fails(["compare", "ok.vtp", "--size", "4000x2", "--techniques", "exact:memory_limit=0.001", "-o", "a/b"], r"[Ll]imit.*row"),
    "BadFlag": fails(render("ok.vtp", "--quality", "9"), r"--quality"),
    "BadNoInput": fails(render(), r"nothing to draw, expected an INPUT or --scene FILE"),
    "BadNoCommand": fails([], r"subcommand"),
    "BadNoOutput": fails(["render", "ok.vtp"], r"--output is required"),
    "BadOutputSuffix": fails(["render", "ok.vtp", "-o", "out.gif"], r"'out\.gif' has the suffix '\.gif', expected one of \.png"),
    "BadOutputNoSuffix": fails(["render", "ok.vtp", "-o", "out"], r"'out' has the suffix '', expected one of \.png"),
    "BadOutputFolder": fails(["render", "ok.vtp", *SMALL, "-o", "gone/out.png"], r"'gone/out\.png' can't be written: No such file"),
    "BadOutputBelowFile": fails(["render", "ok.vtp", *SMALL, "-o", "ok.stl/out.png"], r"'ok\.stl/out\.png' can't be written: Not a directory"),
    "BadOutputIsFolder": fails(["render", "ok.vtp", *SMALL, "-o", "folder.png"], r"'folder\.png' can't be written: it exists and is not a regular file"),
    "BadOutputOfCompare": fails(compare("-o", "ok.vtp"), r"folder 'ok\.vtp' can't be made"),
    "BadOutputOfCompareBelowFile": fails(compare("-o", "ok.vtp/a/b"), r"folder 'ok\.vtp(/a)?' can't be made"),
    "BadOutputOfBench": fails(bench("--techniques", "exact", "-o", "gone/times.json"), r"'gone/times\.json' can't be written"),
    "BadFrames": fails(bench("--frames", "0"), r"--frames.*'0', expected a number in 1\.\."),
    "BadBuiltInScene": fails(render("scene:cubes"), r"no scene 'scene:cubes', expected one of: scene:spheres"),
    "BadBuiltInSceneKey": fails(render("scene:spheres:depth=3"), r"'spheres' has no option 'depth', expected one of: count, seed"),
    "BadBuiltInSceneCount": fails(render("scene:spheres:count=0"), r"count is '0' in 'spheres:count=0', expected an integer in 1"),
    "BadDisplay": fails(render("ok.vtp"), r"display ':987' can't be opened, expected one, or the program xvfb-run", {"DISPLAY": ":987", "PATH": ""}),
})


def scene_fails(change, expected):
    """The command refuses the valid scene file with one thing changed."""

    def case(command, folder):
        scene = json.loads((folder / "scene.json").read_text())
        change(scene)
        (folder / "scene.json").write_text(json.dumps(scene))
        fails(["render", "--scene", "scene.json", "-o", "out.png"], expected)(command, folder)

    return case


def put(*path, value):
    """A change that sets what lies at a path."""

    def change(scene):
        *above, last = path
        functools.reduce(lambda place, key: place[key], above, scene)[last] = value

    return change


CASES.update({
    "BadSceneMissing": fails(["render", "--scene", "gone.json", "-o", "out.png"], r"gone\.json: can't be read, expected a scene file"),
    "BadSceneGarbage": fails(["render", "--scene", "garbage.ply", "-o", "out.png"], r"garbage\.ply: is not JSON: parse error at line 1"),
    "BadSceneCut": fails(["render", "--scene", "cut.json", "-o", "out.png"], r"cut\.json: is not JSON: parse error at line"),
    "BadSceneKey": scene_fails(put("lamps", value=1), r"scene\.json: at '': unknown key 'lamps', expected"),
    "BadSceneActorKey": scene_fails(put("actors", 0, "colour", value="red"), r"at '/actors/0': unknown key 'colour', expected an object with file, color"),
    "BadSceneLabelKey": scene_fails(put("actors", 1, "labels", 0, "label", value=2), r"at '/actors/1/labels/0': unknown key 'label', expected"),
    "BadSceneNoFile": scene_fails(lambda scene: scene["actors"][0].pop("file"), r"at '/actors/0': key 'file' is missing, expected"),
    "BadSceneNoActors": scene_fails(put("actors", value=[]), r"at '/actors': is \[\], expected an array of one or more actors"),
    "BadSceneOpacity": scene_fails(put("actors", 0, "opacity", value=1.5), r"at '/actors/0/opacity': is 1\.5, expected a number from 0"),
    "BadSceneOpacityText": scene_fails(put("actors", 0, "opacity", value="half"), r"at '/actors/0/opacity': is \"half\", expected a number"),
    "BadSceneTransmission": scene_fails(put("actors", 0, "transmission", value="reddish"), r"transmission is 'reddish', expected #rrggbb"),
    "BadSceneTransmissionNumber": scene_fails(put("actors", 0, "transmission", value=0.5), r"at '/actors/0/transmission': is 0\.5, expected a colour"),
    "BadSceneColor": scene_fails(put("actors", 0, "color", value="reddish"), r"scene\.json: color is 'reddish', expected #rrggbb"),
    "BadSceneSize": scene_fails(put("size", value=[0, 10]), r"at '/size/0': is 0, expected"),
    "BadSceneSizeAboveLimit": scene_fails(put("size", value=[10, 999999]), r"size is 10x999999, expected at most"),
    "BadSceneUp": scene_fails(put("camera", "up", value=[0, 0, 0]), r"at '/camera/up': is \[0,0,0\], expected an array of three numbers, not all 0"),
    "BadSceneLight": scene_fails(put("lights", 0, "type", value="sun"), r"at '/lights/0/type': is \"sun\", expected \"headlight\""),
    "BadSceneVolume": scene_fails(put("actors", 0, "volume", value="cloud"), r"at '/actors/0/volume': is \"cloud\", expected"),
    "BadSceneLabel": scene_fails(put("actors", 1, "labels", 0, "value", value=7), r"ok\.mhd: has no label 7, expected"),
    "BadSceneFileMissing": scene_fails(put("actors", 0, "file", value="gone.vtp"), r"gone\.vtp: there is no such file"),
})


def tubes_fail(expected, file="flow.vti", **settings):
    def case(command, folder):
        arguments = tubes_scene(folder, file, **settings)
        fails(["render", *arguments, "-o", "out.png"], expected)(command, folder)

    return case


CASES.update({
    "BadStreamtubesKey": tubes_fail(r"at '/actors/0/streamtubes': unknown key 'count', expected an object with seeds, speed", count=3),
    "BadStreamtubesSeeds": tubes_fail(r"at '/actors/0/streamtubes/seeds': is 0, expected an integer from 1", seeds=0),
    "BadStreamtubesSeedsFraction": tubes_fail(r"streamtubes/seeds': is 2\.5, expected an integer from 1", seeds=2.5),
    "BadStreamtubesSeedsMany": tubes_fail(r"streamtubes/seeds': is 10001, expected an integer from 1 to 10000", seeds=10001),
    "BadStreamtubesSpeed": tubes_fail(r"streamtubes/speed': is 1, expected a number from 0 to below 1", speed=1),
    "BadStreamtubesSpeedNegative": tubes_fail(r"streamtubes/speed': is -0\.1, expected a number from 0", speed=-0.1),
    "BadStreamtubesLength": tubes_fail(r"streamtubes/length': is 0, expected a number above 0", length=0),
    "BadStreamtubesRadius": tubes_fail(r"streamtubes/radius': is 0, expected a number above 0", radius=0),
    "BadStreamtubesRadiusText": tubes_fail(r"streamtubes/radius': is \"thin\", expected a number above 0", radius="thin"),
    "BadStreamtubesRadiusHuge": tubes_fail(r"flow\.vti, streamtubes: coordinate [xyz] of point \d+ is -?(inf|nan), expected", radius=1e300),
    "BadStreamtubesSides": tubes_fail(r"streamtubes/sides': is 2, expected an integer from 3 to 64", sides=2),
    "BadStreamtubesSidesMany": tubes_fail(r"streamtubes/sides': is 65, expected an integer from 3 to 64", sides=65),
    "BadStreamtubesScalars": tubes_fail(r"ok\.vti: has no vectors for streamtubes, expected a point array of three", "ok.vti"),
    "BadStreamtubesMaterials": tubes_fail(r"ok\.wrl: has no vectors for streamtubes, expected", "ok.wrl"),
    "BadStreamtubesStill": tubes_fail(r"still\.vti: has no streamline, expected vectors other than 0", "still.vti"),
    "BadStreamtubesSlice": tubes_fail(r"slice\.vti: is 12x12x1 points, expected a volume of at least 2x2x2", "slice.vti"),
    "BadStreamtubesLeaving": tubes_fail(r"leaving\.vti: has no streamline, expected vectors that stay inside the data", "leaving.vti"),
    "BadStreamtubesNan": tubes_fail(r"nan\.vti: the length of vector 1 is nan, expected a finite number", "nan.vti"),
    "BadStreamtubesInfinite": tubes_fail(r"huge\.vti: the length of vector 0 is inf, expected a finite number", "huge.vti"),
})
