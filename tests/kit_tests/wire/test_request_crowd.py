from kit.plans.plan_builder import action
from kit.wire.request_crowd import honest_requests, names_of
from kit.worlds.rail_world import rail_tasks
from onika.host.sessions.request_decoder import decode
from onika.wire import request


def test_every_honest_request_is_taken_by_a_runtime():
    plan = rail_tasks().plan([action("mass", "servo", arguments="1.0")])
    for message in honest_requests([plan], ("mass", "servo")):
        assert decode(request.encode(message)) == message


def test_the_names_are_those_of_the_plan():
    names = names_of(rail_tasks().plan([action("mass", "servo", arguments="1.0")]), "yard")
    assert names["task"] == ("mass", "servo")
    assert {"X", "FORCE"} <= {*names["name"]}
    assert names["world"] == ("yard",)
