from dataclasses import replace
from pathlib import Path

import pytest

from onika.desk.plan.iconify import IconifiedFile, iconify
from onika.files import syntax as syntax_file
from onika.files.rmod import RmodText
from onika.model.application import AppFlow, Application, Hole, Icon
from onika.model.configuration import Configuration, Placed
from onika.model.initials import drawn
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped
from onika.store.site import Site

SYNTAX = syntax_file.read((shipped() / "prefs" / syntax_file.NAME).read_text(), "s", "s")[0]
MOVE = Icon(Onikon("move", "Joint job", "", (), blank()))


@pytest.fixture
def base(tmp_path: Path) -> BaseDirectory:
    base = BaseDirectory(tmp_path / "lab")
    base.save_task(RmodText(Task("jmove", "jmove", frequency=1.0, object_type="joint job")))
    base.save_configuration(Configuration("move", (Placed("jmove"),)))
    base.save_application(Application("go", False, (AppFlow((MOVE, Hole())),)))
    return base


@pytest.fixture
def site(tmp_path: Path) -> Site:
    return Site((), shipped() / "prefs")


def made(path: Path, site: Site, **given: object) -> Onikon:
    outcome = iconify(path, site, **given)  # type: ignore[arg-type]
    assert isinstance(outcome, IconifiedFile), outcome
    return outcome.onikon


def reasons(path: Path, site: Site, **given: object) -> list[str]:
    outcome = iconify(path, site, **given)  # type: ignore[arg-type]
    assert not isinstance(outcome, IconifiedFile)
    return list(map(str, outcome))


def saved(base: BaseDirectory, name: str) -> Onikon | None:
    assert SYNTAX
    return base.onikon(name, SYNTAX)[0]


def test_a_configuration_and_an_application_get_icons_of_their_types(base: BaseDirectory, site: Site) -> None:
    move = made(base.configuration_file("move"), site, description=" moves  it\n")  # §5.6.2
    assert move == Onikon("move", "Joint job", "moves it", (), drawn("move")) == saved(base, "move")
    go = made(base.application_file("go"), site)  # R-D09
    assert go == Onikon("go", "Joint application", "", (), drawn("go")) == saved(base, "go")


def test_an_icon_that_is_there_keeps_its_picture_its_description_and_its_comments(
    base: BaseDirectory, site: Site
) -> None:
    old = Onikon("move", "Complete job", "moves", (), blank())  # reading 36: its type is stale
    base.save_onikon(old)
    file = base.onikon_file("move")
    file.write_text("# mine\n" + file.read_text())
    assert made(base.configuration_file("move"), site) == replace(old, type="Joint job") == saved(base, "move")
    assert file.read_text().startswith("# mine\n")
    assert made(base.configuration_file("move"), site, description="goes").description == "goes"


def test_another_icon_lends_its_picture(base: BaseDirectory, site: Site, tmp_path: Path) -> None:
    base.save_onikon(Onikon("model", "Complete job", "", (), drawn("X")))
    outcome = made(base.configuration_file("move"), site, picture=base.onikon_file("model"))
    assert outcome.picture == drawn("X")
    (tmp_path / "no.onk").write_text("EOF\n")
    for path in (tmp_path / "no.onk", tmp_path / "none.onk"):
        assert reasons(base.configuration_file("move"), site, picture=path)


def test_several_targets_are_told_in_the_icon(base: BaseDirectory, site: Site) -> None:
    task = Task("jmove", "jmove", frequency=1.0, object_type="Joint job", more_targets=("cartesian object",))  # R-D13
    base.save_task(RmodText(task), overwrites=True)
    assert made(base.configuration_file("move"), site).more_targets == ("Cartesian object",)
    assert base.onikon_file("move").read_text().startswith("VERSION     2.0\n")


def test_an_icon_of_something_else_is_kept_unless_it_is_to_be_replaced(base: BaseDirectory, site: Site) -> None:
    made(base.configuration_file("move"), site)  # reading 34
    base.save_application(Application("move", False, (AppFlow((MOVE, Hole())),)))
    (reason,) = reasons(base.application_file("move"), site)
    assert "is the icon of something else, a Joint job" in reason
    assert "rename move.appl" in reason
    assert made(base.application_file("move"), site, replaces=True).type == "Joint application"
    assert saved(base, "move") == made(base.application_file("move"), site)


def test_an_icon_that_cannot_be_read_is_kept_unless_it_is_to_be_replaced(base: BaseDirectory, site: Site) -> None:
    base.onikon_file("move").parent.mkdir()
    base.onikon_file("move").write_text("WRONG\nEOF\n")
    assert reasons(base.configuration_file("move"), site)
    assert base.onikon_file("move").read_text() == "WRONG\nEOF\n"
    assert made(base.configuration_file("move"), site, replaces=True).type == "Joint job"


def test_what_has_no_icon_is_told_with_its_reason_and_nothing_is_written(base: BaseDirectory, site: Site) -> None:
    base.save_configuration(Configuration("lost", (Placed("nobody"),)))
    base.save_application(Application("gap", False, (AppFlow((Hole(),)),)))
    assert reasons(base.configuration_file("lost"), site) == [
        "the task nobody of `lost` is missing (you can: make it; remove it from `lost`)"
    ]
    assert "no place for a target" in reasons(base.application_file("gap"), site)[0]
    base.configuration_file("bad").write_text("WRONG\nEOF\n")
    assert "WRONG" in reasons(base.configuration_file("bad"), site)[0]
    base.task_file("jmove").write_text("WRONG\nEOF\n")
    assert "jmove.rmod" in reasons(base.configuration_file("move"), site)[0]
    assert base.onikons == ()


@pytest.mark.parametrize("name", ["conf/none.conf", "module/jmove.rmod", "conf", "other/x.conf", "conf/9.conf"])
def test_what_is_no_file_of_a_base_directory_is_refused(base: BaseDirectory, site: Site, name: str) -> None:
    (base.path / "other").mkdir()
    for strange in ("other/x.conf", "conf/9.conf"):
        (base.path / strange).write_text("VERSION 1.3\nEOF\n")
    (reason,) = reasons(base.path / name, site)
    assert reason.endswith("instead: no icon is made")


def test_an_icon_keeps_what_it_says_in_other_languages_as_long_as_it_says_the_same(
    base: BaseDirectory, site: Site
) -> None:
    words = (("es", "mueve"),)  # R-X11
    base.save_onikon(Onikon("move", "Joint job", "move", (), drawn("M"), (), words))
    assert made(base.configuration_file("move"), site).words == words
    assert made(base.configuration_file("move"), site, description="go").words == ()
