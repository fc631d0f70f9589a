from dataclasses import replace
from itertools import pairwise

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.diary import Diary
from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.reconcile import runtime_loss
from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.run import begun
from onika.desk.environment.session_start import SessionStart
from onika.files.state import session_log
from onika.wire import act, event, request
from onika.wire.plan import Plan
from onika.words.reason import Reason


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path)


def kept(sitting, folder, clock=lambda: 770908202.0):
    diary = Diary(folder, lambda: sitting.environment.model, sitting.say, clock)
    sitting.environment.observers.append(diary.observe)
    return diary


def lines(diary):
    return [line.split("\t")[1:4] for line in diary.path.read_text().splitlines()[1:]]


def test_a_session_is_a_file_with_a_line_of_every_act(sitting, tmp_path):  # R-H01
    diary = kept(sitting, tmp_path / "state" / "diary")
    doc = sitting.do(act.New())
    sitting.answer(act.Place(doc, "gone", 0, 0))
    sitting.do(act.Note("select_icon", "pd", "7", window="lexi"))
    sitting.do(act.Close(doc))
    diary.close()
    assert lines(diary) == [
        ["Start_Onika", "none", "0"],
        ["new_conf", "Untitled-1", "c1"],
        ["try_insert_icon", "gone", "c1/gone"],
        ["enter_values", "x,y", '{"x":0,"y":0}'],
        ["select_icon", "pd", "7"],
        ["close_conf", "Untitled-1", "c1"],
        ["Quit_Onika", "none", "0"],
    ]
    assert diary.path.parent == tmp_path / "state" / "diary"
    assert diary.path.name.startswith("1994-06-0")
    assert diary.path.suffix == ".log"


def test_a_line_is_on_the_disk_while_the_session_goes_on(sitting, tmp_path):  # R-H01
    diary = kept(sitting, tmp_path)
    sitting.do(act.New())
    diary._lines.put(None)
    diary._thread.join(30)
    assert lines(diary)[-1][0] == "new_conf"


def run_of(number, **view):
    return begun("a1", Plan("assemble", (), ()), number, 0.0, StepMembership({}, {})).shown(**view)


def test_a_run_is_written_down_when_it_ends_and_once(sitting, tmp_path):  # R-H01
    diary = kept(sitting, tmp_path)
    model = sitting.environment.model
    first, second = run_of(1, state="running"), run_of(2, state="running")
    both = replace(model, run=second, beside={1: first})
    ended = both.with_run(first.shown(state="over", cause=Reason.plain("it was stopped")))
    done = ended.with_run(second.shown(state="over", is_completed=True))
    changes = [model, both, both, ended, ended, done, done, model]
    for before, after in pairwise(changes):
        diary.follow(before, after)
    diary.close()
    text = [line.split("\t")[1:7] for line in diary.path.read_text().splitlines()]
    assert [line for line in text if line[0] == "end_appl"] == [
        ["end_appl", "assemble", "a1", "it was stopped", "1", "appl"],
        ["end_appl", "assemble", "a1", "completed", "2", "appl"],
    ]


def test_an_environment_tells_what_follows_it_of_every_change(sitting):  # R-H01
    changes = []
    sitting.environment.followers.append(lambda before, after: changes.append((before, after)))
    before = sitting.environment.model
    sitting.do(act.New())
    assert changes == [(before, sitting.environment.model)]


def test_what_was_taken_back_stands_in_the_diary(sitting, tmp_path):  # R-H01, R-X10
    diary = kept(sitting, tmp_path)
    sitting.do(act.Prefer({"shows_period": True}))
    label = sitting.environment.model.own.last.label
    sitting.do(act.Undo(""))
    sitting.do(act.Redo(""))
    diary.close()
    text = [line.split("\t")[1:7] for line in diary.path.read_text().splitlines()]
    assert [line[3:5] for line in text if line[0] in ("undo", "redo")] == [[label.text, label.key]] * 2


def test_without_the_habit_nothing_is_written(sitting, tmp_path):  # R-H01
    sitting.do(act.Prefer({"keeps_diary": False}))
    diary = kept(sitting, tmp_path / "diary")
    sitting.do(act.New())
    diary.close()
    assert not (tmp_path / "diary").exists()


