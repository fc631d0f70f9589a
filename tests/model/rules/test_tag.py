from tests.model.rules.upper import branch, flow, job, outline, texts

from onika.model.rules.tag import faults

MEET = job("open", synch_tag="meet")


def test_a_tag_stands_in_two_flows_or_more() -> None:
    two = outline(flow(MEET, MEET), flow(job(), branch(flow(MEET), flow())), is_parallel=True)  # reading 26
    assert texts(faults(two)) == []
    alone = outline(flow(job(), MEET, MEET), flow(job()), is_parallel=True)  # R-E04
    assert texts(faults(alone)) == [
        (
            "work.appl: expected the synchronisation tag meet in two flows of `work` or more"
            ", found it only at `open`, step 1 of flow 0"
        )
    ]


def test_two_flows_of_one_branch_are_one_flow() -> None:
    result = outline(flow(branch(flow(MEET), flow(MEET))), flow(job()), is_parallel=True)
    assert len(texts(faults(result))) == 1


def test_where_nothing_is_parallel_a_tag_is_noted_and_ignored() -> None:
    result = outline(flow(MEET), flow(MEET), is_nested=True)  # reading 27
    (note,) = faults(result)
    assert texts([note]) == [
        "*work.appl: expected a parallel application for the tag meet, found it at `open`, step 0 of flow 0 of `work`"
    ]
    assert str(note.instead) == "it is ignored"
