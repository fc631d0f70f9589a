from functools import partial

import msgspec
import pytest

from kit.desk.random_acts import RandomUser
from onika.desk.environment.file import recovery_record
from onika.desk.environment.refresh import refreshed
from onika.files import conf
from onika.files.state import session_log
from onika.model.configuration import Configuration
from onika.wire import act, event, request
from onika.words.reason import Reason

from .conftest import TASKS, KeptSession, written


def files_of(player):
    return {**written(player.place.folder / "base0" / "lab"), **written(player.place.folder / "home" / "onika")}


def test_a_session_is_rebuilt_to_the_same_files(session):  # R-H08
    app = session.begun("grip", "move", "there")
    session.do(act.Save(app, "mine", str(session.lab)))
    doc = session.new("sine", "servo")
    session.do(act.Move(doc, {"sine": (60, 80)}))
    session.do(act.Undo(doc))
    session.do(act.Save(doc, "pair", str(session.lab)))
    player = session.replay(session.log)
    assert player.faults == []
    assert files_of(player) == session.files()
    assert {"appl/mine.appl", "conf/pair.conf"} <= files_of(player).keys()
    ours, theirs = session.environment.model, player.environment.model
    assert theirs.applications[app].application == ours.applications[app].application
    assert theirs.documents[doc].content == ours.documents[doc].content


@pytest.mark.parametrize("seed", range(3))
def test_random_sessions_are_rebuilt_to_the_same_files_and_the_same_open_documents(session, seed):  # R-H08
    user = RandomUser(seed, session, str(session.lab), tuple(task.name for task in TASKS))
    for _ in range(100):
        session.answer(user.next())
    for file in session.environment.model.open_files:
        session.answer(act.Save(file.id, f"last_{file.id}", str(session.lab)))
    player = session.replay(session.log)
    assert player.faults == []
    assert files_of(player) == session.files()
    assert seen(player.environment, player.place) == seen(session.environment, None, session)


def seen(environment, place, session=None):
    """What a page is shown of what is open, with the folders of the session."""
    tree = msgspec.to_builtins(environment.tree)
    parts = ("documents", "applications", "dictionaries", "libraries", "tasks", "clipboard", "own_undo", "files")
    text = msgspec.json.encode({name: tree[name] for name in parts if name in tree}).decode()
    folders = (
        {str(place.folder / "base0" / "lab"): "LAB", str(place.site.home): "HOME"}
        if session is None
        else {str(session.lab): "LAB", str(session.home): "HOME"}
    )
    for folder, name in folders.items():
        text = text.replace(folder, name)
    return msgspec.json.decode(text)


def edited(log, at, change):
    """The log with one line changed."""
    lines = log.splitlines()
    lines[at] = change(lines[at])
    return "\n".join(lines)


def keys(player):
    return [(fault.place.line, fault.reason.key) for fault in player.faults]


def saved(session):
    """A session that saves an application; its log, and the number of each line by its event."""
    app = session.begun("grip")
    session.do(act.InsertIcon(app, "open", "0", 1))
    session.do(act.Save(app, "mine", str(session.lab)))
    log = session.log
    return log, {line.split("\t")[1]: number for number, line in enumerate(log.splitlines())}


def test_of_a_cut_log_is_done_what_can_be_done_and_what_is_not_is_named(session):  # R-H08
    log, at = saved(session)
    lines = log.splitlines()
    player = session.replay("\n".join(line for k, line in enumerate(lines) if k != at["new_appl"]))
    assert keys(player)[0] == (3, "replay.lines_lack")
    assert {key for _, key in keys(player)[1:]} == {"replay.refused_now"}
    assert "appl/mine.appl" not in files_of(player)


def test_a_log_cut_in_the_midst_of_a_line_is_done_up_to_there(session):  # R-H08
    log, at = saved(session)
    text = "\n".join(log.splitlines()[: at["save_appl"] + 1])
    player = session.replay(text[:-30])
    assert keys(player) == [(at["save_appl"] + 1, "replay.line_cut")]
    assert "a1" in player.environment.model.applications and "appl/mine.appl" not in files_of(player)


def test_what_an_edited_line_says_is_done_and_the_line_is_named(session):  # R-H08
    log, at = saved(session)
    last = at["save_appl"]
    player = session.replay(edited(log, last, lambda line: line.replace('"name":"mine"', '"name":"other"')))
    assert keys(player) == [(last + 1, "replay.line_changed"), (last + 1, "replay.other_value")]
    assert "appl/other.appl" in files_of(player)


@pytest.mark.parametrize("place", ["/tmp", "{base0}/../../../..", "~", "~/../..", "../..", "file:///tmp"])
def test_nothing_is_written_outside_of_the_folder_whatever_a_log_says(session, tmp_path, place):  # R-H08
    log, at = saved(session)
    before = written(tmp_path)
    last = at["save_appl"]
    player = session.replay(edited(log, last, lambda line: line.replace('"base":"{base0}"', f'"base":"{place}"')))
    assert (last + 1, "replay.elsewhere") in keys(player)
    assert {path for path in written(tmp_path) if not path.startswith("replay/")} == before.keys()


