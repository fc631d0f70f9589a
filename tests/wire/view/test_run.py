import msgspec

from onika.wire import view


def test_a_flow_begins_ready():
    assert msgspec.to_builtins(view.FlowRunView(0)) == {"order": 0}
