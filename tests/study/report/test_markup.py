import math

from onika.study.report import markup


def test_nothing_from_a_file_is_taken_for_markup():  # R-H02
    wild = "<script>alert(1)</script>\"'&"
    parts = (
        markup.paragraph(wild),
        markup.heading(2, wild, wild),
        markup.listing([wild]),
        markup.table([wild], [[wild, wild]], [wild]),
        markup.figure("<svg/>", wild),
    )
    assert all("<script" not in part and "\"'" not in part for part in parts)


def test_numbers_that_are_none_are_dashes():
    assert markup.number(math.nan) == markup.percent(math.inf) == "–"
    assert (markup.number(2.0), markup.number(3), markup.number(1 / 3, 4)) == ("2.00", "3", "0.3333")
    assert (markup.percent(0.0698929), markup.percent(1e-9)) == ("6.99 %", "< 0.01 %")
