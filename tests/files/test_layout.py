from hypothesis import given, strategies as st

from onika.files.layout import carry, carry_comments

OLD = "# head\nA   1\n\n# on B\nB 2\n# on C\nC\t3\nEOF\n# tail\n"


def test_lines_that_did_not_change_stay_as_they_were_written() -> None:
    assert carry(OLD, "A 1\nB 2\nC 3\nEOF\n") == OLD  # R-B01


def test_comments_stay_above_a_changed_line() -> None:
    assert carry(OLD, "A 1\nB 9\nC 3\nEOF\n") == OLD.replace("B 2", "B 9")


def test_comments_stay_when_their_line_goes() -> None:
    assert carry(OLD, "A 1\nC 3\nEOF\n") == "# head\nA   1\n# on B\n# on C\nC\t3\nEOF\n# tail\n"


def test_new_lines_come_where_they_belong() -> None:
    assert carry(OLD, "A 1\nB 2\nX 1\nC 3\nEOF\n") == OLD.replace("B 2\n", "B 2\nX 1\n")


def test_a_key_decides_what_is_the_same_line() -> None:
    assert carry("A=B\nEOF\n", "A = B\nEOF\n", lambda line: tuple(line.replace("=", " = ").split())) == "A=B\nEOF\n"


def test_a_new_text_has_its_own_layout() -> None:
    assert carry("", "A 1\n\nEOF\n") == "A 1\n\nEOF\n"


def test_a_text_without_comments_is_replaced_as_it_is() -> None:
    assert carry_comments("A   1\nEOF\n", "A 1\nEOF\n") == "A 1\nEOF\n"
    assert carry_comments(OLD, "A 1\nEOF\n").startswith("# head\nA   1\n")


def test_the_line_ends_of_windows_stay_in_every_line() -> None:  # R-B01
    assert carry_comments("A 1\r\nB 2\r\nEOF\r\n", "A 1\nB 9\nEOF\n") == "A 1\r\nB 9\r\nEOF\r\n"
    sentences = OLD.replace("\n", "\r\n")
    assert carry_comments(sentences, "A 1\nB 9\nX 1\nC 3\nEOF\n") == sentences.replace("B 2", "B 9\r\nX 1")


def test_where_nothing_is_alike_the_comments_stay() -> None:
    assert carry("# a\nA\n# b\nB\n# c\n", "X\nY\nZ\n") == "# a\nX\n# b\nY\nZ\n# c\n"
    assert carry("# a\nA\n", "") == "# a\n"
    assert carry("A\nA\nA\n", "A\nA\n") == "A\nA\n"


@given(st.lists(st.sampled_from("ABC"), max_size=9), st.lists(st.sampled_from("ABC"), max_size=9), st.data())
def test_every_comment_stays_and_every_line_is_the_new_one(old: list[str], new: list[str], data: st.DataObject) -> None:
    former = [data.draw(st.sampled_from(["", f"# {at}\n"])) + line + "\n" for at, line in enumerate(old)]  # R-B01
    text = carry("".join(former), "".join(line + "\n" for line in new))
    assert [line for line in text.splitlines() if line[0] != "#"] == new
    assert [line for line in text.splitlines() if line[0] == "#"] == [
        line for line in "".join(former).splitlines() if line[0] == "#"
    ]
