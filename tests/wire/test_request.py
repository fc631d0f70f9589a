import msgspec
import pytest

from kit.plans.plan_builder import action
from kit.worlds.rail_world import rail_tasks
from onika.wire import request


@pytest.mark.parametrize("body", [b"", b"\xc0", b"\x81\xa4type\xa4Jump", b"\x80", request.encode(request.Done())])
def test_what_is_no_request_is_a_value_error(body):
    with pytest.raises(ValueError):
        request.decode_request(body)


def test_a_request_cut_anywhere_is_a_value_error():
    whole = request.encode(request.Prepare(rail_tasks().plan([action("mass", "servo", arguments="1")]), ()))
    for end in range(len(whole)):
        with pytest.raises(msgspec.DecodeError):
            request.decode_request(whole[:end])
