"""Checks that every script explains itself with --help, and does nothing else.

It neither installs packages nor builds, which would take far longer than the limit.
"""
import os
import pathlib
import subprocess
import sys

LIMIT = 20  # s


def problem(script):
    """Returns what is wrong with a script's help, or None."""
    try:
        result = subprocess.run([script, "--help"], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, universal_newlines=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return f"--help takes more than {LIMIT} s"
    if result.returncode or result.stderr:
        return f"--help ends with {result.returncode} and '{result.stderr.strip()}'"
    return None if script.name in result.stdout else f"--help does not show how to call {script}"


def main(source):
    scripts = [path for path in sorted((pathlib.Path(source) / "scripts").iterdir())
               if not path.suffix and os.access(path, os.X_OK)]
    problems = {script.name: problem(script) for script in scripts}
    for name, text in problems.items():
        if text:
            print(f"scripts/{name}: {text}")
    return 1 if not scripts or any(problems.values()) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
