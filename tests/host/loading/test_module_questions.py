import inspect

import pytest

from kit.worlds.rail_world import YardLoading
from onika.host.loading.loader_client import LoaderClient
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.module_questions import ModuleQuestions

QUESTIONS = sorted(
    name for name, member in vars(ModuleQuestions).items() if inspect.isfunction(member) and not name.startswith("_")
)


@pytest.mark.parametrize("name", QUESTIONS)
@pytest.mark.parametrize("answerer", [ModuleFacts, LoaderClient, YardLoading])
def test_whoever_answers_is_asked_alike(answerer, name):  # law 21
    wanted, given = (inspect.signature(getattr(owner, name)).parameters for owner in (ModuleQuestions, answerer))
    assert list(given) == list(wanted)


def test_there_is_something_to_ask():
    assert {"sheet", "constants", "devices", "resolve"} <= set(QUESTIONS)
