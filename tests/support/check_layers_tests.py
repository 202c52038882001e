"""The check of the arrows finds a wrong one, and only that one."""
import pathlib
import subprocess
import sys
import tempfile

checker = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "check_layers.py"
with tempfile.TemporaryDirectory() as folder:
    (pathlib.Path(folder) / "md").mkdir()
    source = pathlib.Path(folder) / "md" / "wrong.cpp"
    source.write_text('#include "scene/scene.hpp"\n#include "fields/bins.hpp"\n')
    found = subprocess.run([sys.executable, checker, folder], capture_output=True, text=True)
    assert found.returncode == 1, found
    assert found.stdout.strip() == "md/wrong.cpp:2: md may not include fields/bins.hpp", found.stdout
    source.write_text('#include "scene/scene.hpp"\n')
    assert subprocess.run([sys.executable, checker, folder], capture_output=True).returncode == 0
