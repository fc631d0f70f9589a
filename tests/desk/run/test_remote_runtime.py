import pytest

from onika.desk.run.remote_runtime import RemoteRuntime, connect
from onika.link.lost import LinkLost, LossCause


@pytest.fixture
def no_token(monkeypatch, tmp_path):
    monkeypatch.delenv("ONIKA_TOKEN", raising=False)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))


@pytest.mark.parametrize("url", ["ws://127.0.0.1:1", "wss://robot.example:7000"])
def test_a_runtime_is_not_reached_without_a_token(no_token, url):
    with pytest.raises(LinkLost) as lost:
        connect(url)
    assert (lost.value.cause, lost.value.reason.key) == (LossCause.TOKEN, "link.token_needed")


def test_a_token_is_given_or_stands_in_the_environment(no_token, monkeypatch):
    assert isinstance(connect("ws://127.0.0.1:1", "given"), RemoteRuntime)
    monkeypatch.setenv("ONIKA_TOKEN", "from the environment")
    assert isinstance(connect("ws://127.0.0.1:1"), RemoteRuntime)


def test_what_is_no_address_is_an_error_before_anything_is_opened(no_token):
    with pytest.raises(ValueError):
        connect("http//robot")


def test_nobody_at_the_address_is_told_as_a_lost_link():  # R-E10
    with pytest.raises(LinkLost), connect("ws://127.0.0.1:1", "given"):
        pass
