from onika.desk.plan.flow_index import Cast, Part
from onika.desk.run.steering_script import load, read
from onika.wire import steer
from onika.words.fault import Fault, Place

CAST = Cast((Part("flow0", ("lift", "turn"), frozenset()),))


def test_lines_stand_with_their_places_and_comments_are_left_out():  # R-E07
    cues, faults = read("# first\npause   # now\n\nskip 2\n", "s", CAST)
    assert faults == []
    assert [(cue.place, cue.text) for cue in cues] == [(Place("s", 2), "pause"), (Place("s", 4), "skip 2")]
    assert cues[1].act.message == steer.Skip("flow0", 1)


def test_all_faults_are_told_with_their_lines():  # R-E07
    cues, faults = read("dance\npause\nskip 7\n", "s", CAST)
    assert [cue.text for cue in cues] == ["pause"]
    assert [fault.place for fault in faults] == [Place("s", 1), Place("s", 3)]
    assert faults[1] == Fault(Place("s", 3), "an action of flow0 from 1 to 2", "7", "nothing is run")


def test_a_file_is_read_or_its_fault_is_told(tmp_path):  # R-E07
    path = tmp_path / "s"
    path.write_text("pause\n")
    assert [line.text for line in load(path, CAST)[0]] == ["pause"]
    cues, faults = load(tmp_path / "none", CAST)
    assert (cues, len(faults)) == ((), 1)
