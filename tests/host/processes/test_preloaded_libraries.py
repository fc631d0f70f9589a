import sys

from onika.host.processes import preloaded_libraries


def test_a_library_that_is_missing_is_no_fault_until_a_module_needs_it(monkeypatch):  # law 21
    monkeypatch.setattr(preloaded_libraries, "PRELOADED", ("nothing_like_it", "json"))
    preloaded_libraries.preload()
    assert "json" in sys.modules
