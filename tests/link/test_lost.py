from onika.link import lost


def test_each_cause_says_distinctly_what_happened():  # R-F01
    told = [
        lost.closed("connection reset"),
        lost.silent(3.04),
        lost.version(1, 2),
        lost.garbage("no packet"),
        lost.behind("too many bytes"),
        lost.here(),
    ]
    assert {why.cause for why in told} == set(lost.Cause)
    assert len({str(why) for why in told}) == len(told)


def test_the_words_hold_the_numbers_that_matter():
    assert str(lost.silent(3.04)) == "the other side has been silent for 3.0 s"
    assert "version 2" in str(lost.version(1, 2))
    assert "connection reset" in str(lost.closed("connection reset"))
    assert str(lost.closed()) == "the other side closed the connection"
