from onika.model.rules.warning import further_triggers, hanging, self_fed
from onika.model.task import Task
from onika.words.fault import Place
from onika.words.reason import Reason

PLACE = Place("move.conf")


def test_a_task_that_writes_what_it_reads_is_named() -> None:
    task = Task("filter", "filter", aliases=(("OUT", "X"),), invar=("X", "Y"), outvar=("OUT",))  # R-C08, Equation (5)
    (fault,) = self_fed(task, PLACE)
    assert (fault.place, fault.reason) == (PLACE, Reason.of("rules.self_fed", task="filter", svar="X"))
    assert self_fed(Task("gain", "gain", invar=("X",), outvar=("Y",)), PLACE) == ()


def test_every_hanging_input_is_named_with_its_readers() -> None:
    reader = Task("pid", "pid", inconst=("NDOF",), invar=("Q_REF", "Q_MEZ"))  # R-C08, Equation (6)
    other = Task("log", "log", aliases=(("X", "Q_REF"),), invar=("X",))
    robot = Task("puma", "puma", outconst=("NDOF",), outvar=("Q_MEZ",))
    assert [str(fault.reason) for fault in hanging([reader, robot, other], PLACE)] == [
        "expected a task that writes Q_REF, found only `pid` and `log`, reading it"
    ]


def test_all_triggers_but_the_first_are_named() -> None:
    tasks = [
        Task("grav", "grav"),
        Task("jmove", "j", object_type="Joint job"),
        Task("cmove", "c", object_type="Cartesian job"),
    ]
    (fault,) = further_triggers(tasks, PLACE)  # R-C29
    assert fault.is_note
    assert fault.reason == Reason.of("rules.further_trigger", task="cmove", kind="Cartesian job", first="jmove")
    assert further_triggers(tasks[:2], PLACE) == ()
