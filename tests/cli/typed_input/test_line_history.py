from onika.cli.typed_input.line_history import LineHistory


def test_a_line_said_twice_in_a_row_is_kept_once_and_blank_ones_never(tmp_path):  # R-A16
    path = tmp_path / "state" / "history"
    history = LineHistory(path)
    for text in ("a", "a", " ", "b\n\nc\n", "a"):
        history.append_string(text)
    history.keep()
    assert path.read_text() == "a\nb\nc\na\n"
    assert path.stat().st_mode & 0o077 == 0
    assert list(LineHistory(path).load_history_strings()) == ["a", "c", "b", "a"]


def test_the_last_thousand_lines_are_kept(tmp_path):
    path = tmp_path / "history"
    path.write_text("".join(f"line {number}\n" for number in range(1200)))
    LineHistory(path).keep()
    assert path.read_text().splitlines() == [f"line {number}" for number in range(200, 1200)]


def test_a_history_that_cannot_be_read_or_written_is_none(tmp_path):
    for path in (None, tmp_path):
        history = LineHistory(path)
        history.append_string("status")
        history.keep()
        assert list(history.load_history_strings()) == ["status"]


def test_a_line_of_absurd_length_is_not_kept_for_the_next_console(tmp_path):
    history = LineHistory(tmp_path / "history")
    for line in ("a", "x" * 4001, "y" * 4000):
        history.append_string(line)
    history.keep()
    assert (tmp_path / "history").read_text().splitlines() == ["a", "y" * 4000]
