from onika.desk.run.text_table import lines


def test_columns_are_as_wide_as_needed_and_numbers_stand_right():
    rows = lines(("task", "Hz", "state"), [("puma", "500.0", "ON"), ("led_monitor", "5.5", "OFF")])
    assert rows == ["task            Hz  state", "puma         500.0  ON", "led_monitor    5.5  OFF"]


def test_a_name_that_begins_with_a_digit_column_is_judged_by_all_its_cells():
    assert lines(("a", "b"), [("1", "x"), ("-", "2")]) == ["a  b", "1  x", "-  2"]


def test_a_table_without_rows_is_its_head():
    assert lines(("a", "b"), []) == ["a  b"]
