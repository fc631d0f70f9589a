import resource
import subprocess
import sys

import pytest

from onika.host.guards.memory_limit import bound

PROBE = """
import sys
from onika.host.guards.memory_limit import bound
print(bound(100 << 20))
try:
    kept = [bytearray(16 << 20) for _ in range(100)]
except MemoryError:
    print("MemoryError")
kept = None
print(len(bytearray(50 << 20)) >> 20)
"""


@pytest.mark.site
def test_who_takes_too_much_gets_a_memory_error_and_may_go_on_with_less():  # R-A12
    ran = subprocess.run([sys.executable, "-c", PROBE], capture_output=True, text=True, check=True)
    assert ran.stdout.split() == ["True", "MemoryError", "50"]


def test_where_the_system_sets_no_bounds_there_is_none(monkeypatch):
    def refuse(*_):
        raise ValueError("not here")

    monkeypatch.setattr(resource, "setrlimit", refuse)
    assert bound() is False
