import subprocess
from importlib import metadata

import pytest

from onika.desk.run import machine
from onika.desk.run.machine import Feature, features
from onika.words.reason import Reason


def test_every_offer_says_what_was_found_and_what_lacking_it_costs():  # law 31
    every = list(features())
    names = [str(feature.name) for feature in every]
    assert names[:6] == ["system", "python", "processors", "SCHED_FIFO", "memory lock", "sandbox"]
    assert {"numpy", "msgspec", "mujoco", "ruckig", "rich", "graphics"} <= set(names)
    for feature in every:
        assert feature.actual
        assert "\n" not in str(feature.actual)
        assert feature.is_there or feature.cost


def test_where_the_kernel_has_no_landlock_it_is_told_what_that_costs(monkeypatch):  # R-X16
    monkeypatch.setattr(machine.confinement, "level", lambda: 0)
    sandbox = machine._sandbox()
    assert (sandbox.is_there, str(sandbox.actual)) == (False, "not there")
    assert "is not run" in str(sandbox.cost)


def test_a_library_that_is_missing_is_told_with_its_cost(monkeypatch):  # law 31
    def missing(name):
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(machine.metadata, "version", missing)
    cost = Reason.of("desk.cost_nothing_runs")
    absent = Reason.of("desk.machine_not_installed")
    assert machine._library("numpy", cost) == Feature(Reason.plain("numpy"), False, absent, cost)


@pytest.mark.parametrize(("code", "there", "actual"), [(0, True, "granted"), (1, False, "refused")])
def test_real_time_is_what_the_operating_system_grants_a_child(monkeypatch, code, there, actual):  # law 31
    done = subprocess.CompletedProcess([], code, "", "")
    monkeypatch.setattr(machine.subprocess, "run", lambda *_, **__: done)
    offer = machine._fifo()
    assert (offer.is_there, str(offer.actual)) == (there, actual)
    assert "rtprio" in str(offer.cost)


@pytest.mark.parametrize(
    ("done", "there", "actual"),
    [
        ((0, "egl\n", ""), True, "drawn with egl"),
        ((3, "", "one\n"), False, str(Reason.of("desk.no_opengl"))),
        ((2, "", "one\nno snapshot\n"), False, "no snapshot"),
        ((1, "", ""), False, "no answer"),
    ],
)
def test_graphics_is_what_the_drawing_program_says(monkeypatch, done, there, actual):  # law 31
    monkeypatch.setattr(machine.subprocess, "run", lambda *_, **__: subprocess.CompletedProcess([], *done))
    offer = machine._graphics()
    assert (offer.is_there, str(offer.actual)) == (there, actual)


def test_one_processor_is_too_few(monkeypatch):  # law 31
    monkeypatch.setattr(machine.os, "sched_getaffinity", lambda _pid: {0})
    assert not machine._processors().is_there
    monkeypatch.setattr(machine.os, "sched_getaffinity", lambda _pid: {0, 1})
    assert machine._processors() == Feature(
        Reason.of("desk.machine_processors"), True, Reason.plain("2"), machine._processors().cost
    )
