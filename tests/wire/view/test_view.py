import msgspec

from onika.wire import act, view


def test_what_is_as_usual_does_not_travel():
    assert msgspec.to_builtins(view.PlacedView(1, 2)) == {"x": 1, "y": 2}
    assert msgspec.to_builtins(view.Tree()) == {}


def test_a_remedy_carries_its_act_with_its_name():  # R-X01
    remedy = view.Remedy("Clear", act.Clear("c1", "pd"))
    assert msgspec.to_builtins(remedy)["act"] == {"t": "Clear", "doc": "c1", "task": "pd"}


def test_a_tree_travels_whole():
    document = view.DocumentView("a", 0, tasks={"pd": view.PlacedView(1, 2, state="ON")})
    tree = view.Tree(documents={"c1": document}, tasks={"pd": view.TaskView("pd", "pd", "lib", 0, "", 1, 2, ())})
    assert msgspec.json.decode(msgspec.json.encode(tree), type=view.Tree) == tree