def test_words_that_nobody_knows_are_named(session):  # R-H08
    log, at = saved(session)
    player = session.replay(edited(log, at["save_appl"], lambda line: line.replace('"t":"Save"', '"t":"Fly"')))
    assert keys(player)[-1] == (at["save_appl"] + 1, "replay.unknown_words")


def test_lines_of_another_session_are_left_out(session, tmp_path):  # R-H08
    log, _ = saved(session)
    lines = log.splitlines()
    strange = session_log.line(lines[2].split("\t")[:7], '{"s":"00","n":1,"act":{"t":"New"}}')
    player = session.replay("\n".join([*lines[:3], strange, *lines[3:]]))
    assert keys(player) == [(4, "replay.other_session")]
    assert files_of(player) == session.files()


def test_a_session_whose_beginning_was_cut_off_is_done_on_the_files_as_they_are(session):  # R-H08
    log, at = saved(session)
    player = session.replay("\n".join(log.splitlines()[2:]))
    assert keys(player) == [(1, "replay.lines_lack"), (1, "replay.start_lacks")]
    assert written(player.place.folder / "base0" / session.before.name) == session.files()
    assert at["new_appl"] == 2


def test_lines_of_another_session_at_the_top_do_not_make_it_that_one(session):  # R-H08
    log, _ = saved(session)
    lines = log.splitlines()
    strange = session_log.line(lines[2].split("\t")[:7], '{"s":"00","n":8,"act":{"t":"New"}}')
    bare = "\t".join(lines[2].split("\t")[:7])
    player = session.replay("\n".join([strange, bare, *lines]))
    assert keys(player) == [(1, "replay.other_session"), (2, "replay.line_cut")]
    assert files_of(player) == session.files()


def test_other_files_than_at_the_beginning_are_named(session):  # R-H08
    log, _ = saved(session)
    (session.before / "dict" / "new.onk").write_text("nonsense")
    (session.before / "module" / "sine.rmod").unlink()
    player = session.replay(log)
    assert {key for _, key in keys(player)} >= {"replay.file_new", "replay.file_lacks"}


def test_what_a_runtime_replied_and_told_is_told_again(session):  # R-H08
    doc = session.new("sine")
    answers = []
    session.environment.do(act.Connect(doc, "ws://robot:1", "secret"), "me", answers.append)
    for order in session.orders:
        session.environment.replied(order, request.Refused(Reason.plain("it is not there")))
    session.environment.receive(event.Stopped(True, Reason.plain("a hand")))
    log = session.log
    assert answers and "secret" not in log
    player = session.replay(log)
    assert player.faults == []
    assert player.environment.model.runtime == session.environment.model.runtime
    assert player.environment.model.runtime.is_stopped


def test_a_reply_that_lacks_leaves_its_act_unanswered_and_one_too_many_is_named(session):  # R-H08
    doc = session.new("sine")
    session.environment.do(act.Connect(doc, "ws://robot:1"), "me", lambda _: None)
    for order in session.orders:
        session.environment.replied(order, request.Refused(Reason.plain("it is not there")))
    lines = session.log.splitlines()
    silent = session.replay("\n".join(line for line in lines if "runtime_reply" not in line))
    assert "replay.not_answered" in {key for _, key in keys(silent)}
    lone = session.replay("\n".join(line for line in lines if "Connect" not in line))
    assert "replay.not_asked" in {key for _, key in keys(lone)}


def test_a_file_that_others_wrote_is_written_again(session):  # R-H08
    path = session.lab / "conf" / "theirs.conf"
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(conf.write(Configuration("theirs")).encode())
    session.diary.look([path])
    session.environment.become(partial(refreshed, changed={path}, site=session.site))
    doc = session.do(act.Open(str(path)))
    player = session.replay(session.log)
    assert player.faults == []
    assert files_of(player) == session.files() and doc in player.environment.model.documents


def test_documents_that_were_not_saved_before_the_session_are_there_again(tmp_path):  # R-H08
    first = KeptSession(tmp_path)
    doc = first.new("sine")
    kept = recovery_record.rescue_of(first.environment.model.documents[doc])
    assert "sine" in kept.text
    start = first.diary._record.nameless(recovery_record.write(kept))
    line = session_log.line(
        ("1.0", "Start_Onika", "none", "0", "none", "0", "root"),
        msgspec.json.encode({"s": "a", "n": 0, "start": {"unsaved": [start], "bases": [{"name": "lab"}]}}).decode(),
    )
    player = first.replay(line)
    assert [document.name for document in player.environment.model.documents.values()] == [kept.name]
