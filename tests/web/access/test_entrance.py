import inspect

import pytest

from onika.link.caller import Role
from onika.web.access.entrance import OWNER, Entrance
from onika.web.access.sign_in import SignIn
from onika.web.login import Login


def test_whoever_has_the_key_of_this_machine_may_everything_and_has_no_name():
    assert (OWNER.role, OWNER.user, OWNER.session) == (Role.OWNER, "", "")


@pytest.mark.parametrize("kind", [Login, SignIn])
def test_both_entrances_answer_what_is_asked_of_one(kind):
    for name, function in inspect.getmembers(Entrance, inspect.isfunction):
        if not name.startswith("_"):
            assert list(inspect.signature(getattr(kind, name)).parameters) == list(
                inspect.signature(function).parameters
            )
