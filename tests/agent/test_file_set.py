import pytest

from onika.agent import file_set
from onika.agent.file_set import FileSet
from onika.store.remote.object_cache import write_whole


def test_files_are_replaced_added_and_removed_together(tmp_path):  # R-F03
    (tmp_path / "a").write_text("old")
    (tmp_path / "b").write_text("old")
    FileSet(tmp_path).replace({"a": b"new", "b": None, "module/c": b"new", "d": None})
    assert (tmp_path / "a").read_text() == (tmp_path / "module/c").read_text() == "new"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "module"]


class PowerLost(Exception):
    """It goes no further."""


@pytest.mark.parametrize("lost_at", range(8))
def test_when_power_is_lost_all_of_them_are_replaced_or_none(tmp_path, monkeypatch, lost_at):  # R-F03
    for name in "abc":
        (tmp_path / name).write_text("old")
    steps = iter(range(100))

    def step():
        if next(steps) == lost_at:
            raise PowerLost

    def written(path, content, mode):
        step()
        write_whole(path, content, mode)

    class Path(type(tmp_path)):
        def replace(self, target):
            step()
            return super().replace(target)

    monkeypatch.setattr(file_set, "write_whole", written)
    try:
        FileSet(Path(tmp_path)).replace({"a": b"new", "b": b"new", "c": b"new"})
    except PowerLost:
        FileSet(tmp_path).complete()
    states = {(tmp_path / name).read_text() for name in "abc"}
    assert states == ({"old"} if lost_at < 4 else {"new"})
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b", "c"]


def test_where_nothing_was_under_way_nothing_is_done(tmp_path):
    FileSet(tmp_path).complete()
    assert not list(tmp_path.iterdir())
