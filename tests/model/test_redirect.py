import pytest

from onika.model.redirect import Redirect, choice, world_choice


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("puma=scara", Redirect("puma", "scara")),
        ("0:puma=scara", Redirect("puma", "scara", "0")),
        (" flow0.1:puma=puma_kin ", Redirect("puma", "puma_kin", "flow0.1")),
        ("cell:=boxes:", Redirect("cell:", "boxes:")),
        ("1:boxes:=boxes@copy:", Redirect("boxes:", "boxes@copy:", "1")),
    ],
)
def test_a_redirection_is_read_and_shown_as_it_is_written(text, expected):  # R-E09
    assert Redirect.parse(text) == expected
    assert str(expected) == text.strip()


@pytest.mark.parametrize(
    "text",
    [
        *("", "puma", "puma=", "=scara", "a=b=c", "0:puma", "1puma=scara", "puma=sca ra", ":a=b"),
        *("cell:=boxes", "cell=boxes:", "cell:=:", "cell:=b@:", "cell:=b@c@d:"),
    ],
)
def test_what_is_none_is_refused_with_what_was_expected(text):  # R-E09
    with pytest.raises(ValueError, match=r"expected \[FLOW:\]TASK=TASK or \[FLOW:\]WORLD:=WORLD:, found"):
        Redirect.parse(text)


def test_it_holds_in_every_flow_or_in_one_with_all_that_is_nested_there():  # R-E09
    assert all(Redirect("a", "b").holds_in(name) for name in ("flow0", "flow1", "flow0.2"))
    redirect = Redirect("a", "b", "1")
    assert [redirect.holds_in(name) for name in ("flow1", "flow1.2", "flow0", "flow11", "flow0.1")] == [1, 1, 0, 0, 0]
    assert [Redirect("a", "b", "left").holds_in(name) for name in ("left", "left.1", "leftmost")] == [1, 1, 0]


def test_what_is_said_of_a_flow_alone_comes_before_what_is_said_of_all():  # R-E09
    redirects = (Redirect("a", "c", "0"), Redirect("a", "b"), Redirect("x", "y"), Redirect("p", "p"))
    assert choice(redirects, "flow0") == {"a": "c", "x": "y"}
    assert choice(redirects, "flow1") == {"a": "b", "x": "y"}


def test_two_tasks_can_change_places():  # R-E09
    assert choice((Redirect("a", "b"), Redirect("b", "a")), "flow0") == {"a": "b", "b": "a"}


def test_worlds_and_tasks_are_chosen_apart_and_a_flow_can_stay_as_it_was():  # R-E09
    redirects = (Redirect("cell:", "boxes:"), Redirect("a", "b"), Redirect("cell:", "cell:", "1"))
    assert [redirect.is_of_world for redirect in redirects] == [True, False, True]
    assert (choice(redirects, "flow0"), world_choice(redirects, "flow0")) == ({"a": "b"}, {"cell": "boxes"})
    assert (choice(redirects, "flow1"), world_choice(redirects, "flow1")) == ({"a": "b"}, {})
