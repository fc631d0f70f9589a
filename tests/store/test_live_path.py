from pathlib import Path

from onika.store.base_directory import BaseDirectory
from onika.store.live_path import LivePath

ONE, OTHER = BaseDirectory(Path("/one")), BaseDirectory(Path("/other"))


def test_a_search_path_grows_behind_and_shrinks_anywhere():  # R-F03
    path = LivePath([ONE])
    path.add(OTHER)
    path.add(OTHER)
    assert list(path) == [ONE, OTHER]
    assert path[-1] == OTHER and path[:1] == (ONE,) and len(path) == 2
    path.remove(ONE)
    path.remove(ONE)
    assert list(path) == [OTHER]


def test_whoever_reads_it_sees_it_as_it_was_when_he_began():  # R-F03
    path = LivePath([ONE])
    reading = iter(path)
    path.remove(ONE)
    assert list(reading) == [ONE]
