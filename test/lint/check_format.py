"""Checks the format of every C++ file: check_format.py ROOT CLANG_FORMAT."""
import pathlib
import subprocess
import sys

root, clang_format = pathlib.Path(sys.argv[1]), sys.argv[2]
files = [str(path) for folder in ("include", "src", "test", "benchmark", "examples")
         for path in sorted((root / folder).rglob("*")) if path.suffix in (".h", ".cpp")]
result = subprocess.run([clang_format, "--dry-run", "--Werror", "--style=file"] + files)
print(f"{len(files)} files checked")
sys.exit(result.returncode)
