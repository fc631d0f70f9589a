from onika.words.reason import Reason


def watching(sit, line="watch X 4"):
    sitting = sit()
    sitting.does("spawn puma")
    sitting.runtime.variables["main"] = {"X": 1, "Y": [2.0]}
    sitting.does(line)
    return sitting


def pass_a_second(sitting):
    start = len(sitting.lines)
    for _ in range(100):
        sitting.session.hear()
    return sitting.lines[start:]


def test_a_variable_is_shown_at_once_and_whenever_it_has_changed(sit):  # R-A16
    sitting = watching(sit)
    assert sitting.lines[-1] == "main/X = 1"
    assert pass_a_second(sitting) == []
    sitting.runtime.variables["main"]["X"] = 2
    assert pass_a_second(sitting) == ["main/X = 2"]
    assert sitting.does("watch") == ["watched: main/X"]


def test_it_is_looked_at_no_more_often_than_was_said(sit):
    slow, fast = watching(sit, "watch X 0.1"), watching(sit, "watch X 20")
    counts = [len(sitting.runtime.asked) for sitting in (slow, fast)]
    pass_a_second(slow)
    pass_a_second(fast)
    assert len(slow.runtime.asked) - counts[0] == 0
    assert len(fast.runtime.asked) - counts[1] > 5


def test_watching_ends_when_it_is_told_or_the_variable_is_gone(sit):
    sitting = watching(sit, "watch X Y")
    del sitting.runtime.variables["main"]["Y"]
    assert any("is not watched any more" in line for line in pass_a_second(sitting))
    assert sitting.does("watch") == ["watched: nothing"]
    sitting.does("watch X", "watch off")
    sitting.runtime.variables["main"]["X"] = 3
    assert pass_a_second(sitting) == []


def test_what_is_not_there_cannot_be_watched(sit):
    sitting = watching(sit)
    assert sitting.fails("watch X Z").reason == Reason.of("console.no_variable", subsystem="main", name="Z")
    assert sitting.fails("watch X 1000").reason == Reason.of("console.watch_usage", hz=20.0, words="X 1000")
    assert sitting.fails("watch 5").reason == Reason.of("console.watch_usage", hz=20.0, words="5")
    assert sitting.does("watch") == ["watched: main/X"]
