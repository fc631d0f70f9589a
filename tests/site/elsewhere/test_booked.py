"""A robot that is booked, with real processes: its user moves it, others look and stop (F09)."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from onika.desk.run.remote_runtime import connect
from onika.link.token import digest
from onika.wire import booking, live, request
from onika.words.reason import NOTHING

pytestmark = pytest.mark.site


@pytest.fixture
def address(tmp_path):
    """A runtime in virtual time whose robot is `arm`; ann and bob may come."""
    users = tmp_path / "users"
    users.write_text("".join(f"{name} programmer {digest(name)}\n" for name in ("ann", "bob")))
    users.chmod(0o600)
    words = ["--virtual", "--listen", "127.0.0.1:0", "--users", str(users), "--robot", "arm"]
    runtime = subprocess.Popen(
        [sys.executable, "-m", "onika.host", *words],
        stdout=subprocess.PIPE, text=True, env=os.environ | {"XDG_STATE_HOME": str(tmp_path / "state")},
    )  # fmt: skip
    yield runtime.stdout.readline().split("listening on ")[1].split(",")[0].strip()
    runtime.terminate()
    runtime.wait(20)
    runtime.stdout.close()


def test_who_has_booked_moves_the_robot_and_others_look_and_stop(address):  # R-F09
    with connect(address, "ann") as ann, connect(address, "bob") as bob:
        now_s = int(bob.ask(booking.Bookings()).now_s)
        booked = ann.ask(booking.Book(now_s, (now_s // 300 + 3) * 300))
        assert isinstance(booked, booking.Booked), booked
        assert isinstance(bob.ask(live.Take("s0")), request.Refused)
        assert isinstance(ann.ask(live.Take("s0")), request.Done)
        assert isinstance(bob.ask(booking.CancelBooking(booked.booking.number)), request.Refused)
        assert isinstance(bob.ask(request.Stop(NOTHING)), request.Done)
        assert "booked for ann" in str(bob.ask(live.Reset()).reason)
        assert isinstance(ann.ask(live.Reset()), request.Done)
        assert isinstance(ann.ask(booking.CancelBooking(booked.booking.number)), request.Done)
        assert isinstance(ann.ask(live.Release("s0")), request.Done)
        assert isinstance(bob.ask(live.Take("s0")), request.Done)


def test_a_book_that_cannot_be_used_keeps_the_runtime_from_starting(tmp_path):  # R-F09
    book = tmp_path / "book"
    book.write_text("no book at all " * 100)
    words = [Path(sys.executable).with_name("onika"), "runtime", "--virtual", "--no-console", "--listen", "127.0.0.1:0"]
    ran = subprocess.run(
        [*words, "--robot", "arm", "--book", str(book)], capture_output=True, text=True, check=False, timeout=60
    )
    assert ran.returncode == 2
    assert "cannot be used" in ran.stderr
