from pathlib import Path

from onika.desk.environment.initial_model import opened
from onika.files import rmod
from onika.files.rmod import RmodText
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped
from onika.store.site import Site, open_site

TASK = Task("pd", "pd", frequency=10.0)


def test_the_shipped_laboratories_open_without_a_word():  # R-C01
    site = open_site([], {}, None)
    model, says = opened(site, None, {})
    assert says == ()
    assert [library.base for library in model.libraries.libraries] == list(site.directories)
    assert {"pd", "ctraj"} <= model.libraries.tasks.keys()
    assert {Path(path).suffix for path in model.files} == {".conf"}
    assert all(file.tasks for file in model.files.values())
    assert "Joint job" in model.job_types and "Joint object" not in model.job_types
    colour, vertices = model.edges["1"]
    assert (len(colour), colour[0], vertices) == (7, "#", ((4, 16), (-4, 16)))


def test_everything_that_is_at_fault_is_told_once_and_the_rest_is_there(tmp_path):  # R-C01, R-B12, R-C20
    home, base = tmp_path / "home", BaseDirectory(tmp_path / "base")
    home.mkdir()
    (home / ".onika").write_text("VERSION 1.2\nNONSENSE\nEOF\n")
    (home / ".onika.buttons").write_text("BUTTON\n")
    (home / ".OnikaUpperSetUp.dta").write_text("ONIKON\n")
    base.save_task(RmodText(TASK))
    (base.path / "module" / "bad.rmod").write_text("MODULE\n")
    (base.path / "conf").mkdir()
    (base.path / "conf" / "bad.conf").write_text("LOCUS q\n")
    site = Site((base, BaseDirectory(tmp_path / "nowhere")), shipped() / "prefs", home)
    model, says = opened(site, tmp_path / "state", {"ONIKA_WARNINGS": "no"})
    texts = [str(say.text) for say in says]
    for part in ("nowhere", ".onika:", ".onika.buttons", ".OnikaUpperSetUp.dta", "bad.rmod", "bad.conf"):
        assert any(part in text for text in texts), part
    assert len(texts) == len(set(texts))
    assert {say.level for say in says} == {"warning", "info"}
    assert list(model.libraries.tasks) == ["pd"]
    assert [library.base.path.name for library in model.libraries.libraries] == ["base"]
    assert [file.tasks for file in model.files.values()] == [0]
    assert model.job_types and not model.settings.shows_warnings


def test_it_may_begin_with_some_dictionaries_alone():  # R-H09, R-D01
    site = open_site([], {}, None)
    boxes = next(base.path for base in site.directories if base.path.name == "boxes")
    model, says = opened(site, None, {}, (boxes,))
    assert [dictionary.base.path for dictionary in model.dictionaries] == [boxes]
    assert says == () and len(model.search) > 1


def test_preferences_and_buttons_are_the_users(tmp_path):  # R-B12, R-G02
    (tmp_path / ".onika.buttons").write_text("VERSION 1.3\nBUTTON Clock\nFUNCTION date\nSPAWNNTTY no\nEOF\n")
    base = BaseDirectory(tmp_path / "base")
    (base.path / "module").mkdir(parents=True)
    (base.path / "module" / "pd.rmod").write_text(rmod.write(RmodText(TASK)))
    model, _ = opened(Site((base,), shipped() / "prefs", tmp_path), None, {})
    assert [(button.name, button.command) for button in model.buttons] == [("Clock", "date")]
    assert model.libraries.preferences == model.preferences