def test_where_it_cannot_be_written_that_is_said_once_and_acts_go_on(sitting, tmp_path):  # R-H01
    (tmp_path / "diary").write_text("no folder")
    diary = kept(sitting, tmp_path / "diary")
    diary._thread.join(30)
    sitting.do(act.New())
    sitting.do(act.New())
    diary.close()
    (say,) = sitting.says
    assert say.level == "warning"
    assert say.text.key == "run.diary_unwritten" and say.text.args["path"] == str(diary.path)


def test_a_file_is_bounded_and_the_session_goes_on_in_a_next_one(sitting, tmp_path):  # R-H01
    diary = Diary(tmp_path, lambda: sitting.environment.model, sitting.say, lambda: 770908202.0, limit=700)
    sitting.environment.observers.append(diary.observe)
    for _ in range(12):
        sitting.do(act.New())
    diary.close(30)
    files = list(tmp_path.glob("*.log"))
    acts = [line.split("\t")[1] for path in files for line in path.read_text().splitlines()[1:]]
    assert len(files) > 1 and all(path.stat().st_size < 1400 for path in files)
    assert sorted(acts) == sorted(["Start_Onika", *["new_conf"] * 12, "Quit_Onika"])
    assert all(path.stat().st_mode & 0o077 == 0 for path in files)


def test_of_all_sessions_the_newest_files_are_kept(sitting, tmp_path):  # R-H01
    for number in range(5):
        (tmp_path / f"{number}.log").write_text("")
    diary = Diary(tmp_path, lambda: sitting.environment.model, sitting.say, kept=3)
    diary.close(30)
    assert {path.name for path in tmp_path.iterdir()} == {"3.log", "4.log", diary.path.name}


def read_log(diary):
    lines, faults = session_log.read(diary.path.read_text(), diary.path.name)
    assert faults == ()
    return lines


def test_an_act_has_its_place_when_it_begins_and_its_line_when_it_ends(sitting, tmp_path):  # R-H08
    diary = kept(sitting, tmp_path)
    begun = diary.observe(act.New(), "me")
    diary.hear("", "Prepare", request.Done())
    begun(ActAnswer("c1"))
    diary.close()
    assert [line.event for line in read_log(diary)] == ["Start_Onika", "new_conf", "runtime_reply", "Quit_Onika"]
    assert [line.split("\t")[1] for line in diary.path.read_text().splitlines()[2:4]] == ["runtime_reply", "new_conf"]


def test_what_a_runtime_has_told_and_that_it_was_lost_stand_in_the_diary(sitting, tmp_path):  # R-H08
    diary = kept(sitting, tmp_path)
    sitting.environment.listening.append(diary.hear)
    sitting.environment.followers.append(diary.follow)
    sitting.environment.receive(event.Stopped(True, Reason.plain("a hand")))
    sitting.environment.become(lambda model: runtime_loss.lost(model, Reason.plain("gone")))
    diary.close()
    _, stopped, lost, _ = read_log(diary)
    assert (stopped.event, stopped.object, stopped.record["event"]["is_stopped"]) == ("runtime_event", "Stopped", True)
    assert (lost.event, lost.record["lost"]["text"]) == ("runtime_lost", "gone")


def test_what_others_have_written_stands_in_the_diary(sitting, tmp_path):  # R-H08
    path = tmp_path / "conf" / "a.conf"
    path.parent.mkdir()
    path.write_text("VERSION 1\n")
    diary = Diary(tmp_path / "diary", lambda: sitting.environment.model, sitting.say, start=SessionStart(sitting.site))
    diary.look([path, tmp_path / "conf" / "gone.conf"])
    diary.close()
    _, written, gone, _ = read_log(diary)
    assert (written.record["file"], written.record["text"]) == ("{base0}/conf/a.conf", "VERSION 1\n")
    assert not gone.record["is_there"] and "text" not in gone.record


def test_what_was_done_while_no_diary_was_wanted_is_told_as_a_gap(sitting, tmp_path):  # R-H08, R-H01
    diary = kept(sitting, tmp_path)
    sitting.do(act.Prefer({"keeps_diary": False}))
    sitting.do(act.New())
    sitting.do(act.Prefer({"keeps_diary": True}))
    diary.close()
    lines, faults = session_log.read(diary.path.read_text(), "d")
    assert not any(line.event == "new_conf" for line in lines)
    assert [fault.reason.key for fault in faults] == ["replay.lines_lack"]
