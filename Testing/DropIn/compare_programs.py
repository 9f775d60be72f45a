"""Runs VTK's own test programs, unmodified, as they are and under `translucency run`, and puts their pictures side by side.

    compare_programs.py --command TRANSLUCENCY --vtk-source VTK FOLDER

VTK is an unpacked source tree of the release that the command was built with. FOLDER/index.html shows the pictures of each program: its
own, that of the technique, and their difference; FOLDER/table.txt has the figures. A display is needed.
"""

import argparse
import pathlib
import subprocess
import sys

from pictures import difference, page, read

# Those that ask for depth peeling, draw without the data that VTK's tests download, and end by themselves.
PROGRAMS = [
    "Rendering/Core/Testing/Cxx/TestOpacity.cxx",
    "Rendering/Core/Testing/Cxx/TestTranslucentLUTDepthPeeling.cxx",
    "Rendering/Core/Testing/Cxx/TestTranslucentLUTTextureDepthPeeling.cxx",
    "Rendering/FreeType/Testing/Cxx/TestTextActor3DDepthPeeling.cxx",
    "Rendering/OpenGL2/Testing/Cxx/TestBlockOpacity.cxx",
    "Rendering/OpenGL2/Testing/Cxx/TestGaussianBlurPass.cxx",
    "Rendering/VolumeOpenGL2/Testing/Cxx/TestGPURayCastDepthPeelingBlendModes.cxx",
]

PROJECT = """cmake_minimum_required(VERSION 3.19)
project(Programs C CXX)
find_package(VTK {version} REQUIRED COMPONENTS {components})
foreach (test IN ITEMS {tests})
  get_filename_component(name "${{test}}" NAME_WE)
  file(WRITE "${{CMAKE_BINARY_DIR}}/${{name}}Main.cxx"
    "int ${{name}}(int, char**);\\nint main(int count, char** words) {{ return ${{name}}(count, words); }}\\n")
  add_executable(${{name}} "${{test}}" "${{CMAKE_BINARY_DIR}}/${{name}}Main.cxx")
  target_link_libraries(${{name}} PRIVATE ${{VTK_LIBRARIES}})
  vtk_module_autoinit(TARGETS ${{name}} MODULES ${{VTK_LIBRARIES}})
endforeach ()
"""
COMPONENTS = ["CommonColor", "CommonCore", "CommonDataModel", "CommonExecutionModel", "CommonSystem", "FiltersCore", "FiltersExtraction",
              "FiltersGeneral", "FiltersGeometry", "FiltersModeling", "FiltersSources", "ImagingCore", "ImagingGeneral", "ImagingSources",
              "InteractionStyle", "InteractionWidgets", "IOImage", "IOPLY", "IOXML", "RenderingContextOpenGL2", "RenderingCore",
              "RenderingFreeType", "RenderingOpenGL2", "RenderingVolume", "RenderingVolumeOpenGL2", "TestingCore", "TestingRendering"]


def build(source, folder, version):
    folder.mkdir(parents=True, exist_ok=True)
    tests = [source / program for program in PROGRAMS]
    (folder / "CMakeLists.txt").write_text(PROJECT.format(
        version=version, components=" ".join(COMPONENTS), tests=" ".join(f'"{test}"' for test in tests)))
    subprocess.run(["cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"], check=True)
    subprocess.run(["cmake", "--build", folder / "build"], check=True)
    return folder / "build"


def draw(program, binaries, folder, before):
    """Runs a program and gives the picture that VTK's test harness writes where it finds no baseline, and what was said."""
    folder.mkdir(parents=True, exist_ok=True)
    name = pathlib.Path(program).stem
    baseline = folder / f"{name}.png"
    baseline.unlink(missing_ok=True)  # else it would be compared with
    words = [*before, binaries / name, "-T", folder, "-V", baseline]
    try:
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=60, cwd=folder)
    except subprocess.TimeoutExpired:
        return None, ["it did not end within 60 s"]
    said = [line for line in done.stderr.splitlines() if line.startswith("translucency run:") or "ERR|" in line or "WARN|" in line]
    return (baseline if baseline.exists() else None), said


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", type=pathlib.Path, required=True, help="the built translucency")
    parser.add_argument("--vtk-source", type=pathlib.Path, required=True)
    parser.add_argument("--technique", default="exact")
    parser.add_argument("folder", type=pathlib.Path)
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    source = arguments.vtk_source.resolve()
    binaries = build(source, folder / "programs", "9.1")
    rows = []
    for number, program in enumerate(PROGRAMS):
        name = pathlib.Path(program).stem
        print(f"[{number + 1}/{len(PROGRAMS)}] {program}", file=sys.stderr)
        run = [arguments.command.resolve(), "run", "--technique", arguments.technique, "--"]
        stock, _ = draw(program, binaries, folder / "stock", [])
        drawn, said = draw(program, binaries, folder / "drawn", run)
        if not stock or not drawn:
            rows.append((name, "no picture" + (" of its own" if not stock else ""), said))
            continue
        share, largest = difference(read(stock), read(drawn), folder / f"{name}-difference.png")
        rows.append((name, f"{share:8.3%} within 3/255, largest {largest}", said))
    table = "\n".join(f"{name:42} {what}" + "".join(f"\n    {line}" for line in said) for name, what, said in rows)
    (folder / "table.txt").write_text(table + "\n")
    page(folder / "index.html", f"VTK's programs by {arguments.technique}", ("as it is", f"by {arguments.technique}", "difference times 8"),
         [(name, " ".join([what, *said]), (f"stock/{name}.png", f"drawn/{name}.png", f"{name}-difference.png")) for name, what, said in rows])
    print(table)
    return 0


if __name__ == "__main__":
    sys.exit(main())
