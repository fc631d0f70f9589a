"""A class as a process, from outside: what its people see of each other, and what they cannot reach."""

import json
import time
from pathlib import Path

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from kit.process.class_process import PATIENCE_S, ClassProcess, done, until
from kit.process.process_tree import descendants
from onika.process import confinement

pytestmark = pytest.mark.site


def first_tree(socket):
    return until(socket, lambda message: message["t"] == "Snapshot")["tree"]


def test_two_learners_have_a_page_of_their_own_and_the_board_shows_who_is_where(school):  # R-X25
    ana, ben = school.joined("Ana"), school.joined("Ben")
    assert ana.host != ben.host
    with ana.talk() as one, ben.talk() as two:
        trees = [first_tree(socket) for socket in (one, two)]
        assert [[app["name"] for app in tree["applications"].values()] for tree in trees] == [["go_home"]] * 2
        rows = school.teacher.until(lambda rows: all(rows[name]["pages"] == 1 for name in ("Ana", "Ben")))
        assert [(rows[name]["seat"], rows[name]["program"]) for name in ("Ana", "Ben")] == [
            (1, "go_home"),
            (2, "go_home"),
        ]
        doc = next(iter(trees[0]["applications"]))
        assert done(one, t="RemoveIcons", doc=doc, steps=[1])["t"] == "Ok"
        rows = school.teacher.until(lambda rows: rows["Ana"]["steps"] > rows["Ben"]["steps"])
    school.teacher.until(lambda rows: rows["Ana"]["pages"] == 0)


def test_nobody_reaches_the_seat_of_another(school):  # R-X25
    eve, ana = school.joined("Eve"), school.browser()
    school.joined("Ana")
    assert ana.join(school.code, "Ana") == 409
    rows = school.teacher.board()
    assert school.teacher.follow(f"{school.address}board/watch/{rows['Ana']['seat']}") == 200
    other = school.teacher.host
    stolen = f"onika-{other.rpartition(':')[2]}"
    own = eve.cookies[f"onika-{eve.host.rpartition(':')[2]}"]
    for cookies in (eve.cookies, {**eve.cookies, stolen: own}):
        eve.cookies = dict(cookies)
        assert eve.ask("GET", f"http://{other}/")[0] == 403
        assert eve.ask("POST", f"http://{other}/hand-in")[0] == 403
        assert eve.ask("GET", f"http://{other}/enter?key=guess")[0] == 403
        with pytest.raises(InvalidStatus), eve.talk(other):
            pass
    assert eve.ask("GET", "/board/state")[0] == 403


def test_what_a_learner_opens_or_saves_stays_within_his_seat(school):  # R-X25
    school.joined("Ana")
    eve = school.joined("Mallory")
    target = school.folder / "seats" / f"{school.seat('Ana'):02}" / "home" / "onika" / "appl" / "go_home.appl"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text("theirs")
    with eve.talk() as socket:
        tree = first_tree(socket)
        doc = next(iter(tree["applications"]))
        answer = done(socket, t="Open", path=str(target))
        wrote = done(socket, t="Save", doc=doc, name="go_home", base=str(target.parent.parent), overwrites=True)
        assert (
            done(socket, t="WriteText", task="jmove", kind="code", text="x", stamp="")["reason"]["key"]
            == "class.code_closed"
        )
    assert target.read_text() == "theirs" or not confinement.level()
    assert "theirs" not in json.dumps(answer)
    assert wrote["t"] == "Refused" or not confinement.level()


