from typing import get_args

from onika.desk.environment.handlers import HANDLERS
from onika.wire import act


def test_every_act_has_its_handler():  # R-G04
    by_the_web = {act.Watch}  # of one browser, and no matter of the model
    assert set(HANDLERS) == set(get_args(act.AnyAct)) - by_the_web
