import sys

from onika.host.processes import preloaded_libraries


def test_a_library_that_is_missing_is_no_fault_until_a_module_needs_it(monkeypatch):  # law 21
    monkeypatch.setattr(preloaded_libraries, "PRELOADED", ("nothing_like_it", "json"))
    preloaded_libraries.preload()
    assert "json" in sys.modules


def test_a_library_that_cannot_be_loaded_is_no_fault_until_a_module_needs_it(monkeypatch, tmp_path):  # law 21
    (tmp_path / "broken_library.py").write_text("raise RuntimeError('invalid value for MUJOCO_GL')\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setattr(preloaded_libraries, "PRELOADED", ("broken_library", "json"))
    preloaded_libraries.preload()
    assert "json" in sys.modules
