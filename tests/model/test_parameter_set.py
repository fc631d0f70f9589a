from onika.model.parameter_set import ParameterSet, merged
from onika.model.task import LocalLine

SOFT = ParameterSet(
    "soft",
    (("pd", LocalLine("STIFF", ("0.5",))), ("path", LocalLine("SPEED", ("0.3",))), ("pd", LocalLine("DAMP", ("2",)))),
)


def test_a_set_knows_whose_parameters_it_holds():
    assert SOFT.tasks == ("pd", "path")
    assert SOFT.of_task("pd") == {"STIFF": ("0.5",), "DAMP": ("2",)}


def test_lines_that_are_there_keep_their_place_and_others_come_behind():
    lines = (LocalLine("DEVICE", ("w:a",)), LocalLine("STIFF", ("1",)))
    assert merged(lines, SOFT.of_task("pd")) == (
        LocalLine("DEVICE", ("w:a",)),
        LocalLine("STIFF", ("0.5",)),
        LocalLine("DAMP", ("2",)),
    )
