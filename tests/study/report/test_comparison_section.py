from onika.study import folder
from onika.study.compared import compared
from onika.study.comparison import compare
from onika.study.report import comparison_section
from onika.study.source_tables import FOLDER


def test_the_page_of_the_source_says_what_the_source_says():  # R-H03
    figure = compared(folder.read(FOLDER).subjects)[0]
    text = "".join(comparison_section.section(figure, str))
    assert "F(2, 18) = 3.096" in text
    assert "<td>6.99 %</td>" in text
    for row in (("-3.2796", "-0.7369", "1.8058"), ("-6.1984", "-3.0539", "0.0907"), ("-5.5214", "-2.3170", "0.8874")):
        assert "".join(f"<td>{number}</td>" for number in row) in text


def test_how_many_subjects_it_needs_is_told_for_three_sizes_and_that_found():  # R-H03
    text = comparison_section.needed(compared(folder.read(FOLDER).subjects)[0].comparison, str)
    assert "<td>22</td><td>66</td>" in text  # a large difference, three groups
    assert "as large as found here" in text
    assert "as large as found here" not in comparison_section.needed(compare({}), str)
