import pytest

from onika.store.remote.piece import Piece, Span, joined, shares, size_of_whole


@pytest.mark.parametrize(
    ("size", "begin", "count"), [(100, 10, 6), (11, 10, 6), (10, 10, 6), (17, 10, 6), (1000, 0, 1)]
)
def test_shares_are_all_that_is_left_once(size, begin, count):  # R-F03
    spans = shares(size, begin, count)
    assert len(spans) <= count
    assert [byte for span in spans for byte in range(span.begin, span.end)] == list(range(begin, size))


def test_a_span_is_asked_for_with_its_last_byte():  # R-F03
    assert Span(0, 10).header == "bytes=0-9"


@pytest.mark.parametrize(
    ("header", "size"),
    [
        ("bytes 5-9/20", 20),
        ("bytes 5-7/8", 8),  # the file ends before what was asked for
        ("bytes 5-9/8", None),
        ("bytes 4-9/20", None),
        ("bytes 5-8/20", None),
        ("bytes 5-9/*", None),
        ("bytes */20", None),
        ("bytes 5-9/20 ", None),
        ("", None),
    ],
)
def test_an_answer_counts_where_it_is_the_piece_that_was_asked_for(header, size):  # R-X16
    assert size_of_whole(Span(5, 10), header) == size


def test_pieces_of_one_file_are_joined():  # R-F03
    assert joined([Piece(b"ab", 3, "v"), Piece(b"c", 3, "v")]) == b"abc"


@pytest.mark.parametrize("other", [Piece(b"c", 3, "w"), Piece(b"c", 4, "v"), Piece(b"cd", 3, "v")])
def test_pieces_of_different_files_are_not(other):  # R-X16
    assert joined([Piece(b"ab", 3, "v"), other]) is None
