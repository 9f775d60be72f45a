"""run_scene.py CASE PLUGIN FOLDER [URL]: a case of scenes.py, of which it says in its last line whether it has passed.

With a URL, HOST:PORT, it connects to a server first. PLUGIN is '-' for none; server=PLUGIN loads it there, and both=PLUGIN in both places.
"""
import os
import pathlib
import sys
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import scenes  # noqa: E402
from paraview.simple import Connect, LoadPlugin  # noqa: E402


def run(case, plugin, folder, url=None):
    if url:
        host, port = url.split(":")
        Connect(host, int(port))
    where, _, path = plugin.rpartition("=")
    if where:
        LoadPlugin(path, remote=True, ns=vars(scenes))
    if path != "-" and where != "server":
        LoadPlugin(path, remote=False, ns=vars(scenes))
    getattr(scenes, case)(pathlib.Path(folder))


if __name__ == "__main__":
    try:
        run(*sys.argv[1:])
        print("PASSED", flush=True)
    except Exception:
        traceback.print_exc()
        print("FAILED", flush=True)
        sys.exit(1)
