from dataclasses import replace

import pytest

from kit.labs.library_site import LibrarySite, taken
from kit.plans.build import task
from onika.desk.console.site_library import SiteLibrary, altered
from onika.store.remote.library_fetcher import LibraryFetcher
from onika.store.site import open_site
from onika.words.fault import Place
from onika.words.reason import Reason


@pytest.fixture
def library(tmp_path):
    return SiteLibrary(open_site([tmp_path], {}, tmp_path), Place("line"))


def test_a_task_comes_with_its_code_from_the_search_path(library):  # R-A14
    planned, code, faults = library.planned("pd", "rt1")
    assert (planned.name, planned.rtpu, planned.digest, faults) == ("pd", "rt1", code.digest, ())
    assert "class" in code.source


def test_code_of_a_library_of_others_is_fetched_when_a_task_needs_it(tmp_path):  # R-F03, R-X16
    far = LibrarySite(tmp_path)
    far.publish()
    remote = taken(tmp_path, far)
    site = open_site([], {"XDG_CACHE_HOME": str(tmp_path / "cache")}, tmp_path / "home")
    planned, code, (fault,) = SiteLibrary(site, Place("line")).planned("wink")
    assert (planned, code, fault.reason.key) == (None, None, "store.code_not_fetched")
    site = replace(site, fetcher=LibraryFetcher(site.checkouts, remote.access))
    planned, code, faults = SiteLibrary(site, Place("line")).planned("wink")
    assert (code.source, faults) == ((far.base / "module/wink.py").read_text(), ())


def test_a_task_without_code_names_its_file(library, tmp_path):
    (tmp_path / "module").mkdir()
    text = (
        "MODULE lost\nDESC x\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR none\nTASKTYPE periodic\nFREQ 9\n\nEOF\n"
    )
    (tmp_path / "module" / "lost.rmod").write_text(text)
    planned, code, (fault,) = library.planned("lost")
    assert (planned, code) == (None, None)
    assert fault.reason == Reason.of("desk.code_not_on_path", module="lost")


def test_what_is_not_there_is_told_with_what_is_near_it(library):
    _, (fault,) = library.configuration("jmovC")
    assert str(fault.reason) == (
        "expected a configuration on the search path (near it: jmoveC, cmoveC, jogC), found 'jmovC'"
    )
    _, (fault,) = library.task("qqq")
    assert fault.reason.key == "desk.not_on_search_path"


def test_names_are_offered_in_order_and_once(library):
    for names in (library.tasks, library.configurations, library.applications):
        assert list(names) == sorted(set(names))
        assert names


def test_a_syntax_that_cannot_be_read_is_a_fault_of_the_target(library, monkeypatch):
    assert library.arguments("1 2") == ("1 2", ())
    line, faults = library.arguments("@none")
    assert (line, len(faults)) == ("", 1)


def test_name_and_rate_are_altered_only_where_they_are_given():
    record = task("pd", 100.0)
    assert altered(record, "", None) == record
    assert (altered(record, "x", 5.0).name, altered(record, "x", 5.0).frequency) == ("x", 5.0)
