"""Readiness: an application can be run for us exactly if it can for the naive reading."""

import pytest
from hypothesis import event, given, settings

from kit.examples import examples
from onika.model.application import Application
from onika.model.configuration import Configuration
from onika.model.rules import readiness
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.words.fault import Place

from .drawn import edges_of, laboratories
from .ready import is_ready

Laboratory = tuple[Application, Syntax, dict[str, Configuration], dict[str, Task]]


def agree(laboratory: Laboratory) -> None:
    application, syntax, configurations, tasks = laboratory
    expected = is_ready(application, edges_of(syntax), configurations, tasks)
    event(f"can be run: {expected}")
    faults = readiness.faults(application, syntax, configurations, tasks, Place("app.appl"))
    assert (not faults) == expected, faults


@given(laboratories())
@settings(max_examples=examples(150), deadline=None)
def test_any_application_can_be_run_for_both_or_for_neither(laboratory: Laboratory) -> None:
    agree(laboratory)  # R-E01


@pytest.mark.slow
@given(laboratories())
@settings(max_examples=examples(4000), deadline=None)
def test_thousands_of_applications_can_be_run_for_both_or_for_neither(laboratory: Laboratory) -> None:
    agree(laboratory)  # R-E01
