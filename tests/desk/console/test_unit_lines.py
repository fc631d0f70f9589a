from onika.wire import event, live
from onika.words.reason import Reason


def test_a_unit_is_added_and_it_is_told_when_it_is_up(sit):  # R-A06
    sitting = sit()
    sitting.does("rtpus add rt2")
    assert sitting.requests_of(live.AddUnit) == [live.AddUnit("rt2")]
    sitting.runtime.tell(event.UnitUp("rt2", 1.5))
    assert any("unit rt2 is up" in line for line in sitting.does("echo"))


def test_the_runtimes_refusal_is_told(sit):  # R-A06
    sitting = sit()
    sitting.runtime.refusals["AddUnit"] = Reason.of("host.unit_lives", name="rt1")
    refusal = sitting.fails("rtpus add rt1").reason
    assert refusal.key == "console.runtime_refused" and "rt1, which lives" in str(refusal)


def test_words_that_mean_nothing_are_refused_and_ask_nothing(sit):
    sitting = sit()
    for line in ("rtpus rt2", "rtpus add", "rtpus end rt2"):
        words = line.removeprefix("rtpus ")
        assert sitting.fails(line).reason == Reason.of("console.unit_words", words=words)
    assert sitting.requests_of(live.AddUnit) == []
