from time import monotonic_ns

import pytest

from onika.link.child.launcher import launch
from onika.link.connection import Connection
from onika.link.link_terms import CHILD
from onika.link.lost import LinkLost
from onika.wire import request

pytestmark = pytest.mark.site

MODES = pytest.mark.parametrize("mode", [["--virtual"], ["--no-fifo", "--rtpu", "a", "--rtpu", "b"]])


def connected(child):
    connection = Connection(child.carrier, monotonic_ns, CHILD)
    connection.open(30.0)
    return connection


def ask(connection, message):
    return request.decode_response(connection.request(request.encode(message), 30.0))


@MODES
def test_a_runtime_answers_and_quits_when_it_is_told(mode):  # R-F01, R-A15
    with launch(mode) as child:
        connection = connected(child)
        assert ask(connection, request.Snapshot()) == request.Worlds({})
        assert isinstance(ask(connection, request.Begin()), request.Refused)
        assert ask(connection, request.Quit()) == request.Done()
        assert child.wait(20.0) == 0
        assert child.tail() == ""


@MODES
def test_a_runtime_ends_when_the_environment_goes(mode):  # R-E10
    with launch(mode) as child:
        connected(child).close()
        assert child.wait(20.0) == 0


@MODES
def test_a_runtime_ends_when_the_connection_is_cut(mode):  # R-E10
    with launch(mode) as child:
        connected(child)
        child.carrier.close()
        assert child.wait(20.0) == 0


def test_a_wrong_command_line_is_told():
    with launch(["--sideways"]) as child:
        assert child.wait(20.0) == 2
        assert "--sideways" in child.tail()
        with pytest.raises(LinkLost):
            connected(child)


def test_files_that_say_who_is_let_in_are_closed_to_others_and_that_is_told(tmp_path):  # R-X12
    users, audit = tmp_path / "users", tmp_path / "audit.log"
    for path in (users, audit):
        path.write_text("")
        path.chmod(0o666)
    with launch(["--virtual", "--users", str(users), "--audit", str(audit)]) as child:
        assert ask(connected(child), request.Quit()) == request.Done()
        assert child.wait(20.0) == 0
        assert str(users) in child.tail() and str(audit) in child.tail()
    assert [path.stat().st_mode & 0o777 for path in (users, audit)] == [0o644, 0o644]
