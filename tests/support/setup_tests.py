"""scripts/setup says nothing where nothing is missing, and one sentence with every name where it cannot install."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

setup = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "setup"
USED = ("bash", "cat", "grep", "dirname", "python3", "sh")


def run(tools, lines, programs):
    """scripts/setup LIST with nothing on the PATH but USED, `tools` of this system, and `programs`, name to script."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "bin").mkdir()
        for name in (*USED, *tools):
            # The interpreter itself: a python3 on the PATH may be a script that needs the rest of it.
            (folder / "bin" / name).symlink_to(sys.executable if name == "python3" else shutil.which(name))
        for name, script in programs.items():
            (folder / "bin" / name).write_text(f"#!/bin/sh\n{script}\n")
            (folder / "bin" / name).chmod(0o755)
        (folder / "list.txt").write_text("# a comment\n" + "\n".join(lines) + "\n")
        return subprocess.run([setup, folder / "list.txt"], env={"PATH": str(folder / "bin")}, capture_output=True, text=True)


def one_sentence(result, *words):
    assert result.returncode == 1 and result.stdout == "" and result.stderr.count("\n") == 1, result
    assert all(word in result.stderr for word in words), result


# What dpkg knows: g++ is installed, nothing else is.
DPKG = {"dpkg-query": 'case "$*" in *g++*) printf "install ok installed" ;; *) exit 1 ;; esac'}
PACKAGES = ["g++  c++", "libone-dev", "python3-two  python3:two"]

assert run([], ["g++  c++"], DPKG).returncode == 0
one_sentence(run([], PACKAGES, DPKG), "no apt-get", "libone-dev", "python3-two")
one_sentence(run([], PACKAGES, DPKG | {"apt-get": "exit 9", "id": "echo 1000"}), "only root", "libone-dev", "python3-two")
assert "g++" not in run([], PACKAGES, DPKG).stderr

# Without dpkg: commands and modules of Python; libraries are left to CMake.
one_sentence(run([], PACKAGES, {}), "no apt-get", "c++", "python3:two")
assert "libone" not in run([], PACKAGES, {}).stderr
assert run([], ["g++  c++", "libone-dev", "python3-json  python3:json"], {"c++": "exit 0"}).returncode == 0
