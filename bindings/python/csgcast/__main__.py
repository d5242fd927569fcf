# SPDX-License-Identifier: MIT
"""Runs the program that the package brings along: `python -m csgcast`, and the command `csgcast` of an installed wheel."""
import os
import sys
from pathlib import Path

PROGRAM = Path(__file__).resolve().parent / "bin" / "csgcast"


def main():
    """Becomes the program, with the same arguments; never returns."""
    try:
        os.execv(PROGRAM, ["csgcast", *sys.argv[1:]])
    except OSError as error:
        sys.exit(f"csgcast: error: the program {PROGRAM} cannot be run ({error.strerror}); build or install csgcast again")


if __name__ == "__main__":
    main()
