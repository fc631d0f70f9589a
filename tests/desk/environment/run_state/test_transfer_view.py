from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.run_state.transfer_view import jump_view
from onika.wire import event, view
from onika.wire.figures import VariableSteps
from onika.words.reason import NOTHING

STEPS = VariableSteps("flow0", "puma", "TAU_REF", "N m", 19, 1, 40.0, 9.0, 9.76, 21.2, 2, 6, 1)


def test_a_variable_is_shown_with_its_element_and_what_became_of_it():  # R-X04
    shown = view.JumpView("flow0", "puma", "TAU_REF[1]", "N m", 40.0, 9.76, 21.2, 19, 2, 6, 1)
    assert jump_view(STEPS) == shown


def test_a_step_that_is_too_far_is_a_note_of_the_run_and_stands_in_its_result(tmp_path):  # R-X04, R-E11
    play = RunFixture(tmp_path)
    play.run(play.open([job("aC"), job("bC")]))
    play.began(0)
    play.tell(event.Stepped("flow0", "puma", "TAU_REF", "N m", 1, 3.0, 3.0, 9.76, 0, 1.0))
    assert play.view.notes == ()
    play.tell(event.Stepped("flow0", "puma", "TAU_REF", "N m", 1, 40.0, 9.0, 9.76, 6, 1.0))
    assert str(play.view.notes[-1]).endswith("blended over 6 cycles")
    play.tell(event.Result(True, NOTHING, 2, 2, 2.0, 2.0, {}, (), "", steps=(STEPS,)))
    assert [jump.variable for jump in play.view.jumps] == ["TAU_REF[1]"]
