"""Tests of `translucency run`, by name: programs as they are and under the drop-in, pictures and messages.

    run_drop_in.py --list
    run_drop_in.py COMMAND PRELOAD FOLDER CMAKE BUILD CASE    PRELOAD: the preloaded library; FOLDER: what this folder's CMakeLists.txt has
                                                              built; CMAKE: the command; BUILD: the build tree
"""

import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOImage import vtkPNGReader

HERE = pathlib.Path(__file__).parent
STATUS = 7  # of all programs
BACKGROUND = (51, 77, 102)


class Runner:
    def __init__(self, command, preload, built, install, folder, program=None):
        self.command = command
        self.preload = pathlib.Path(preload)
        self.built = pathlib.Path(built)
        self.install = install
        self.folder = folder
        self.program = program or [sys.executable, "-B", str(HERE / "peels.py")]

    def of(self, *program):
        """The same with another program than peels.py."""
        return Runner(self.command, self.preload, self.built, self.install, self.folder, list(program))

    def draw(self, how, before=(), environment=None):
        """The picture's bytes and what was said."""
        file = self.folder / "picture.png"
        file.unlink(missing_ok=True)
        done = subprocess.run([*before, *self.program, str(file), *how], capture_output=True, text=True, cwd=self.folder,
                              env={**os.environ, **(environment or {})})
        assert done.returncode == STATUS, f"status {done.returncode}, expected {STATUS}: {done.stderr}"
        reader = vtkPNGReader()
        reader.SetFileName(str(file))
        reader.Update()
        return bytes(memoryview(reader.GetOutput().GetPointData().GetScalars()).cast("B")), done.stderr + done.stdout

    def run(self, how, *options, environment=None):
        return self.draw(how, [self.command, "run", *options, "--"], environment)

    def package(self, **drop_ins):
        """A copy of the preloaded library, with drop-ins: the name of what was built by the release of VTK it is for, v1_2_3 for 1.2.3."""
        folder = self.folder / "package"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        name = self.preload.parent.joinpath(vtkVersion.GetVTKVersion(), "libvtkTranslucencyDropIn.so")
        for version, built in drop_ins.items():
            release = folder / version[1:].replace("_", ".")
            release.mkdir()
            shutil.copy(self.built / built if built else name, release / name.name)
        return shutil.copy(self.preload, folder)


def largest(a, b):
    assert len(a) == len(b)
    return max(abs(x - y) for x, y in zip(a, b))


def draws_as_peeling(runner, how):
    stock, said = runner.draw(how)
    assert not said, said
    drawn, said = runner.run(how, "--technique", "exact")
    assert not said, said
    assert 0 < largest(stock, drawn) <= 3, "as right as peeling, and not peeling itself"
    plain, _ = runner.run(how, "--technique", "blend")
    assert largest(stock, plain) > 20, "the technique that was asked for"


def use_depth_peeling(runner):
    draws_as_peeling(runner, ["renderer"])


def a_dual_pass_of_its_own(runner):
    draws_as_peeling(runner, ["dual"])


def a_single_pass_of_its_own(runner):
    draws_as_peeling(runner, ["single"])


def keeps_the_effect(runner, how, bound):
    """The technique's picture, which is within a bound of that by peeling."""
    stock, said = runner.draw(how)
    assert not said, said
    drawn, said = runner.run(how, "--technique", "exact")
    assert not said, f"{how}: {said}"
    assert 0 < largest(stock, drawn) <= bound, f"{how}: {largest(stock, drawn)}"
    return drawn


def effects_of_the_renderer(runner):
    """They are VTK's there: the technique stands where its peeling stands."""
    without, _ = runner.run(["renderer", "0", "UseDepthPeeling"], "--technique", "exact")
    for effect, bound in (("UseFXAA", 20), ("UseSSAO", 3), ("UseHiddenLineRemoval", 3)):
        drawn = keeps_the_effect(runner, ["renderer", "0", effect], bound)
        assert largest(without, drawn) > 20, f"{effect} is not seen"


def passes_around_its_own(runner):
    for effect, bound in (("vtkSSAAPass", 3), ("vtkEDLShading", 3), ("vtkToneMappingPass", 6)):
        keeps_the_effect(runner, ["dual", "0", effect], bound)
    # VTK's peeling warns there, and draws what its framebuffers happen to hold.
    for samples in ("0", "4"):
        drawn, said = runner.run(["dual", samples, "vtkSSAOPass"], "--technique", "exact")
        again, said_again = runner.run(["dual", samples, "vtkSSAOPass"], "--technique", "peel")
        assert not said and not said_again, said + said_again
        assert largest(drawn, again) <= 3, largest(drawn, again)


def volumes(runner):
    draws_as_peeling(runner, ["volumes"])


