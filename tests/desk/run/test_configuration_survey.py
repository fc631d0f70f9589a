from pathlib import Path

import pytest

from kit.labs.laboratory import Laboratory
from onika.desk.run.configuration_survey import surveyed
from onika.store.site import open_site
from onika.wire.sheet import ModuleSheet, PortSheet


@pytest.fixture
def laboratory(tmp_path):
    lab = Laboratory(tmp_path)
    for name, reads, writes in (("wave", "none", "WAVE"), ("tone", "none", "WAVE"), ("hears", "WAVE", "none")):
        lab.plain_task(name, reads=reads, writes=writes)
        lab.module(name, f"# {name}")
    return lab


@pytest.fixture
def site(tmp_path):
    return open_site([tmp_path], {}, None)


def sheet_of(unit):
    return ModuleSheet((PortSheet("INVAR", "WAVE", "double", unit, ""),), (), (), False, False, False, 0, "")


def sheets(units):
    """Modules whose one port has these units, by what their code says."""

    def describe(code):
        return {entry.digest: sheet_of(units[entry.module]) for entry in code if entry.module in units}

    return describe


def findings(path: Path, site, units=None):
    (configuration,) = surveyed([path], site)
    return [(fault.place.line, str(fault.reason)) for fault in configuration.faults(site, sheets(units or {}))]


def test_two_writers_of_one_variable_are_a_fault_at_the_line_of_the_later(laboratory, site):  # R-C26, law 9
    path = laboratory.configuration("c", "wave 10", "tone 10")
    assert findings(path, site) == [
        (9, "expected tasks that may stand together, found `tone`: writes WAVE, which `wave` already writes")
    ]


def test_units_that_disagree_are_a_fault(laboratory, site):  # R-C26, law 7
    path = laboratory.configuration("c", "wave 10", "hears 10")
    assert findings(path, site, {"wave": "m", "hears": "m"}) == []
    ((line, text),) = findings(path, site, {"wave": "m", "hears": "s"})
    assert line == 9
    assert "takes WAVE for double in s, `wave` for double in m" in text


def test_tasks_that_are_nowhere_are_named_with_their_lines(laboratory, site):  # reading 11
    path = laboratory.configuration("c", "wave 10", "ghost 10")
    assert findings(path, site) == [(9, "expected its tasks on the search path, found no ghost")]


def test_an_alias_of_the_configuration_parts_two_writers(laboratory, site):  # R-B09
    path = laboratory.configuration("c", "wave 10", "tone 10")
    text = path.read_text().replace("1.3", "2.0")
    head, _, tail = text.rpartition("RTPU        unknown\n")
    path.write_text(f"{head}RTPU        unknown\nSVARALIAS   WAVE = TONE\n{tail}")
    assert findings(path, site) == []


def test_a_file_that_cannot_be_read_is_told_of_itself_alone(laboratory, site):  # R-B07
    path = laboratory.configuration("c", "wave fast")
    assert surveyed([path], site) == []
