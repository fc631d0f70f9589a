import subprocess
import sys

LOADED = """
import sys
import onika.host.__main__
print([name for name in ("numpy", "onika.host.program", "onika.host.loading.module_facts") if name in sys.modules])
"""


def test_what_starts_the_loader_loads_little_so_that_it_comes_up_beside_the_runtime():  # R-E03
    ran = subprocess.run([sys.executable, "-c", LOADED], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "[]"
