from onika.study.report import subject_section
from onika.study.report.figure_names import TITLES


def test_whose_log_is_not_whole_is_marked(study):  # R-H02
    text = subject_section.overview(study.subjects, str)
    assert text.count("see what is wrong") == 1


def test_every_figure_of_a_subject_is_told_with_its_timeline(study):  # R-H02
    text = "".join(subject_section.single(study.subjects[0], str))
    assert text.count("<tr>") == 1 + len(TITLES)
    assert "<svg" in text
    measures = study.subjects[0].measures
    assert subject_section.shown(measures, "is_first_try", str) == "yes"
    assert subject_section.shown(measures, "mean_selection_s", str) == "4.00"
    assert subject_section.shown(measures, "attempts", str) == "1"


def test_icons_are_told(study):  # R-H02
    assert "box2_aj" in subject_section.icons(study.subjects, str)
