from tests.sentences import expected_by, found_by

from onika.model.rules.warning import further_triggers, hanging, self_fed
from onika.model.task import Task
from onika.words.fault import Place

PLACE = Place("move.conf")


def test_a_task_that_writes_what_it_reads_is_named() -> None:
    task = Task("filter", "filter", aliases=(("OUT", "X"),), invar=("X", "Y"), outvar=("OUT",))  # R-C08, Equation (5)
    (fault,) = self_fed(task, PLACE)
    assert (fault.place, found_by(fault)) == (PLACE, "X, which it does both")
    assert self_fed(Task("gain", "gain", invar=("X",), outvar=("Y",)), PLACE) == ()


def test_every_hanging_input_is_named_with_its_readers() -> None:
    reader = Task("pid", "pid", inconst=("NDOF",), invar=("Q_REF", "Q_MEZ"))  # R-C08, Equation (6)
    other = Task("log", "log", aliases=(("X", "Q_REF"),), invar=("X",))
    robot = Task("puma", "puma", outconst=("NDOF",), outvar=("Q_MEZ",))
    assert [(expected_by(fault), found_by(fault)) for fault in hanging([reader, robot, other], PLACE)] == [
        ("a task that writes Q_REF", "only `pid` and `log`, reading it")
    ]


def test_all_triggers_but_the_first_are_named() -> None:
    tasks = [
        Task("grav", "grav"),
        Task("jmove", "j", object_type="Joint job"),
        Task("cmove", "c", object_type="Cartesian job"),
    ]
    (fault,) = further_triggers(tasks, PLACE)  # R-C29
    assert fault.is_note
    assert found_by(fault) == "`cmove` (Cartesian job) beside `jmove`"
    assert further_triggers(tasks[:2], PLACE) == ()
