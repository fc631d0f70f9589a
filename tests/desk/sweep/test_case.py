from onika.desk.sweep.case import Case, CaseResult
from onika.words.reason import NOTHING, Reason


def test_a_run_is_good_where_it_came_to_its_end_and_all_that_was_expected_holds():  # R-X23
    assert CaseResult(Case(1), "completed").is_good
    assert CaseResult(Case(1), "completed").failure == NOTHING
    for bad in (
        CaseResult(Case(1), "completed", unmet=("LAMP == 1",)),
        CaseResult(Case(1), "aborted", Reason.plain("it fell")),
        CaseResult(Case(1), "refused"),
        CaseResult(Case(1), "lost"),
    ):
        assert not bad.is_good


def test_what_failed_first_is_why_it_did_not_end_else_what_does_not_hold():  # R-X23
    fell = CaseResult(Case(1), "aborted", Reason.plain("it fell"), ("LAMP == 1",))
    assert str(fell.failure) == "it fell"
    assert str(CaseResult(Case(1), "completed", unmet=("LAMP == 1",)).failure) == "expected LAMP == 1, found it not so"
