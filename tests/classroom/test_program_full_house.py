"""A class of twenty at once: all run their programs, and whoever floods, hangs or closes harms no other."""

import json
import os
import signal
from contextlib import ExitStack
from pathlib import Path

import pytest

from kit.process.class_process import ClassProcess, done, until
from kit.process.process_tree import descendants
from onika.process import confinement

pytestmark = [pytest.mark.site, pytest.mark.slow]

SEATS = 20


def seat_process(school, folder):
    """The process whose home lies there."""
    for pid in descendants(school.pid):
        try:
            if Path(f"/proc/{pid}/cwd").readlink() == folder.resolve() and os.getsid(pid) == pid:
                return pid
        except OSError:
            continue
    raise AssertionError(f"nobody is in {folder}")


def test_twenty_learners_run_their_programs_and_one_who_misbehaves_harms_no_other(tmp_path):  # R-X25
    words = ("--seats", str(SEATS), "go_home", *(() if confinement.level() else ("--unconfined",)))
    school = ClassProcess(tmp_path, *words)
    with ExitStack() as kept:
        kept.callback(school.end)
        names = [f"learner {number}" for number in range(SEATS)]
        sockets, docs = [], []
        for name in names:
            sockets.append(kept.enter_context(school.joined(name).talk()))
            tree = until(sockets[-1], lambda message: message["t"] == "Snapshot")["tree"]
            docs.append(next(iter(tree["applications"])))
        assert school.browser().join(school.code, "one more") == 409
        for name, socket, doc in zip(names, sockets, docs, strict=True):
            assert done(socket, t="Run", doc=doc)["t"] == "Ok"
            school.teacher.until(lambda rows, name=name: rows[name]["run"] == "completed")
        for _ in range(5000):
            sockets[0].send(json.dumps({"cid": 1, "act": {"t": "Undo", "doc": docs[0]}}))
        hung = seat_process(school, school.folder / "seats" / f"{school.seat(names[1]):02}")
        os.kill(hung, signal.SIGSTOP)
        try:
            sockets[2].close()
            for socket in sockets[3:]:
                assert done(socket, t="NewApplication")["t"] == "Ok"
            rows = school.teacher.until(lambda rows: rows[names[1]]["process"] != "there")
        finally:
            os.kill(hung, signal.SIGCONT)
        assert {rows[name]["process"] for name in names[3:]} == {"there"}
        rows = school.teacher.until(lambda rows: rows[names[2]]["pages"] == 0)
        assert rows[names[2]]["process"] == "there"
