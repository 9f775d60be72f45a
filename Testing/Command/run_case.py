"""Runs one case of cases.py in an empty folder, or lists them all."""

import argparse
import pathlib
import sys
import tempfile

import cases
import inputs


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--command", type=pathlib.Path)
    parser.add_argument("--case")
    arguments = parser.parse_args()
    if arguments.list:
        print("\n".join(cases.CASES))
        return 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        inputs.write_good(folder)
        inputs.write_broken(folder)
        cases.CASES[arguments.case](arguments.command.resolve(), folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
