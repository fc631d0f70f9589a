"""The files of a world on their way."""

from onika.wire.world_source import WorldFile, WorldSource, digest_of


def test_files_are_named_by_what_they_say_not_by_where_they_lay():  # R-X19
    here, there = WorldFile("world/a.world", "/here", b"x"), WorldFile("world/a.world", "/there", b"x")
    assert digest_of([here]) == digest_of([there]) != digest_of([WorldFile("world/a.world", "/here", b"y")])
    assert digest_of([WorldFile("ab", "", b"c")]) != digest_of([WorldFile("a", "", b"bc")])


def test_a_file_is_found_by_its_name():
    file = WorldFile("robot/r.robot", "/r", b"")
    source = WorldSource("a", "", (file,))
    assert (source.find("robot/r.robot"), source.find("robot/s.robot")) == (file, None)
