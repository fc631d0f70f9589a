"""Tables of a study: rows by subject, whatever a spreadsheet made of them."""

from hypothesis import given, strategies as st

from onika.study import table


def keys(faults):
    return [(fault.place.line, fault.reason.key) for fault in faults]


def test_rows_are_read_by_the_names_of_columns():  # R-H02
    rows, faults = table.read("# who\nsubject,group,removed\np1,both,\n\np2, words ,ill\n", "subjects.csv")
    assert faults == ()
    assert [(row.line, row.subject, dict(row.cells)) for row in rows] == [
        (3, "p1", {"group": "both"}),
        (5, "p2", {"group": "words", "removed": "ill"}),
    ]


def test_a_spreadsheet_with_semicolons_and_commas_in_numbers_is_read():  # R-H02
    rows, faults = table.read("\ufeffSubject;group;building_s\r\np1;both;427,5\r\n", "results.csv")
    assert faults == ()
    assert rows[0].number("building_s") == 427.5
    assert rows[0].number("group") is None
    assert table.number_of("nan") is None


def test_two_subjects_of_one_name_are_both_left_out_and_named():  # R-H02
    rows, faults = table.read("subject,group\np1,a\np2,a\np1,b\n", "subjects.csv")
    assert [row.subject for row in rows] == ["p2"]
    assert keys(faults) == [(4, "study.subject_twice")]
    assert faults[0].reason.args["line"] == 2


def test_what_is_no_table_is_told():  # R-H02
    for text, expected in (
        ("name,group\np1,a\n", [(1, "study.no_subject_column")]),
        ("subject,group,group\np1,a,b\n", [(1, "study.column_twice")]),
        ("subject,group\np1,a,b\n", [(2, "study.too_many_cells")]),
        ("subject,group\n,a\n", [(2, "study.no_subject")]),
        ('subject,group\n"p1,a\n' + "x" * 200_000, [(3, "study.no_table")]),
    ):
        rows, faults = table.read(text, "t.csv")
        assert rows == ()
        assert keys(faults) == expected


@given(st.text(max_size=200))
def test_any_text_is_read_without_a_crash(text):  # R-H02
    table.read("subject,group\n" + text, "t.csv")
    table.read(text, "t.csv")


def test_a_written_table_holds_no_formulas_and_no_numbers_that_are_none():  # R-H02
    text = table.written(("a", "b", "c"), [("=1+1", float("nan"), 2.5), ("@x", 3, 1 / 3)])
    assert text == "a,b,c\n'=1+1,,2.5\n'@x,3,0.3333333333\n"
