from dataclasses import replace
from pathlib import Path

import pytest

from onika.desk.environment.canvas.draft import Draft, drafted
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.files.rmod import RmodText
from onika.model.configuration import Configuration, Placed
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped
from onika.store.site import Site
from onika.words.reason import Reason

TASKS = (
    Task("jmove", "jmove", invar=("Q",), outvar=("Q_REF",), frequency=1.0, object_type="joint job"),
    Task("grip", "grip", frequency=1.0, object_type="Gripper job"),
    Task("strange", "strange", frequency=1.0, object_type="Welding job"),
    Task("other", "jmove", frequency=1.0),
    Task("pd", "pd", outvar=("Q",), frequency=1.0),
)


@pytest.fixture
def base(tmp_path):
    base = BaseDirectory(tmp_path / "lab")
    for task in TASKS:
        base.save_task(RmodText(task))
    return base


@pytest.fixture
def site(base):
    return Site((base,), shipped() / "prefs")


def draft(site, base, *names, name="move"):
    document = Document("c1", Content(Configuration(name, tuple(map(Placed, names)))), base=base.path)
    return drafted(document, site)


def icon(name, kind="Joint job"):
    return Onikon(name, kind, "as it was", (), blank())


def test_the_first_task_that_takes_a_target_gives_the_type_and_its_edges(site, base):  # R-C16, R-C29
    proposal = draft(site, base, "pd", "jmove", "grip")
    assert proposal.kind.type == "Joint job"
    syntax = site.syntax()[0]
    assert proposal.edges == (syntax.find("Joint job").left_edge, syntax.find("Joint job").right_edge)
    (note,) = proposal.notes
    assert "`grip` (Gripper job)" in str(note)
    assert (proposal.warnings, proposal.former, proposal.path) == ((), None, base.onikon_file("move"))


def test_without_such_a_task_it_is_a_complete_job_and_hanging_inputs_are_noted(site, base):  # R-C16
    assert draft(site, base, "pd").kind.type == "Complete job"
    (note,) = draft(site, base, "jmove").notes
    assert "writes Q" in str(note)


def test_every_reason_why_there_is_no_job_is_given(site, base):  # R-C16
    assert draft(site, base) == (Reason.of("rules.without_tasks", configuration="move"),)
    reasons = draft(site, base, "gone", "lost")
    assert [str(reason).split()[2] for reason in reasons] == ["gone", "lost"]


def test_an_unknown_type_is_kept_and_told(site, base):  # R-D16
    proposal = draft(site, base, "strange")
    assert proposal.kind.type == "Welding job"
    assert "does not define Welding job" in str(proposal.warnings[0])
    assert proposal.edges == draft(site, base, "pd").edges


def test_tasks_that_may_not_stand_together_are_told(site, base):  # R-C26
    assert tuple(map(str, draft(site, base, "jmove", "other", "pd").warnings)) == (
        "other and jmove may not stand together",
    )


def test_the_icon_that_it_has_is_offered_again_and_an_old_type_told(site, base):  # reading 36
    base.save_onikon(icon("move"))
    assert draft(site, base, "jmove", "pd").former.value == icon("move")
    assert draft(site, base, "jmove", "pd").warnings == ()
    assert tuple(map(str, draft(site, base, "pd").warnings)) == ("its icon says Joint job, as it was before",)


def test_the_icon_of_something_else_is_not_lost_unseen(site, base):  # reading 34
    base.save_onikon(icon("move", "Complete application"))
    proposal = draft(site, base, "pd")
    assert proposal.former is None
    assert "the icon of something else, a Complete application" in str(proposal.taken)
    base.onikon_file("move").write_text("nonsense")
    proposal = draft(site, base, "pd")
    assert "cannot be read and would be lost" in str(proposal.taken)
    assert proposal.taken in proposal.warnings


def test_of_two_icons_of_one_name_the_first_on_the_search_path_counts(site, base, tmp_path):  # R-D15
    other = BaseDirectory(tmp_path / "other")
    other.save_onikon(icon("move"))
    after = replace(site, directories=(base, other))
    before = replace(site, directories=(other, base))
    outside = replace(site, directories=(other,))
    assert tuple(map(str, draft(after, base, "pd").warnings)) == (
        f"{other.path} has an icon move too: this one counts, as it comes first",
    )
    assert tuple(map(str, draft(before, base, "pd").warnings)) == (
        f"{other.path} has an icon move too: that one counts, as it comes first",
    )
    assert "no dictionary shows this icon" in str(draft(outside, base, "pd").warnings[0])


def test_without_a_syntax_the_reason_is_given(site, base):
    assert "/nowhere" in str(draft(replace(site, prefs=Path("/nowhere")), base, "pd")[0])


def test_a_document_without_a_file_is_a_fault_of_the_program(site):
    with pytest.raises(ValueError, match="c1"):
        drafted(Document("c1", Content(Configuration("x"))), site)


def test_a_draft_is_a_value(site, base):
    assert isinstance(draft(site, base, "pd"), Draft)
    assert draft(site, base, "pd") == draft(site, base, "pd")
