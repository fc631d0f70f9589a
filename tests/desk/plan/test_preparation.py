import pytest

from kit.labs.laboratory import HOLE, Laboratory, job, joints
from onika.desk.plan.preparation import prepare, prepare_run
from onika.store.site import open_site
from onika.wire.request import FaultText
from onika.words.fault import Place
from onika.words.reason import Reason


@pytest.fixture
def laboratory(tmp_path):
    return Laboratory(tmp_path)


@pytest.fixture
def site(tmp_path):
    return open_site([tmp_path], {}, None)


@pytest.mark.parametrize("name", ["assemble", "assemble24", "go_home", "two_arms"])
def test_a_shipped_application_is_ready(site, name):  # R-E01, R-K01
    prepared = prepare_run(name, site)
    assert prepared.faults == ()
    assert prepared.name == prepared.plan.application == prepared.application.name == name
    assert all(task.place.endswith(f"{task.name}.rmod") for flow in prepared.plan.flows for task in flow.tasks)
    assert {code.module for code in prepared.plan.code} == {
        task.module for flow in prepared.plan.flows for task in flow.tasks
    }


def test_a_file_is_found_by_its_path_and_its_own_directory_comes_first(laboratory):  # reading 35
    laboratory.plain_task("opengrip", reads="GRIP_MEZ", writes="GRIP", hz=50)
    path = laboratory.application("mine", [job("opengripC")])
    prepared = prepare_run(str(path), open_site([], {}, None))
    assert prepared.faults == ()
    places = {task.name: task.place for flow in prepared.plan.flows for task in flow.tasks}
    assert places["opengrip"] == str(laboratory.path / "module" / "opengrip.rmod")


def test_a_name_that_is_none_tells_those_there_are(site):  # R-E01
    prepared = prepare_run("nothing_like_it", site)
    (fault,) = prepared.faults
    assert prepared.plan is None
    assert fault.reason.key == "desk.application_unknown"
    assert str(fault.instead) == "nothing is run"


def test_everything_wrong_is_there_at_once_and_the_rest_is_compiled(laboratory, site):  # R-E01
    laboratory.configuration("lonelyC", "nobody 100")
    flow = [job("lonelyC"), job("nowhereC"), HOLE, job("jmoveC", "Joint job"), joints("home", *[0.0] * 6)]
    prepared = prepare_run(str(laboratory.application("wrong", flow)), site)
    sentences = [str(fault.reason) for fault in prepared.faults]
    for words in ("the task nobody", "the configuration nowhereC", "without holes"):
        assert any(words in sentence for sentence in sentences)
    assert [action.job for action in prepared.plan.flows[0].actions] == ["lonelyC", "nowhereC", "jmoveC"]
    assert len(prepared.targets) == 1


def test_an_icon_whose_file_is_cut_is_told_and_the_application_counts(laboratory, site):  # R-B07
    application = laboratory.application("cut", [job("jmoveC", "Joint job"), joints("home", *[0.0] * 6)])
    folder = laboratory.path / "dict"
    folder.mkdir(exist_ok=True)
    (folder / "jmoveC.onk").write_text("VERSION     2.0\n")
    prepared = prepare_run(str(application), site)
    assert prepared.faults == ()
    notes = [note for note in prepared.notes if note.place.file == str(folder / "jmoveC.onk")]
    assert [note.instead.key for note in notes] == ["desk.own_icon_counts"]


def test_an_application_that_cannot_be_read_has_no_plan(laboratory, site):  # R-B07
    path = laboratory.application("cut", [job("opengripC")])
    path.write_text("VERSION 1.3\nAPPLTYPE sideways\n")
    prepared = prepare_run(str(path), site)
    assert prepared.plan is None
    assert all(fault.place.file == str(path) for fault in prepared.faults)


def test_no_fault_is_told_twice(laboratory, site):
    laboratory.configuration("lonelyC", "nobody 100")
    prepared = prepare_run(str(laboratory.application("wrong", [job("lonelyC"), job("lonelyC")])), site)
    assert len(set(prepared.faults)) == len(prepared.faults)


def test_without_a_syntax_nothing_can_be_read(tmp_path, laboratory):  # reading 39
    path = laboratory.application("mine", [job("opengripC")])
    site = open_site([], {"ONIKA_DIR": str(tmp_path / "nowhere")}, None)
    prepared = prepare_run(str(path), site)
    assert prepared.plan is None
    assert "OnikaUpperSetUp.dta" in prepared.faults[0].place.file


def test_what_files_are_read_with_and_what_nobody_writes_are_notes(laboratory, site):  # reading 38, R-B11
    laboratory.plain_task("both", reads="X", writes="Y")
    path = laboratory.path / "module" / "both.rmod"
    path.write_text(path.read_text().replace("INCONST", "SVARALIAS   Y = X\nINCONST").replace("DESC ", "DESC  "))
    laboratory.module("both", "")
    laboratory.configuration("bothC", "both 100")
    icon = job("bothC").replace("PICT        8888", "PICT        9888", 1)
    prepared = prepare_run(str(laboratory.application("mine", [icon])), site)
    assert prepared.faults == ()
    assert [(note.reason, note.is_note) for note in prepared.notes] == [
        (Reason.of("files.picture_colours"), True),
        (Reason.of("rules.self_fed", task="both", svar="X"), True),  # reading 9, Equation (5)
    ]


@pytest.mark.parametrize("name", ["conf/wrongC.conf", "module/wrong.rmod"])
def test_a_file_at_fault_is_told_once_and_not_missed_again(laboratory, site, name):  # R-B07
    laboratory.module("wrong", "")
    laboratory.plain_task("wrong")
    laboratory.configuration("wrongC", "wrong 100")
    path = laboratory.path / name
    path.write_text(path.read_text().replace("EOF", ""))
    prepared = prepare_run(str(laboratory.application("mine", [job("wrongC"), job("wrongC")])), site)
    assert [fault.place.file for fault in prepared.faults] == [str(path)]


def test_a_directory_that_is_not_there_is_noted(tmp_path):  # R-C20
    site = open_site([], {"ONIKA_LOCAL": str(tmp_path / "typo")}, None)
    for name in ("go_home", "nothing_like_it"):
        assert [note.place.file for note in prepare_run(name, site).notes] == [str(tmp_path / "typo")]


def test_what_is_there_already_is_prepared_without_its_file(laboratory):  # R-E01, R-E12
    site = open_site([laboratory.path], {}, None)
    syntax, _ = site.syntax()
    laboratory.application("inner", [job("opengripC").replace("MARKER      no", "MARKER      yes")])
    laboratory.application("mine", [job("inner", "Complete application"), job("goneC")])
    application, _ = site.application("mine", syntax)
    prepared = prepare(application, Place("here"), site, syntax)
    assert [fault.place.file for fault in prepared.faults] == ["here"]
    assert prepared.plan.flows[0].actions[0].marker
    passing = prepare(application, Place("here"), site, syntax, passes_breakpoints=True)
    assert not passing.plan.flows[0].actions[0].marker


def test_a_fault_that_a_runtime_tells_is_one_like_any_other():
    text = FaultText(
        "play.appl", 7, Reason.plain("expected a target within reach, found none"), Reason.plain("nothing is run")
    )
    assert str(text.fault) == "play.appl:7: expected a target within reach, found none; instead: nothing is run"
