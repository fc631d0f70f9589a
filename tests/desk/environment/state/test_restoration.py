from onika.desk.environment.state.restoration import FileText, own_step
from onika.wire import act
from onika.words.reason import Reason


def test_a_file_is_kept_with_its_whole_text_and_one_that_is_not_there_with_none(tmp_path):  # R-X10
    path = tmp_path / "rest.onk"
    assert FileText.of(path) == FileText(path, None)
    path.write_text("# first\nVERSION 1.0\n")
    assert FileText.of(path) == FileText(path, "# first\nVERSION 1.0\n")


def test_a_step_leads_from_what_was_to_what_is():  # R-X10
    step = own_step(Reason.plain("a rate"), act.LibraryRate("pd", 100.0), act.LibraryRate("pd", 50.0))
    assert (step.before, step.after, str(step.label)) == (
        act.LibraryRate("pd", 100.0),
        act.LibraryRate("pd", 50.0),
        "a rate",
    )
