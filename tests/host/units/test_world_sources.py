"""The files of worlds that came with plans."""

import os

from kit.worlds.file_cells import changed, files_of
from onika.host.units.world_sources import WorldSources, packed, unpacked


def test_the_newest_files_of_a_world_count_also_for_its_copies():  # R-X19
    sources, first = WorldSources(), files_of()
    second = changed("world/cell.world", "FLOOR 0", "FLOOR 0.1")
    assert sources.take([first]) == (first,)
    assert sources.take([first]) == ()
    assert sources.take([second]) == (second,)
    assert sources.find("cell@copy") == second
    assert sources.digest("cell") == second.digest != first.digest
    assert (sources.find("other"), sources.digest("other")) == (None, "")


def test_files_come_through_shared_memory_as_they_are():
    segment = packed(files_of())
    assert unpacked(os.dup(segment.fd)) == files_of()
