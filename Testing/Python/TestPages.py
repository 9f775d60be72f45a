#!/usr/bin/env python3
"""Whether every technique has a page, and the page the options that the library declares."""
import pathlib
import subprocess
import sys

script = pathlib.Path(__file__).resolve().parents[2] / "scripts/document-options"
sys.exit(subprocess.run([sys.executable, "-B", str(script), "--check"]).returncode)
