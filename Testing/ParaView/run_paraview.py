#!/usr/bin/env python3
"""run_paraview.py BIN PLUGIN PACKAGES FOLDER CASE: ParaView's programs of the folder BIN, with the plugin and without.

--list prints the cases. PACKAGES is the folder of the Python package vtktranslucency, or '-' if it is not built: then there is one case
less. Each case has a folder of its own in FOLDER.
"""
import os
import pathlib
import re
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).parent
SECONDS = 200  # for one program; what hangs is ended then


class Failure(Exception):
    pass


class Programs:
    def __init__(self, programs, plugin, packages, folder):
        self.programs, self.plugin, self.folder = pathlib.Path(programs), plugin, pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.environment = dict(
            os.environ,
            HOME=str(self.folder),  # ParaView's settings
            OMPI_ALLOW_RUN_AS_ROOT="1",
            OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
            PYTHONPATH=os.pathsep.join(filter(None, [packages, os.environ.get("PYTHONPATH")])),
        )

    def run(self, case, plugin="this", program=("pvpython",), url=(), says=()):
        """Runs a case of scenes.py, which has to pass and to say something by each of the patterns."""
        plugin = {"this": self.plugin, "none": "-"}.get(plugin, plugin)
        command = [*self.find(program), str(HERE / "run_scene.py"), case, plugin, str(self.folder), *url]
        text = self.start(command)
        if "PASSED" not in text:
            raise Failure(f"{' '.join(command)} did not pass:\n{text}")
        for pattern in says:
            if not re.search(pattern, text):
                raise Failure(f"{' '.join(command)} did not say {pattern!r}:\n{text}")
        return text

    def run_on_ranks(self, number, case, *options, **arguments):
        program = ("mpiexec", "--oversubscribe", "-n", str(number), "pvbatch", *options)
        return self.run(case, program=program if number > 1 else ("pvbatch", *options), **arguments)

    def run_with_server(self, case, plugin, says=(), ranks=1):
        mpi = ["mpiexec", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
        with subprocess.Popen([*mpi, str(self.programs / "pvserver"), "--server-port=0"], env=self.environment, text=True,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as server:
            try:
                for line in server.stdout:
                    found = re.search(r"Accepting connection\(s\): .*:(\d+)", line)
                    if found:
                        break
                else:
                    raise Failure("pvserver did not say where it listens")
                return self.run(case, plugin=plugin, url=[f"127.0.0.1:{found[1]}"], says=says)
            finally:
                server.terminate()  # mpiexec ends its ranks then

    def find(self, program):
        return [str(self.programs / word) if word in ("pvpython", "pvbatch") else word for word in program]

    def start(self, command):
        try:
            done = subprocess.run(command, env=self.environment, cwd=self.folder, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT, text=True, errors="replace", timeout=SECONDS)
        except subprocess.TimeoutExpired as error:
            raise Failure(f"{' '.join(command)} hangs:\n{(error.stdout or b'').decode(errors='replace')}") from None
        if done.returncode != 0:
            raise Failure(f"{' '.join(command)} ended with {done.returncode}:\n{done.stdout}")
        return done.stdout


def run_techniques(programs):
    programs.run("stock", plugin="none")
    programs.run("techniques")


def run_options(programs):
    programs.run("options")


def run_statistics(programs):
    programs.run("statistics")


def run_bad_values(programs):
    programs.run("bad_values", says=[
        "TranslucencyTechnique is 'exakt', expected one of: None, exact, .*draws by 'exact' as before",
        r"nodes is '1000', expected an integer in 1\.\.64",
        "storage is 'heap', expected linked-list, ",
        r"the server's plugin Translucency is of release 9\.9, and this one is .*load the same release",
    ])


def run_by_name(programs):
    """Where ParaView is told of the file that is installed beside the plugin's folder."""
    programs.environment["PV_PLUGIN_CONFIG_FILE"] = str(pathlib.Path(programs.plugin).parents[1] / "translucency.plugins.xml")
    programs.run("by_name", plugin="none")


def run_samples(programs):
    for number in (1, 2):
        programs.run_on_ranks(number, "samples", says=["TranslucencySamples is 9, expected 1 to 8; the view draws with 4 as before"])


def run_effects(programs):
    programs.run("effects")


def run_selection(programs):
    programs.run("selection")


def run_screenshots(programs):
    programs.run("screenshots")


def run_ranks(programs):
    for number in (1, 2, 4):
        programs.run_on_ranks(number, "ranks")


def run_ranks_round(programs):
    for number in (1, 2, 4):
        programs.run_on_ranks(number, "ranks_round")


def run_ranks_effects(programs):
    for number in (1, 2):
        programs.run_on_ranks(number, "ranks_effects", plugin="none")
        programs.run_on_ranks(number, "ranks_effects")


def run_ranks_differ(programs):
    text = programs.run_on_ranks(2, "ranks_differ", "--symmetric", says=[
        r"ranks draw by different techniques.*\(rank by rank: mlab, additive\).*set TranslucencyTechnique", "went on"])
    if text.count("ranks draw by different") != 1:
        raise Failure(f"expected to be told once:\n{text}")


def run_enable(programs):
    for plugin in ("none", "this"):
        programs.run("enable", plugin=plugin)
        programs.run_on_ranks(2, "enable_on_ranks", plugin=plugin,
            says=["refused: the renderer's pass .*load the plugin Translucency and set TranslucencyTechnique"])


def run_states(programs):
    programs.run("stock", plugin="none")
    programs.run("save_state")
    programs.run("save_state", plugin="none")
    programs.run("load_with")
    programs.run("load_with", plugin="none", says=["group[=:] ?translucency.*PluginTranslucency"])
    programs.run("load_without")


def run_server(programs):
    programs.run("stock", plugin="none")
    programs.run_with_server("remote_both", f"both={programs.plugin}")
    programs.run_with_server("remote_ranks", f"both={programs.plugin}", ranks=2)
    programs.run_with_server("remote_client_only", programs.plugin, says=["plugin Translucency.*its server has not loaded: load it there"])
    programs.run_with_server("remote_server_only", f"server={programs.plugin}", says=["Failed to instantiate vtkSITranslucency"])


def run_gui(programs):
    """paraview goes on after its script: it is ended once that has written what it found."""
    result = programs.folder / "gui.txt"
    result.unlink(missing_ok=True)
    settings = programs.folder / ".config" / "ParaView" / "ParaView.ini"  # 6.1 welcomes by a window that scripts wait for
    settings.parent.mkdir(parents=True, exist_ok=True)
    settings.write_text("[General]\nGeneralSettings.ShowWelcomeDialog=false\n")
    script = programs.folder / "gui.py"
    script.write_text(
        f"import sys, pathlib, traceback\nsys.path.insert(0, {str(HERE)!r})\ntext = 'PASSED'\n"
        f"try:\n    import scenes\n    scenes.gui(pathlib.Path({str(programs.folder)!r}))\n"
        "except Exception:\n    text = traceback.format_exc()\n"
        f"pathlib.Path({str(result)!r} + '.new').write_text(text)\n"
        f"pathlib.Path({str(result)!r} + '.new').rename({str(result)!r})\n")
    environment = dict(programs.environment, PV_PLUGIN_PATH=str(pathlib.Path(programs.plugin).parent))
    with open(programs.folder / "gui.log", "w") as log, subprocess.Popen(
            [str(programs.programs / "paraview"), f"--script={script}"], env=environment, stdout=log, stderr=log) as paraview:
        try:
            end = time.monotonic() + SECONDS
            while not result.exists() and paraview.poll() is None and time.monotonic() < end:
                time.sleep(0.5)
        finally:
            paraview.kill()
    text = result.read_text() if result.exists() else "it wrote nothing:\n" + (programs.folder / "gui.log").read_text()
    if text != "PASSED":
        raise Failure("paraview: " + text)


CASES = {name[len("run_"):].replace("_", "-"): value for name, value in sorted(globals().items()) if name.startswith("run_")}

if __name__ == "__main__":
    if sys.argv[1:] == ["--list"]:
        print("\n".join(CASES))
        sys.exit(0)
    if len(sys.argv) != 6 or sys.argv[5] not in CASES:
        sys.exit(__doc__)
    *places, case = sys.argv[1:]
    places[2] = "" if places[2] == "-" else places[2]
    try:
        CASES[case](Programs(*places[:3], os.path.join(places[3], case)))
    except Failure as failure:
        sys.exit(f"{case}: {failure}")
