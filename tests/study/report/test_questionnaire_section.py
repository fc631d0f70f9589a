from onika.study.report import questionnaire_section


def test_scores_are_told_by_groups_and_for_each_subject(study):  # R-H05
    text = "".join(questionnaire_section.section(study, str))
    assert "100.0" in text
    assert "50.0" in text
    groups = {subject.name: subject.group for subject in study.subjects}
    assert questionnaire_section.points_of(study.answers, groups, "sus") == {"b": [("b1", 100.0)], "w": [("w1", 50.0)]}
    assert questionnaire_section.points_of(study.answers, groups, "tlx") == {}
