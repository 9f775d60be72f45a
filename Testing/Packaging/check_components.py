#!/usr/bin/env python3
"""check_components.py CMAKE BUILD FOLDER COMPONENT...: each component installs what it should, and all together what a whole installation has.

FOLDER is emptied first. COMPONENTs are those that the build has: names from FILES, below.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

# By component, patterns of the paths below the prefix: each file is one of them, and each is there.
HEADERS = r"include/vtkTranslucency"
LIBRARY = r"lib\S*"
LOADED = LIBRARY + r"/vtkTranslucency"
PACKAGE = LIBRARY + r"/vtktranslucency"
FILES = {
    "runtime": [
        LIBRARY + r"/libvtkRenderingTranslucency\.so\.\d+\.\d+",
        LIBRARY + r"/libvtkRenderingTranslucency\.so\.\d+\.\d+\.\d+",
        r"share/licenses/vtkTranslucency/LICENSE",
    ],
    "development": [
        HEADERS + r"/vtkRenderingTranslucencyModule\.h",
        HEADERS + r"/Passes/vtkTranslucencyFactory\.h",
        HEADERS + r"/(Core|Passes|Storage|Study)/vtk\w+\.h",
        LIBRARY + r"/libvtkRenderingTranslucency\.so",
        LIBRARY + r"/cmake/vtkTranslucency/vtkTranslucency(Config|ConfigVersion|-targets|-targets-\w+|-vtk-module-properties)\.cmake",
        LIBRARY + r"/vtk/hierarchy/vtkTranslucency/vtkRenderingTranslucency-hierarchy\.txt",
    ],
    "python": [
        PACKAGE + r"/(__init__|_vtk|render_passes)\.py",
        PACKAGE + r"/py\.typed",
        PACKAGE + r"/vtkRenderingTranslucency\.\S+\.so",
    ],
    "command": [
        r"bin/translucency",
        LOADED + r"/libvtkTranslucencyPictures\.so",
        r"share/bash-completion/completions/translucency",
        r"share/man/man1/translucency\.1\.gz",
    ],
    "preload": [LOADED + r"/libvtkTranslucencyPreload\.so"],
    "drop-in": [
        LOADED + r"/[\d.]+/libvtkTranslucencyDropIn\.so",
        LOADED + r"/[\d.]+/libvtkRenderingTranslucency\.so\.[\d.]+",
    ],
    "paraview": [
        LIBRARY + r"/paraview-[\d.]+/plugins/Translucency/Translucency\.so",
        LIBRARY + r"/paraview-[\d.]+/plugins/Translucency/libvtkRenderingTranslucency\.so\.[\d.]+",
    ],
}
MAY_BE_THERE = {
    "development": [LIBRARY + r"/libvtkPVTranslucencyViewsCS\.a"],  # a part of the plugin, which ParaView's own CMake installs
    "python": [PACKAGE + r"/vtkRenderingTranslucency\.pyi"],  # where VTK has a generator of stubs
}


def install(cmake, build, prefix, *arguments):
    """The paths of what is installed, which are not folders, below the prefix."""
    subprocess.run([cmake, "--install", build, "--prefix", prefix, *arguments], check=True, stdout=subprocess.DEVNULL)
    return {os.path.relpath(os.path.join(folder, name), prefix) for folder, _, names in os.walk(prefix) for name in names}


def faults_of(component, paths):
    patterns = FILES[component]
    for path in sorted(paths):
        if not any(re.fullmatch(pattern, path) for pattern in patterns + MAY_BE_THERE.get(component, [])):
            yield f"the component {component} has {path}, expected one of: {', '.join(patterns)}"
    for pattern in patterns:
        if not any(re.fullmatch(pattern, path) for path in paths):
            yield f"the component {component} has nothing like {pattern}, expected it among: {', '.join(sorted(paths))}"


def main(cmake, build, folder, *components):
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    parts = {component: install(cmake, build, folder / component, "--component", component) for component in components}
    faults = [fault for component, paths in parts.items() for fault in faults_of(component, paths)]
    whole = install(cmake, build, folder / "whole")
    for path in sorted(whole.symmetric_difference(set().union(*parts.values()))):
        where = "a whole installation, but in no component" if path in whole else "a component, but not in a whole installation"
        faults.append(f"{path} is in {where}")
    sys.exit("\n".join(faults) or 0)


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
