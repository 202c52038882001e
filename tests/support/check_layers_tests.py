"""The check of the arrows finds a wrong one, and only that one; and a test that names a version of Catch2."""
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

    (pathlib.Path(folder) / "tests" / "md").mkdir(parents=True)
    test = pathlib.Path(folder) / "tests" / "md" / "some_tests.cpp"
    for line in ("#include <catch2/catch.hpp>", 'CHECK_THAT(text, Catch::Contains("a"));'):
        test.write_text(f'#include "tests/support/catch.hpp"\n{line}\n')
        found = subprocess.run([sys.executable, checker, folder], capture_output=True, text=True)
        assert found.returncode == 1 and found.stdout.startswith("tests/md/some_tests.cpp:2: "), found
    test.write_text('#include "tests/support/catch.hpp"\nCHECK_THAT(text, Contains("a"));\n')
    assert subprocess.run([sys.executable, checker, folder], capture_output=True).returncode == 0
