from onika.study.report.style import STYLE


def test_the_page_has_a_dark_ground_and_a_sheet_of_paper():
    assert "light-dark(" in STYLE
    assert "@media print" in STYLE
    assert STYLE.count("{") == STYLE.count("}")
