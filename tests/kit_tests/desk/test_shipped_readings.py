import os
from dataclasses import replace
from functools import partial
from pathlib import Path

from kit.desk.shipped_readings import ShippedReadings
from onika.files import appl, conf
from onika.store.opened_text import open_file
from onika.store.shipped import shipped
from onika.store.site import open_site

SYNTAX, _ = open_site([], {}, None).syntax()
APPLICATION = shipped() / "boxes" / "appl" / "assemble.appl"


class Counted:
    def __init__(self) -> None:
        self.paths: list[Path] = []

    def __call__(self, path, name, read):
        self.paths.append(path)
        return open_file(path, name, read)


def test_a_shipped_file_is_read_once_in_each_way():
    counted = Counted()
    readings = ShippedReadings(counted)
    another = replace(SYNTAX, types=SYNTAX.types[:-1])
    for syntax in (SYNTAX, replace(SYNTAX), another):
        given = readings(APPLICATION, "assemble", partial(appl.read, syntax=syntax))
        assert given == open_file(APPLICATION, "assemble", partial(appl.read, syntax=syntax))
    assert counted.paths == [APPLICATION] * 2


def test_what_stands_elsewhere_is_read_anew_and_so_is_a_shipped_file_that_was_written(tmp_path, monkeypatch):
    monkeypatch.setattr("kit.desk.shipped_readings.shipped", lambda: tmp_path / "labs")
    counted = Counted()
    readings = ShippedReadings(counted)
    written = ["VERSION 1.3\n", "# longer\n", "# longer\n"]
    for folder in ("labs", "lab"):
        (tmp_path / folder).mkdir()
        path = tmp_path / folder / "pair.conf"
        for text in written:
            path.write_text(text)
            os.utime(path, (len(text), len(text)))
            assert readings(path, "pair", conf.read) == open_file(path, "pair", conf.read)
    assert [path.parent.name for path in counted.paths] == ["labs"] * 2 + ["lab"] * 3
    (tmp_path / "labs" / "pair.conf").unlink()
    assert readings(tmp_path / "labs" / "pair.conf", "pair", conf.read)[0] is None
