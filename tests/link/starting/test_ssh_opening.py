"""What ssh says when it does not come about, each in its own words; `tests/site/elsewhere` has a real sshd."""

import pytest

from onika.link.channel import Channel
from onika.link.lost import LinkLost, LossCause
from onika.link.starting import ssh_opening as room
from onika.link.starting.ssh_address import SshAddress
from onika.link.starting.ssh_opening import SshOpening
from onika.wire.hand_over import HandOver, line_of

ROBOT = SshAddress("robot")
HANDED_OVER = line_of(HandOver(4711, "token", 12))


@pytest.fixture
def ssh(tmp_path):
    """A program in the place of ssh."""

    def written(text):
        path = tmp_path / "ssh"
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(0o755)
        return SshOpening(ROBOT, str(path))

    return written


def why(opening):
    with pytest.raises(LinkLost) as lost:
        opening(Channel.SIGNAL)
    opening.close()
    return lost.value


@pytest.mark.parametrize(
    ("script", "cause", "words"),
    [
        ("echo 'Permission denied (publickey).' >&2; exit 255", LossCause.UNREACHABLE, "Permission denied (publickey)"),
        ("echo 'sh: onika: not found' >&2; exit 127", LossCause.REFUSED, "name its path behind the host"),
        ("echo 'sh: not allowed' >&2; exit 126", LossCause.REFUSED, "name its path behind the host"),
        ("echo 'no such option' >&2; exit 2", LossCause.REFUSED, "it ended with code 2 (no such option)"),
        ("echo welcome; exit 0", LossCause.REFUSED, "it ended with code 0"),
    ],
)
def test_each_way_in_which_it_does_not_come_about_is_told(ssh, script, cause, words):  # R-A15
    lost = why(ssh(script))
    assert lost.cause is cause
    assert words in str(lost)


def test_without_ssh_that_is_said(tmp_path):  # R-A15
    lost = why(SshOpening(ROBOT, str(tmp_path / "none")))
    assert lost.cause is LossCause.UNREACHABLE
    assert "cannot be started" in str(lost)


def test_a_machine_that_says_nothing_is_not_waited_for_for_ever(ssh, monkeypatch):  # R-A15
    monkeypatch.setattr(room, "START_S", 0.2)
    lost = why(ssh("exec cat"))
    assert lost.cause is LossCause.TIMEOUT
    assert "within 0.2 s" in str(lost)


def test_greetings_of_a_machine_are_passed_over_and_a_tunnel_that_is_refused_is_told(ssh):  # R-A15
    greeting = "i=0; while [ $i -lt 3000 ]; do echo 'Welcome to the machine, and mind the robot'; i=$((i+1)); done"
    forward = 'case "$*" in *forward*) echo "forwarding is prohibited" >&2; exit 1;; esac'
    lost = why(ssh(f"{forward}\n{greeting}\necho '{HANDED_OVER}'\nexec cat"))
    assert lost.cause is LossCause.REFUSED
    assert "lets no tunnel through: forwarding is prohibited" in str(lost)


def test_after_its_end_nothing_is_opened_or_started_any_more(ssh):  # R-A15
    opening = ssh("exit 255")
    opening.close()
    lost = why(opening)
    assert lost.is_final
    assert "has ended" in str(lost)


def test_everything_that_is_called_ends_with_where_to(ssh, tmp_path):  # R-A15
    noted = tmp_path / "words"
    why(ssh(f'echo "$@" > {noted}; exit 255'))
    words = noted.read_text().split()
    assert words[-4:] == ["robot", "onika", "runtime", "--hand-over"]
    assert words[-5] == "--"
    assert "BatchMode=yes" in words
