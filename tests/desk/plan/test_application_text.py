from pathlib import Path

import pytest

from onika.desk.plan.application_text import convert, is_text, keep, unfit
from onika.files import appl, onk
from onika.model.application import AppFlow, Application, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.store.shipped import shipped
from onika.store.site import Site, open_site
from onika.words.fault import Refusal

NOOP = Onikon("rest", "Complete NOP", "rest a while", (), blank())
HOME = Onikon("up", "Joint object", "up", ((0.0,) * 6, (3.0,)), blank())
WORK = Application("work", False, (AppFlow((Icon(NOOP), Icon(HOME))),))


@pytest.fixture
def site() -> Site:
    return open_site([], {}, None)


@pytest.fixture
def lab(tmp_path: Path) -> Path:
    """A base directory with an application and one of its icons in the dictionary."""
    (tmp_path / "appl").mkdir()
    (tmp_path / "dict").mkdir()
    (tmp_path / "appl" / "work.appl").write_text(appl.write(WORK))
    (tmp_path / "dict" / "rest.onk").write_text(onk.write(NOOP))
    return tmp_path


def test_icons_of_the_base_directory_of_either_file_are_named_only(lab: Path, site: Site) -> None:
    text = convert(lab / "appl" / "work.appl", None, site)  # R-D14
    assert "  NOP rest  { rest a while }\n" in text.content
    assert [line for line in text.content.splitlines() if line.startswith("ICON")] == ["ICON        up"]
    (lab / "work.al").write_text(text.content)
    assert convert(lab / "work.al", lab / "appl" / "work.appl", site).application == WORK
    (lab / "appl" / "work.al").write_text(text.content)
    again = convert(lab / "appl" / "work.al", lab / "other.appl", site)
    assert again.application == Application("other", False, WORK.flows)
    assert again.content == appl.write(WORK)


def test_a_whole_text_stands_alone(lab: Path, site: Site) -> None:
    text = convert(lab / "appl" / "work.appl", None, site, is_whole=True)
    (lab / "work.al").write_text(text.content)
    assert convert(lab / "work.al", None, site).application == WORK


def test_an_icon_that_is_nowhere_is_told(lab: Path, site: Site) -> None:
    (lab / "work.al").write_text("BEGIN\nNOP rest\nEND\n")
    conversion = convert(lab / "work.al", None, site)
    assert conversion.application is None
    assert conversion.content == ""
    assert [str(fault.reason) for fault in conversion.faults] == [
        "expected an icon `rest` in the dictionary or under WHERE, found none"
    ]


def test_an_icon_at_fault_in_the_dictionary_is_defined_in_the_text_and_told(lab: Path, site: Site) -> None:
    (lab / "dict" / "rest.onk").write_text("junk\n")
    conversion = convert(lab / "appl" / "work.appl", None, site)
    assert "ICON        rest\n" in conversion.content
    assert conversion.faults == ()
    assert {note.place.file for note in conversion.notes} == {str(lab / "dict" / "rest.onk")}


def test_files_that_cannot_be_read_are_told(lab: Path, site: Site) -> None:
    for name in ("none.al", "none.appl"):
        assert [fault.place.file for fault in convert(lab / name, None, site).faults] == [str(lab / name)]
    (lab / "bad.appl").write_text("junk\n")
    assert convert(lab / "bad.appl", None, site).faults


@pytest.mark.parametrize(
    ("file", "out", "is_fit"),
    [
        ("a.appl", "a.al", True),
        ("a.al", "a.appl", True),
        ("a.appl", "b.appl", False),
        ("a.al", "b.al", False),
        ("a.al", "2 b.appl", False),
    ],
)
def test_the_other_form_has_the_other_ending(file: str, out: str, is_fit: bool) -> None:
    assert (unfit(Path(file), Path(out)) is None) == is_fit
    assert is_text(Path(file)) == file.endswith(".al")


def test_a_file_is_overwritten_only_when_that_was_said_and_keeps_its_comments(lab: Path, site: Site) -> None:
    out = lab / "appl" / "work.appl"
    (lab / "work.al").write_text("BEGIN\nNOP rest\nEND\n")
    out.write_text(out.read_text().replace("ROUTINE     rest", "# go\nROUTINE     rest"))
    converted = convert(lab / "work.al", out, site)
    assert isinstance(keep(converted, out, overwrites=False), Refusal)
    assert keep(converted, out, overwrites=True) is None
    assert "# go\nROUTINE     rest\n" in out.read_text()
    assert "ROUTINE     up" not in out.read_text()
    text = convert(out, None, site)
    assert keep(text, lab / "fresh.al", overwrites=False) is None
    assert (lab / "fresh.al").read_text() == text.content
    assert isinstance(keep(text, lab / "fresh.al", overwrites=False), Refusal)


@pytest.mark.parametrize("path", sorted(shipped().glob("*/appl/*.appl")), ids=lambda path: path.stem)
def test_every_shipped_application_is_written_and_read_back_byte_by_byte(
    path: Path, tmp_path: Path, site: Site
) -> None:
    (tmp_path / "a.al").write_text(convert(path, None, site).content)  # R-D14
    syntax, _ = site.syntax()
    assert syntax
    application, _ = appl.read(path.read_text(), path.stem, str(path), syntax)
    assert application
    assert convert(tmp_path / "a.al", path, site).application == application
    assert convert(tmp_path / "a.al", path, site).content == appl.write(application)
