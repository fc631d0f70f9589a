"""Faults and refusals as values."""

from onika.words.fault import Fault, Place, Refusal, parted
from onika.words.reason import Reason


def test_a_fault_says_where_what_was_expected_what_was_found_and_what_is_done_instead():  # R-B07
    fault = Fault(
        Place("lab/jtraj.rmod", 7),
        Reason.plain("expected FREQ, a number above 0, found 'fast'"),
        Reason.plain("task jtraj is left out"),
    )
    assert str(fault) == (
        "lab/jtraj.rmod:7: expected FREQ, a number above 0, found 'fast'; instead: task jtraj is left out"
    )


def test_a_place_without_a_line_is_the_whole_file():
    assert str(Place("lab/jtraj.rmod")) == "lab/jtraj.rmod"


def test_faults_sort_by_place_so_that_a_list_of_them_reads_from_top_to_bottom():
    item, two, three = (
        Fault(Place(f, line), Reason.plain("expected a, found b"), Reason.plain("c"))
        for f, line in (("a", 2), ("a", 10), ("b", 1))
    )
    assert sorted([three, two, item]) == [item, two, three]


def test_equal_faults_are_one():
    assert (
        len(
            {
                Fault(Place("a", 1), Reason.plain("expected x, found y"), Reason.plain("z")),
                Fault(Place("a", 1), Reason.plain("expected x, found y"), Reason.plain("z")),
            }
        )
        == 1
    )


def test_a_refusal_gives_its_reason_and_what_the_user_can_do():  # R-X01
    written = Reason.of("rules.output_written", svar="Q_REF", other="cubic")
    assert str(Refusal(written)) == "writes Q_REF, which `cubic` already writes"
    refusal = Refusal(written, (Reason.of("rules.replace", task="cubic"), Reason.of("rules.alias", svar="Q_REF")))
    assert str(refusal) == "writes Q_REF, which `cubic` already writes (you can: replace `cubic`; alias Q_REF)"


def test_notes_are_parted_from_what_is_wrong_and_each_is_told_once():  # R-B07
    wrong, note = (
        Fault(Place("b"), Reason.plain("expected x, found y"), Reason.plain("z")),
        Fault(Place("a"), Reason.plain("expected x, found y"), Reason.plain("z"), is_note=True),
    )
    assert parted([wrong, note, wrong, note]) == ((wrong,), (note,))
    assert parted([]) == ((), ())
    assert note != Fault(Place("a"), Reason.plain("expected x, found y"), Reason.plain("z"))
