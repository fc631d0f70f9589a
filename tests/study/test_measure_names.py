from dataclasses import fields

from onika.study.measure_names import COMPARED
from onika.study.measures import TaskMeasures


def test_what_is_compared_are_figures_of_a_task():  # R-H03
    assert set(COMPARED) <= {field.name for field in fields(TaskMeasures)}
