# SPDX-License-Identifier: BSD-3-Clause
"""Our programs, and writing files so that an interrupted call leaves none half written."""
import os
import subprocess
import sys
from pathlib import Path

from plan import ROOT


def program(name):
    return ROOT / "build" / "release" / "bin" / name


def call(*command):
    """What it prints on stderr becomes our one line if it fails."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True)
    if done.returncode:
        lines = done.stderr.strip().splitlines() or [f"exit status {done.returncode}"]
        sys.exit(f"{Path(command[0]).name}: {lines[-1]}")


def settings_as_arguments(settings):
    return [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]


def write_text(path, text):
    part = Path(f"{path}.part")
    part.parent.mkdir(parents=True, exist_ok=True)
    part.write_text(text)
    os.replace(part, path)
