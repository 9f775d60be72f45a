"""Tests of `translucency run`, by name: peels.py as it is and under the drop-in, pictures and messages.

    run_drop_in.py --list
    run_drop_in.py COMMAND OTHER_VERSION CASE    OTHER_VERSION: the preloaded library, made to expect another release of VTK
"""

import os
import pathlib
import subprocess
import sys
import tempfile

from vtkmodules.vtkIOImage import vtkPNGReader

PROGRAM = [sys.executable, "-B", str(pathlib.Path(__file__).with_name("peels.py"))]
STATUS = 7  # of peels.py


class Runner:
    def __init__(self, command, other_version, folder):
        self.command = command
        self.other_version = other_version
        self.folder = folder

    def draw(self, how, before=(), environment=None):
        """The picture's bytes and what was said."""
        file = self.folder / "picture.png"
        file.unlink(missing_ok=True)
        done = subprocess.run([*before, *PROGRAM, str(file), *how], capture_output=True, text=True, cwd=self.folder,
                              env={**os.environ, **(environment or {})})
        assert done.returncode == STATUS, f"status {done.returncode}, expected {STATUS}: {done.stderr}"
        reader = vtkPNGReader()
        reader.SetFileName(str(file))
        reader.Update()
        return bytes(memoryview(reader.GetOutput().GetPointData().GetScalars()).cast("B")), done.stderr

    def run(self, how, *options, environment=None):
        return self.draw(how, [self.command, "run", *options, "--"], environment)


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
        assert not said and largest(without, drawn) > 20, f"{technique}: {said}"


def multi_sampled_windows(runner):
    whole, _ = runner.draw(["renderer"])
    empty = (51, 77, 102) * (len(whole) // 3)  # what VTK 9.1's peeling draws there
    drawn, said = runner.run(["renderer", "4"], "--technique", "exact")
    assert not said, said
    assert sum(abs(a - b) for a, b in zip(drawn, whole)) < 0.2 * sum(abs(a - b) for a, b in zip(empty, whole))


def options_reach_the_pass(runner):
    one, _ = runner.run(["renderer"], "--nodes", "1", "--removal", "overestimate")
    many, _ = runner.run(["renderer"])
    assert largest(one, many) > 3
    _, said = runner.run(["renderer"], "--memory-limit", "0.001")
    assert "MemoryLimit is 0.001 MiB" in said, said


def another_version(runner):
    stock, _ = runner.draw(["renderer"])
    drawn, said = runner.draw(["renderer"], environment={"LD_PRELOAD": runner.other_version})
    assert stock == drawn
    assert said.count("\n") == 1 and "it uses VTK 9." in said and "expected 1.2.3; it draws by its own depth peeling" in said, said


def never_asked(runner):
    stock, _ = runner.draw(["blending"])
    drawn, said = runner.run(["blending"])
    assert stock == drawn
    assert said.count("\n") == 1 and "it never asked for depth peeling" in said, said


def falls_back_to_peeling(runner):
    """The pass peels itself then, which the drop-in must not take from it."""
    stock, _ = runner.draw(["single"])
    drawn, said = runner.run(["renderer"], environment={"MESA_EXTENSION_OVERRIDE": "-GL_ARB_shader_storage_buffer_object"})
    assert "drawing by depth peeling instead" in said, said
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
    options_reach_the_pass, another_version, never_asked, falls_back_to_peeling, bad_command_lines, programs_without_vtk)}


def main():
    if sys.argv[1:] == ["--list"]:
        print("\n".join(CASES))
        return
    command, other_version, case = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        CASES[case](Runner(command, other_version, pathlib.Path(folder)))


if __name__ == "__main__":
    main()
