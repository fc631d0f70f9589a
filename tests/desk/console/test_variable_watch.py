def watching(sit, line="watch X 4"):
    one = sit()
    one.does("spawn puma")
    one.runtime.variables["main"] = {"X": 1, "Y": [2.0]}
    one.does(line)
    return one


def pass_a_second(one):
    start = len(one.lines)
    for _ in range(100):
        one.session.hear()
    return one.lines[start:]


def test_a_variable_is_shown_at_once_and_whenever_it_has_changed(sit):  # R-A16
    one = watching(sit)
    assert one.lines[-1] == "main/X = 1"
    assert pass_a_second(one) == []
    one.runtime.variables["main"]["X"] = 2
    assert pass_a_second(one) == ["main/X = 2"]
    assert one.does("watch") == ["watched: main/X"]


def test_it_is_looked_at_no_more_often_than_was_said(sit):
    slow, fast = watching(sit, "watch X 0.1"), watching(sit, "watch X 20")
    asked = [len(one.runtime.asked) for one in (slow, fast)]
    pass_a_second(slow)
    pass_a_second(fast)
    assert len(slow.runtime.asked) - asked[0] == 0
    assert len(fast.runtime.asked) - asked[1] > 5


def test_watching_ends_when_it_is_told_or_the_variable_is_gone(sit):
    one = watching(sit, "watch X Y")
    del one.runtime.variables["main"]["Y"]
    assert any("is not watched any more" in line for line in pass_a_second(one))
    assert one.does("watch") == ["watched: nothing"]
    one.does("watch X", "watch off")
    one.runtime.variables["main"]["X"] = 3
    assert pass_a_second(one) == []


def test_what_is_not_there_cannot_be_watched(sit):
    one = watching(sit)
    assert one.fails("watch X Z").found == "'Z'"
    assert one.fails("watch X 1000").expected == "variables, and a rate of at most 20 Hz"
    assert one.fails("watch 5").found == "5"
    assert one.does("watch") == ["watched: main/X"]
