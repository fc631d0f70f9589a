import pytest

from onika.desk.environment.outcome.outcome import Simulator
from onika.desk.environment.reconcile.runtime_launch import RuntimeLauncher
from onika.link.lost import LinkLost


def test_what_is_no_address_is_said_as_it_is(monkeypatch):  # R-C18
    monkeypatch.delenv("ONIKA_TOKEN", raising=False)
    with pytest.raises(ValueError, match="nowhere at all"):
        RuntimeLauncher()("nowhere at all", "")


def test_a_runtime_on_another_machine_needs_a_token(monkeypatch):  # R-C18
    monkeypatch.delenv("ONIKA_TOKEN", raising=False)
    with pytest.raises(LinkLost, match="token is needed"):
        RuntimeLauncher()("wss://lab.example:7994", "")


@pytest.mark.site
def test_a_simulator_has_the_units_it_is_asked_for_and_the_pace_of_the_wall():  # R-X05, A16
    from onika.wire import live

    with RuntimeLauncher()("", "", Simulator(("left",))) as runtime:
        standing = runtime.ask(live.Survey())
    assert [unit.name for unit in standing.rtpus] == ["left"] and standing.is_virtual


@pytest.mark.site
def test_without_an_address_a_runtime_with_these_units_is_started():  # R-A15
    from onika.wire import live

    with RuntimeLauncher(("left", "right"), is_virtual=True)("", "") as runtime:
        standing = runtime.ask(live.Survey())
    assert [unit.name for unit in standing.rtpus] == ["left", "right"] and standing.is_virtual
