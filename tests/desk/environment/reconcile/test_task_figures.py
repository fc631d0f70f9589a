from onika.desk.console.status import UNITS
from onika.desk.environment.reconcile.task_figures import FigureTotals, columns
from onika.model.preferences import STATUS_COLUMNS
from onika.wire import live


def figure(cycle=10, miss=1, task="a", tid=7, hz=100.0, subsystem="main"):
    return live.TaskFigure(
        subsystem, task, "m", "rt0", tid, "P", 3, "ON", cycle, miss, hz, 99.5, 0.5, 4.0, 1e-6,
        0.1, 0.4, 0.2, 0.5, 2.0, 1.0, 2,
    )  # fmt: skip


def test_every_column_that_can_be_chosen_has_its_figure():  # R-A11, §A.5
    assert set(columns(figure())) == set(STATUS_COLUMNS) >= set(UNITS)


def test_a_task_without_a_rate_has_no_period():
    row = columns(figure(hz=0.0))
    assert row["ref-F"] is None and row["ref-T"] is None and row["mez-T"] == 1e3 / 99.5


def test_what_is_counted_is_added_up_though_counting_begins_anew():  # R-A17
    tally = FigureTotals()
    tally.add(live.Figures((figure(10, 1),), {}), {"c1": "main"})
    row = tally.add(live.Figures((figure(5, 0),), {}), {"c1": "main"})["c1/a"]
    assert (row["cycle"], row["miss"], row["warn"], row["tot-C"], row["ptime"]) == (15, 1, 4, 8.0, 1.0)
    assert row["mez-F"] == 99.5 and row["avg-U"] == 0.2


def test_a_task_that_is_born_again_counts_from_nothing():
    tally = FigureTotals()
    tally.add(live.Figures((figure(10),), {}), {"c1": "main"})
    assert tally.add(live.Figures((figure(5, tid=8),), {}), {"c1": "main"})["c1/a"]["cycle"] == 5


def test_what_no_document_shows_is_counted_and_not_shown():
    tally = FigureTotals()
    assert tally.add(live.Figures((figure(10),), {}), {}) == {}
    assert tally.add(live.Figures((figure(5),), {}), {"c1": "main"})["c1/a"]["cycle"] == 15
