import runpy

import pytest

from onika.desk.plan.guest_template import create_guest
from onika.files import conf, rmod
from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import differences, sheet_of
from onika.words.fault import Place


def test_the_tasks_of_a_guest_agree_with_its_module_and_its_job(tmp_path):  # R-A20
    program, code, asker, keeper, job, test = create_guest("wise_owl", tmp_path)
    cls = load(code.read_text(), str(code), "wise_owl_chooses")
    assert cls.__name__ == "WiseOwlChooses"
    asks, faults = rmod.read(asker.read_text(), "wise_owl_chooses", str(asker))
    keeps, more = rmod.read(keeper.read_text(), "wise_owl", str(keeper))
    assert (faults, more) == ((), ())
    assert differences(asks.task, sheet_of(cls), Place(str(asker))) == []
    assert (asks.task.module, keeps.task.module) == ("wise_owl_chooses", "guest")
    assert not conf.read(job.read_text(), job.name, str(job))[1]
    assert compile(program.read_text(), str(program), "exec")
    assert test.name == "test_wise_owl.py"


def test_its_own_test_passes_also_where_its_folder_has_a_blank(tmp_path):  # R-A20
    test = create_guest("owl", tmp_path / "my lab")[-1]
    runpy.run_path(str(test))["test_owl_chooses_the_smallest"]()


def test_nothing_is_written_over_and_nothing_halfway(tmp_path):  # R-B08
    (tmp_path / "conf").mkdir()
    (tmp_path / "conf" / "owl_choosesC.conf").write_text("mine")
    with pytest.raises(ValueError, match="is there already: nothing was written"):
        create_guest("owl", tmp_path)
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == ["owl_choosesC.conf"]
    with pytest.raises(ValueError, match="expected a name"):
        create_guest("../owl", tmp_path)