def test_a_frozen_seat_can_be_stopped_only_and_a_taken_one_is_the_teachers(school):  # R-X25
    ana = school.joined("Ana")
    seat = school.seat("Ana")
    assert school.teacher.follow(f"{school.address}board/watch/{seat}") == 200
    with ana.talk() as learner, school.teacher.talk() as teacher:
        doc = next(iter(first_tree(learner)["applications"]))
        edit = {"t": "NewApplication"}
        assert done(teacher, **edit)["reason"]["key"] == "class.teacher_watches"
        assert school.teacher.wish("freeze", seat) == 204
        until(learner, lambda message: message["t"] == "Patch" and '"frozen"' in json.dumps(message))
        assert done(learner, **edit)["reason"]["key"] == "class.learner_frozen"
        assert done(learner, t="Stop")["t"] in ("Ok", "Refused")
        school.teacher.wish("take", seat)
        until(learner, lambda message: message["t"] == "Patch" and '"taken"' in json.dumps(message))
        assert done(learner, **edit)["reason"]["key"] == "class.learner_taken"
        assert done(teacher, **edit)["t"] == "Ok"
        school.teacher.wish("tell", seat, text="look here")
        until(learner, lambda message: "look here" in json.dumps(message))
        school.teacher.wish("release", seat)
        until(learner, lambda message: message["t"] == "Patch" and "class_seat" in json.dumps(message))
        assert done(learner, **edit)["t"] == "Ok"
        rows = school.teacher.until(lambda rows: rows["Ana"]["refusal"]["key"] == "class.learner_taken")
        assert doc
        assert rows["Ana"]["note"] == "look here"


def test_what_is_handed_in_is_graded(school):  # R-X25
    ana, ben = school.joined("Ana"), school.joined("Ben")
    seats = [school.seat(name) for name in ("Ana", "Ben")]
    before = school.teacher.board()["Ana"]["handed_in"]
    assert ana
    assert ben.hand_in() == 204
    rows = school.teacher.until(lambda rows: rows["Ben"]["expectations"] or rows["Ben"]["grade_why"]["text"])
    assert [(one["text"], one["holds"]) for one in rows["Ben"]["expectations"]] == [("Q_MEZ[0] > -9", True)], rows[
        "Ben"
    ]
    school.teacher.wish("collect", seats[0])
    school.teacher.until(lambda rows: rows["Ana"]["handed_in"] > before)
    assert (school.folder / "handed-in" / f"{seats[1]:02} Ben" / "0001" / "appl" / "go_home.appl").is_file()


def test_a_seat_that_floods_or_is_ended_harms_no_other(school):  # R-X25
    ana, ben = school.joined("Ana"), school.joined("Ben")
    with ana.talk() as one, ben.talk() as two:
        first_tree(two)
        for number in range(3000):
            one.send(json.dumps({"cid": number, "act": {"t": "Undo", "doc": "a1"}}))
        assert done(two, t="NewApplication")["t"] == "Ok"
        assert school.teacher.wish("restart", school.seat("Ana")) == 204
        rows = school.teacher.board()
        assert (rows["Ana"]["process"], rows["Ana"]["ended"]["key"]) == ("off", "class.ended_by_teacher")
        assert rows["Ben"]["process"] == "there"
        assert done(two, t="NewApplication")["t"] == "Ok"
        with pytest.raises(ConnectionClosed):
            while True:
                one.recv(timeout=60)
    assert ana.follow(f"{school.address}seat") == 200


def test_a_class_that_is_opened_again_knows_its_learners_and_nothing_of_it_is_left(tmp_path):  # R-X25
    words = ("--seats", "2", "go_home", *(() if confinement.level() else ("--unconfined",)))
    process = ClassProcess(tmp_path, *words)
    ana = process.joined("Ana")
    with ana.talk() as socket:
        doc = next(iter(first_tree(socket)["applications"]))
        assert done(socket, t="RemoveIcons", doc=doc, steps=[1])["t"] == "Ok"
        process.teacher.wish("freeze", 1)
    left = [Path(f"/proc/{pid}") for pid in descendants(process.pid)]
    assert len(left) >= 2
    assert process.end() in (0, 130)
    until_s = time.monotonic() + PATIENCE_S
    while any(path.exists() for path in left):  # the server of forks sees the end of its class by itself
        assert time.monotonic() < until_s
        time.sleep(0.01)
    again = ClassProcess(tmp_path, *words)
    try:
        port = process.address.rstrip("/").rpartition(":")[2]
        token = ana.cookies[f"onika-class-{port}"]
        new = again.browser()
        new.cookies = {f"onika-class-{again.address.rstrip('/').rpartition(':')[2]}": token}
        assert new.follow(f"{again.address}seat") == 200
        with new.talk() as socket:
            tree = first_tree(socket)
            assert tree["class_seat"]["state"] == "frozen"
            assert any(app.get("is_dirty") for app in tree["applications"].values())
    finally:
        assert again.end() in (0, 130)
