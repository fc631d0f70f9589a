from hypothesis import given, strategies as st

from onika.store.remote.three_way import merged

BASE = """VERSION 1.3

RMODFILE    puma
COORDS      120 80
INLEFT      yes
FREQ        500

RMODFILE    jtraj
COORDS      320 80
FREQ        50

EOF
"""


def test_changes_at_different_places_are_both_kept():  # R-F03
    mine, theirs = BASE.replace("500", "400"), BASE.replace("50\n\nEOF", "60\n\nEOF")
    both = merged(BASE, mine, theirs)
    assert both.conflicts == 0
    assert "FREQ        400" in both.text and "FREQ        60" in both.text


def test_changes_in_neighbouring_lines_are_both_kept():  # R-X09
    mine = BASE.replace("120 80", "999 80")
    theirs = BASE.replace("INLEFT      yes\nFREQ        500", "INLEFT      no\nFREQ        400")
    both = merged(BASE, mine, theirs)
    assert both.conflicts == 0
    assert "COORDS      999 80\nINLEFT      no\nFREQ        400\n" in both.text


def test_an_icon_that_both_have_moved_stands_where_one_has_put_it_oneself():  # R-X09
    both = merged(BASE, BASE.replace("120 80", "1 1"), BASE.replace("120 80", "2 2"))
    assert both.conflicts == 0 and "COORDS      1 1\n" in both.text and "2 2" not in both.text


def test_two_values_of_one_line_contradict_and_both_are_kept():  # R-F03
    both = merged(BASE, BASE.replace("500", "400"), BASE.replace("500", "300"))
    assert both.conflicts == 1
    before, _, rest = both.text.partition("<<<<<<< mine\n")
    inner, _, after = rest.partition(">>>>>>> theirs\n")
    assert inner == "FREQ        400\n||||||| before\nFREQ        500\n=======\nFREQ        300\n"
    assert before + after == BASE.replace("FREQ        500\n", "")


def test_what_one_removes_and_the_other_changes_contradicts():  # R-F03
    mine = BASE.replace("RMODFILE    jtraj\nCOORDS      320 80\nFREQ        50\n\n", "")
    assert merged(BASE, mine, BASE.replace("50\n\nEOF", "60\n\nEOF")).conflicts == 1


def test_a_text_without_a_line_end_stays_so():
    assert merged("a\nb", "a\nb", "A\nb").text == "A\nb"


_LINES = st.lists(st.sampled_from(["a\n", "b\n", "c\n", "d\n"]), max_size=8).map("".join)


@given(_LINES, _LINES, _LINES)
def test_nothing_is_lost_whatever_is_merged(base, mine, theirs):  # R-F03
    assert merged(base, mine, base).text == mine
    assert merged(base, base, theirs).text == theirs
    assert merged(base, mine, mine).text == mine
    both, other = merged(base, mine, theirs), merged(base, theirs, mine)
    assert both.conflicts == other.conflicts
    new = (set(mine.splitlines()) | set(theirs.splitlines())) - set(base.splitlines())
    assert new <= set(both.text.splitlines())
    if both.conflicts == 0:
        assert both.text == other.text
