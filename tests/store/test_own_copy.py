import os
import shutil
from pathlib import Path

import pytest

from onika.files import text
from onika.store.base_directory import BaseDirectory
from onika.store.own_copy import (
    OwnCopy,
    copied_with_code,
    copied_with_tasks,
    gone_back,
    own_copies,
    own_copy,
    saving_place,
)
from onika.store.replaced_texts import ReplacedTexts
from onika.store.shipped import shipped
from onika.store.site import Site, open_site
from onika.words.fault import Refusal


@pytest.fixture
def generic(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> BaseDirectory:
    labs = tmp_path / "labs"
    shutil.copytree(shipped() / "generic", labs / "generic", ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr("onika.store.shipped.shipped", lambda: labs)
    return BaseDirectory(labs / "generic")


@pytest.fixture
def site(generic: BaseDirectory, tmp_path: Path) -> Site:
    (tmp_path / "home").mkdir()
    return open_site([], {}, tmp_path / "home")


@pytest.fixture
def replaced(tmp_path: Path) -> ReplacedTexts:
    return ReplacedTexts(tmp_path / "state")


def changed_code(site: Site, generic: BaseDirectory, content: str = "mine\n") -> tuple[Path, ...] | Refusal:
    record, _ = generic.task("pd")
    assert record is not None
    return copied_with_tasks(generic.code_file("pd"), content, [record.task], site)


def contents(base: BaseDirectory) -> dict[str, str]:
    return {path.name: path.read_text() for path in sorted((base.path / "module").iterdir())}


def test_what_is_shipped_is_saved_in_the_users_own_and_the_rest_where_it_is(site, generic, tmp_path):  # R-B07
    assert saving_place(generic.path, site) == BaseDirectory(tmp_path / "home" / "onika")
    assert saving_place(tmp_path, site) == BaseDirectory(tmp_path)
    homeless = open_site([], {}, None)
    assert isinstance(saving_place(generic.path, homeless), Refusal)


def test_nothing_that_is_shipped_is_ever_written_though_it_could_be(site, generic):  # R-B07
    before = contents(generic)
    record, _ = generic.task("pd")
    assert record is not None and os.access(generic.task_file("pd"), os.W_OK)
    refused = generic.save_task(record, overwrites=True)
    assert isinstance(refused, Refusal) and refused.reason.key == "store.shipped_stays"
    assert contents(generic) == before


def test_a_link_of_ones_own_that_leads_to_a_shipped_file_is_not_written_through(site, generic):  # R-B07
    before, own = contents(generic), site.own / "module"
    own.mkdir(parents=True)
    (own / "pd.py").symlink_to(generic.code_file("pd"))
    refused = changed_code(site, generic)
    assert isinstance(refused, Refusal) and refused.reason.key == "store.shipped_stays"
    assert contents(generic) == before and sorted(path.name for path in own.iterdir()) == ["pd.py"]


def test_changed_code_counts_for_its_tasks_which_come_along(site, generic):  # R-C05
    before = contents(generic)
    paths = changed_code(site, generic)
    own = BaseDirectory(site.own)
    assert paths == (own.code_file("pd"), own.task_file("pd"))
    record, _ = site.task("pd")
    assert site.code_file(record.task) == own.code_file("pd")
    assert own.task_file("pd").read_text() == generic.task_file("pd").read_text()
    assert contents(generic) == before


def test_a_changed_task_keeps_its_code_where_another_of_that_name_would_count(site, generic, tmp_path):  # R-C05
    other = BaseDirectory(tmp_path / "other")
    other.code_file("pd").parent.mkdir(parents=True)
    other.code_file("pd").write_text("another\n")
    record, _ = generic.task("pd")
    mine = record.text.replace("MODULE", "MODULE")
    alone = copied_with_code(generic.task_file("pd"), mine, record.task, site.code_file(record.task), site)
    assert alone == (BaseDirectory(site.own).task_file("pd"),)
    alone[0].unlink()
    crowded = open_site([other.path], {}, tmp_path / "home")
    code = crowded.code_file(record.task)
    both = copied_with_code(generic.task_file("pd"), mine, record.task, code, crowded)
    assert [path.name for path in both] == ["pd.rmod", "pd.py"]
    assert both[1].read_text() == code.read_text() != "another\n"


def test_where_one_of_the_files_cannot_be_written_none_is_there(site, generic, monkeypatch):  # R-B07
    from onika.files import whole

    write, count = whole._write_new, []

    def full(*given):
        count.append(given)
        if len(count) == 2:
            raise OSError(28, "No space left on device")
        write(*given)

    monkeypatch.setattr(whole, "_write_new", full)
    refused = changed_code(site, generic)
    assert isinstance(refused, Refusal) and "space" in str(refused.reason)
    assert contents(BaseDirectory(site.own)) == {}
    monkeypatch.undo()


def test_a_directory_of_ones_own_that_cannot_be_made_is_told(site, generic, tmp_path):  # R-B07
    (tmp_path / "home" / "onika").write_text("a file, no directory")
    refused = changed_code(site, generic)
    assert isinstance(refused, Refusal) and refused.reason.key == "files.not_savable"


def test_a_file_of_ones_own_that_is_there_already_is_not_written_over(site, generic):  # R-B07
    own = BaseDirectory(site.own)
    own.code_file("pd").parent.mkdir(parents=True)
    own.code_file("pd").write_text("older\n")
    refused = changed_code(site, generic)
    assert isinstance(refused, Refusal) and refused.reason.key == "files.is_there"
    assert contents(own) == {"pd.py": "older\n"}


def test_the_copies_on_the_search_path_are_listed_with_what_they_stand_before(site, generic):  # R-B08
    changed_code(site, generic)
    own = BaseDirectory(site.own)
    own.task_file("mine").write_text("")
    assert own_copies(site) == (
        OwnCopy(own.code_file("pd"), generic.code_file("pd")),
        OwnCopy(own.task_file("pd"), generic.task_file("pd")),
    )
    assert own_copies(site)[0].laboratory == "generic"
    assert own_copy(own.task_file("mine"), site) is None and own_copy(generic.task_file("pd"), site) is None


def test_going_back_leaves_the_shipped_one_and_keeps_what_was_there(site, generic, replaced):  # R-X10
    own = BaseDirectory(site.own)
    changed_code(site, generic, "mine\n")
    copy = own_copy(own.code_file("pd"), site)
    assert copy.texts() == ("mine\n", generic.code_file("pd").read_text())
    gone = gone_back(copy, site, replaced, 5.0)
    assert gone == (own.code_file("pd"), own.task_file("pd")) and contents(own) == {}
    kept = replaced.listed()
    assert [(text.path, text.text, text.moment_s) for text in kept] == [(str(own.code_file("pd")), "mine\n", 5.0)]


def test_going_back_to_shipped_code_keeps_a_task_that_was_changed_too(site, generic, replaced):  # R-X10
    own = BaseDirectory(site.own)
    changed_code(site, generic)
    own.task_file("pd").write_text("# mine\n" + own.task_file("pd").read_text())
    gone_back(own_copy(own.code_file("pd"), site), site, replaced, 5.0)
    assert list(contents(own)) == ["pd.rmod"]
    record, _ = site.task("pd")
    assert site.code_file(record.task) == generic.code_file("pd")


def test_going_back_to_a_shipped_task_leaves_the_code_that_is_ones_own_in_force(site, generic, replaced):  # R-X10
    own = BaseDirectory(site.own)
    changed_code(site, generic)
    own.task_file("pd").write_text("# mine\n" + own.task_file("pd").read_text())
    assert gone_back(own_copy(own.task_file("pd"), site), site, replaced, 5.0) == (own.task_file("pd"),)
    assert contents(own) == {"pd.py": "mine\n", "pd.rmod": generic.task_file("pd").read_text()}


def test_what_cannot_be_kept_does_not_go(site, generic, tmp_path):  # R-X10, R-B07
    changed_code(site, generic)
    (tmp_path / "state").write_text("a file, no directory")
    own = BaseDirectory(site.own)
    refused = gone_back(own_copy(own.code_file("pd"), site), site, ReplacedTexts(tmp_path / "state"), 5.0)
    assert isinstance(refused, Refusal) and refused.reason.key == "store.not_kept"
    own.code_file("pd").write_bytes(b"\xff")
    refused = gone_back(own_copy(own.code_file("pd"), site), site, ReplacedTexts(tmp_path / "kept"), 5.0)
    assert isinstance(refused, Refusal) and "UTF-8" in str(refused.reason)
    assert text.load(own.task_file("pd"), "")[0] and own.code_file("pd").exists()
