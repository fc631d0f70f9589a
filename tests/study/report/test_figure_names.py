from dataclasses import fields

from onika.study.measures import TaskMeasures
from onika.study.report.figure_names import SHORT, TITLES, title_of


def test_every_figure_has_a_title():  # R-H02
    assert {field.name for field in fields(TaskMeasures)} - set(TITLES) == {"has_succeeded"}
    assert set(SHORT) <= set(TITLES)
    assert str(title_of("check_s")) == "total check time (s)"