def every_technique_takes_volumes(runner):
    without, _ = runner.run(["renderer"])
    for technique in ("exact", "adaptive", "blend", "vtk-oit", "vtk-peel"):
        drawn, said = runner.run(["volumes"], "--technique", technique)
        if technique == "vtk-peel":  # VTK 9.6 prints what a driver's compiler remarks on VTK's own shader
            said = [line for line in said.splitlines() if line and "SOURCE_SHADER_COMPILER" not in line]
        assert not said and largest(without, drawn) > 20, f"{technique}: {said}"


def multi_sampled_windows(runner):
    whole, _ = runner.draw(["renderer"])
    empty = BACKGROUND * (len(whole) // 3)  # what VTK 9.1's peeling draws there
    drawn, said = runner.run(["renderer", "4"], "--technique", "exact")
    assert not said, said
    assert sum(abs(a - b) for a, b in zip(drawn, whole)) < 0.2 * sum(abs(a - b) for a, b in zip(empty, whole))


def options_reach_the_pass(runner):
    one, _ = runner.run(["renderer"], "--nodes", "1", "--removal", "overestimate")
    many, _ = runner.run(["renderer"])
    assert largest(one, many) > 3
    _, said = runner.run(["renderer"], "--memory-limit", "0.001")
    assert "MemoryLimit is 0.001 MiB" in said, said


def own_version():
    return "v" + vtkVersion.GetVTKVersion().replace(".", "_")


def one_package_for_several_releases(runner):
    """The program's VTK tells which drop-in is taken: the real one, or one that says so."""
    stock, _ = runner.draw(["renderer"])
    preload = runner.package(v1_2_3="libPretendedDropIn.so", **{own_version(): None})
    technique = {"TRANSLUCENCY_TECHNIQUE": '{"technique": "blend", "options": {}}'}
    drawn, said = runner.draw(["renderer"], environment={"LD_PRELOAD": preload, **technique})
    assert not said and largest(stock, drawn) > 20, said
    other = {"LD_PRELOAD": f"{preload}:{runner.built / 'libPretendedVersion.so'}", **technique}
    drawn, said = runner.draw(["renderer"], environment={**other, "PRETENDED_VTK_VERSION": "1.2.3"})
    assert (drawn, said) == (stock, "the pretended drop-in draws\n"), said


def refuses(runner, preload, expected, version=None):
    """Another drop-in, or none: the program's own picture and one sentence."""
    for how, always in (("renderer", {}), ("blending", {"TRANSLUCENCY_ALWAYS": "1"})):
        stock, _ = runner.draw([how])
        libraries = f"{preload}:{runner.built / 'libPretendedVersion.so'}" if version else preload
        drawn, said = runner.draw([how], environment={"LD_PRELOAD": str(libraries), "PRETENDED_VTK_VERSION": version or "", **always})
        assert stock == drawn
        assert said.count("\n") == 1 and expected in said and said.endswith("; it draws as it would have\n"), said


def a_release_is_added_to_a_package(runner):
    """The component is one folder that holds all that is needed, whichever place it is brought to."""
    preload = pathlib.Path(runner.package(v1_2_3="libPretendedDropIn.so"))
    subprocess.run([*runner.install, runner.folder / "installed"], check=True, capture_output=True)
    files = [file for file in (runner.folder / "installed").rglob("*") if not file.is_dir()]
    assert {file.parent.name for file in files} == {vtkVersion.GetVTKVersion()}, files
    shutil.move(files[0].parent, preload.parent)
    drop_in = preload.parent / vtkVersion.GetVTKVersion() / "libvtkTranslucencyDropIn.so"
    needed = subprocess.run(["ldd", drop_in], capture_output=True, text=True, check=True).stdout
    assert f"{drop_in.parent}/libvtkRenderingTranslucency.so" in needed and "not found" not in needed, needed
    stock, _ = runner.draw(["renderer"])
    drawn, said = runner.draw(["renderer"], environment={"LD_PRELOAD": str(preload)})
    assert not said and 0 < largest(stock, drawn) <= 6, said


def no_drop_in_for_a_release(runner):
    preload = runner.package(v1_2_3="libPretendedDropIn.so", **{own_version(): None})
    known = ", ".join(sorted(["1.2.3", vtkVersion.GetVTKVersion()]))
    refuses(runner, preload, f"it uses VTK 4.5.6, and the drop-ins in {pathlib.Path(preload).parent} are for {known}; ", "4.5.6")
    refuses(runner, runner.package(), f"it uses VTK {vtkVersion.GetVTKVersion()}, and the drop-ins in {runner.folder / 'package'} are for none; ")


def drop_ins_that_do_not_fit(runner):
    refuses(runner, runner.package(**{own_version(): "libOutdatedDropIn.so"}), "is of release 0.0.1, expected ")
    preload = runner.package(**{own_version(): "libPretendedDropIn.so"})
    next(pathlib.Path(preload).parent.glob("*/*.so")).write_text("not a library")
    refuses(runner, preload, "the drop-in can't be loaded: ")


def always_tells_of_renderers_out_of_reach(runner):
    preload = runner.package(**{own_version(): "libPretendedDropIn.so"})
    stock, _ = runner.draw(["blending"])
    drawn, said = runner.draw(["blending"], environment={"LD_PRELOAD": preload, "TRANSLUCENCY_ALWAYS": "1"})
    assert stock == drawn
    assert said.count("\n") == 1 and "its renderers can't be reached: --always finds its passes" in said, said


def never_asked(runner):
    stock, _ = runner.draw(["blending"])
    drawn, said = runner.run(["blending"])
    assert stock == drawn
    assert said.count("\n") == 1 and "it never asked for depth peeling" in said and "With --always" in said, said


def never_reached(runner):
    for options, code, expected in (
            (["--always"], "import vtkmodules.vtkRenderingOpenGL2", "no renderer or pass of VTK drew in it"),
            ([], "import ctypes; ctypes.CDLL('libGL.so.1')", "it draws by OpenGL, but has no library of VTK"),
            (["--always"], "import ctypes; ctypes.CDLL('libGL.so.1')", "it draws by OpenGL, but has no library of VTK")):
        done = subprocess.run([runner.command, "run", *options, "--", sys.executable, "-c", code], capture_output=True, text=True)
        assert done.returncode == 0 and done.stderr.count("\n") == 1 and expected in done.stderr, done


def always_draws_as_peeling(runner, how, peeling):
    """What would not be right by itself, and the same with peeling. Gives the picture."""
    stock, said = runner.draw(how)
    assert not said, said
    reference, said = runner.run(peeling, "--technique", "exact")
    assert not said, said
    drawn, said = runner.run(how, "--technique", "exact", "--always")
    assert not said, said
    assert largest(stock, reference) > 20, largest(stock, reference)
    assert largest(drawn, reference) <= 1, largest(drawn, reference)
    return drawn


def always_a_renderer(runner):
    drawn = always_draws_as_peeling(runner, ["blending"], ["renderer"])
    peeled, _ = runner.draw(["renderer"])
    assert 0 < largest(drawn, peeled) <= 3, largest(drawn, peeled)
    plain, _ = runner.run(["blending"], "--technique", "blend", "--always")
    assert largest(drawn, plain) > 20, "the technique that was asked for"


def always_where_peeling_is_switched_off(runner):
    always_draws_as_peeling(runner, ["switched-off"], ["renderer"])


def always_a_subclass_in_python(runner):
    always_draws_as_peeling(runner, ["subclass"], ["renderer"])


def always_in_cxx(runner):
    program = runner.of(str(runner.built / "blends"))
    for how in ("renderer", "viewer"):
        always_draws_as_peeling(program, [how], [how, "peeling"])


def always_multi_sampled(runner):
    always_draws_as_peeling(runner, ["blending", "4"], ["renderer", "4"])
    always_draws_as_peeling(runner, ["subclass", "8"], ["renderer", "8"])


def always_several_renderers(runner):
    always_draws_as_peeling(runner, ["layers-blending"], ["layers"])


def always_volumes(runner):
    """Among the surfaces, where the technique can; else where they are drawn without it."""
    always_draws_as_peeling(runner, ["volumes-blending"], ["volumes"])
    without, _ = runner.run(["blending"], "--always")
    projected, said = runner.run(["projected"], "--always")
    assert "vtkFixedPointVolumeRayCastMapper are drawn over the translucent surfaces" in said and largest(without, projected) > 20, said


def always_effects_of_the_renderer(runner):
    for effect in ("UseFXAA", "UseSSAO", "UseHiddenLineRemoval"):
        always_draws_as_peeling(runner, ["blending", "0", effect], ["renderer", "0", effect])


def always_passes(runner):
    """The step of a chain that would blend."""
    for how in ("steps", "default"):
        always_draws_as_peeling(runner, [how], ["dual"])
    for effect in ("vtkSSAAPass", "vtkEDLShading", "vtkToneMappingPass", "vtkSSAOPass"):
        always_draws_as_peeling(runner, ["steps", "0", effect], ["dual", "0", effect])


def always_leaves_what_was_asked_for(runner):
    """What asks for peeling gets the same without --always; a technique that the program has chosen stays."""
    for how in (["renderer"], ["dual"], ["single"], ["volumes"], ["renderer", "4"], ["renderer", "0", "UseSSAO"]):
        drawn, said = runner.run(how)
        always, said_always = runner.run(how, "--always")
        assert drawn == always and not said and not said_always, f"{how}: {said} {said_always}"
    stock, _ = runner.draw(["weighted"])
    drawn, said = runner.run(["weighted"], "--always")
    assert stock == drawn and not said, said


def always_selects(runner):
    stock, numbers = runner.draw(["selecting"])
    drawn, said = runner.run(["selecting"], "--technique", "exact", "--always")
    assert len(set(numbers.split())) > 1 and said == numbers, f"{numbers} {said}"
    assert largest(stock, drawn) > 20


def always_every_technique(runner):
    """Each is drawn by itself, whether the program has passes or not, and none calls itself."""
    said = subprocess.run([runner.command, "list", "--json"], capture_output=True, text=True, check=True).stdout
    names = [technique["name"] for technique in json.loads(said)["techniques"]]
    assert len(names) > 10, names
    for name in names:
        reference, _ = runner.run(["renderer"], "--technique", name)
        for how in ("blending", "steps"):
            drawn, said = runner.run([how], "--technique", name, "--always")
            assert not said, f"{name}, {how}: {said}"
            assert largest(drawn, reference) <= 1, f"{name}, {how}: {largest(drawn, reference)}"


def always_in_pyvista(runner):
    program = runner.of(sys.executable, "-B", str(HERE / "plots.py"))
    for how in ("one", "subplots"):
        always_draws_as_peeling(program, [how], [how, "peeling"])
    # Its effects are passes, which do not peel.
    stock, _ = program.draw(["shaded"])
    drawn, said = program.run(["shaded"], "--technique", "exact", "--always")
    plain, said_plain = program.run(["shaded"], "--technique", "blend", "--always")
    assert not said and not said_plain, said + said_plain
    assert largest(stock, plain) <= 1 and largest(stock, drawn) > 10, f"{largest(stock, plain)} {largest(stock, drawn)}"


def falls_back_to_peeling(runner):
    """The pass peels itself then, which the drop-in must not take from it."""
    stock, _ = runner.draw(["single"])
    drawn, said = runner.run(["renderer"], environment={"MESA_EXTENSION_OVERRIDE": "-GL_ARB_shader_storage_buffer_object"})
    assert "drawing by depth peeling instead" in said, said
    assert largest(stock, drawn) <= 3, largest(stock, drawn)
    lacking = {"MESA_EXTENSION_OVERRIDE": "-GL_ARB_shader_storage_buffer_object -GL_ARB_explicit_attrib_location"}
    drawn, said = runner.run(["renderer"], environment=lacking)
    assert "drawing by VTK's depth peeling instead" in said, said
    assert stock == drawn


def fails(runner, words, expected):
    done = subprocess.run([runner.command, "run", *words], capture_output=True, text=True)
    assert done.returncode != 0 and not done.stdout, done
    assert done.stderr.count("\n") == 1 and expected in done.stderr, done.stderr


def bad_command_lines(runner):
    fails(runner, [], "PROGRAM is required")
    fails(runner, ["--", "/no/such/program"], "'/no/such/program' can't be run: No such file or directory")
    fails(runner, ["--technique", "nope", "--", "true"], "there is no technique 'nope'")
    fails(runner, ["--nodes", "0", "--", "true"], "nodes is '0', expected an integer in 1..64")
    fails(runner, ["ls", "-l"], "translucency run [OPTIONS] -- PROGRAM [ARGUMENTS]")


def programs_without_vtk(runner):
    done = subprocess.run([runner.command, "run", "-t", "exact", "--", "sh", "-c", "echo $0; exit 3", "word"], capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (3, "word\n", ""), done


CASES = {case.__name__: case for case in (
    use_depth_peeling, a_dual_pass_of_its_own, a_single_pass_of_its_own, effects_of_the_renderer,
    passes_around_its_own, volumes, every_technique_takes_volumes, multi_sampled_windows,
    options_reach_the_pass, one_package_for_several_releases, a_release_is_added_to_a_package, no_drop_in_for_a_release, drop_ins_that_do_not_fit,
    never_asked, never_reached, falls_back_to_peeling, bad_command_lines, programs_without_vtk,
    always_a_renderer, always_where_peeling_is_switched_off, always_a_subclass_in_python, always_in_cxx,
    always_multi_sampled, always_several_renderers, always_volumes, always_effects_of_the_renderer, always_passes,
    always_leaves_what_was_asked_for, always_selects, always_every_technique, always_tells_of_renderers_out_of_reach)}
if importlib.util.find_spec("pyvista"):
    CASES["always_in_pyvista"] = always_in_pyvista


def main():
    if sys.argv[1:] == ["--list"]:
        print("\n".join(CASES))
        return
    command, preload, built, cmake, build, case = sys.argv[1:]
    install = [cmake, "--install", build, "--component", "drop-in", "--prefix"]
    with tempfile.TemporaryDirectory() as folder:
        CASES[case](Runner(command, preload, built, install, pathlib.Path(folder)))


if __name__ == "__main__":
    main()
