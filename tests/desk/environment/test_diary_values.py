from onika.desk.environment.diary_values import given, written
from onika.wire import act


def test_values_are_what_the_line_of_the_act_does_not_say():  # R-H01
    command = act.Group("c1", "arm", ("a", "b"))
    assert given(command, ("a,b", "c1/a,c1/b", "arm", "c1/arm"), ("tasks", "name")) == {}
    assert given(command, ("a,b", "c1/a,c1/b", "", ""), ("tasks", "name")) == {"name": "arm"}
    assert given(command, ("a,b", "c1/a,c1/b", "", ""), ("tasks",)) == {"name": "arm"}


def test_a_value_is_kept_although_something_else_has_its_name():  # R-H01
    assert given(act.EditIcon("a1", 3, "grip"), ("grip", "a1/3", "", ""), ("onikon",)) == {"description": "grip"}


def test_a_token_is_no_value_and_what_nobody_gave_is_none():  # R-H01
    assert given(act.Connect("c1", token="secret"), (), ()) == {}
    assert given(act.Stop(), (), ()) == {}


def test_values_stand_on_one_line():
    assert written({"line": "a\n\tb", "hz": 5.0}) == '{"line":"a\\n\\tb","hz":5.0}'
