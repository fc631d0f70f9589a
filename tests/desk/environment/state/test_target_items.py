from dataclasses import replace

from onika.desk.environment.initial_model import opened
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.environment.state.target_items import inputs_of, items_of
from onika.files.rmod import RmodText
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.library import open_libraries
from onika.store.site import open_site
from onika.wire.sheet import InputSheet, ModuleSheet

SITE = open_site([], {}, None)
MODEL, _ = opened(SITE, None, {})


def sheet(*inputs):
    return ModuleSheet((), inputs, (), True, False, False, 0, "")


def duration(low, high, unit="s", default=None):
    return InputSheet("seconds", "double", unit, "how long", low, high, default)


def with_tasks(tmp_path, sheets, *tasks):
    base = BaseDirectory(tmp_path)
    for task in tasks:
        base.save_task(RmodText(task))
    return Model(OpenLibraries(open_libraries([base]), sheets=sheets), syntax=MODEL.syntax)


def waiting(name, **more):
    return Task(name, name, frequency=10.0, object_type="Pause job", **more)


def test_units_and_bounds_are_those_of_the_tasks_that_take_the_type_before_any_runtime_is_there():  # R-D08, R-B10
    endpoint, time = items_of(MODEL, "joint OBJECT")
    assert (endpoint.name, endpoint.type, endpoint.count, endpoint.unit) == ("endpoint", "double", 6, "rad")
    assert (endpoint.low, endpoint.high) == (None, None)  # only a robot knows
    assert (time.unit, time.low, time.high, time.meaning) == ("s", (0.1,), (600.0,), "how long it takes")
    assert items_of(MODEL, "Joint job") == items_of(MODEL, "Weld object") == items_of(Model(), "Joint object") == ()
    assert [item.unit for item in items_of(MODEL, "Force object")] == [""]  # no task takes one


def test_bounds_that_only_a_robot_knows_are_there_once_it_has_told_them():  # R-D08
    model = replace(MODEL, limits={"QMIN": (-1.0,) * 6, "QMAX": (1.0,) * 6})
    assert items_of(model, "Joint object")[0].low == (-1.0,) * 6
    other = replace(MODEL, limits={"QMIN": (-1.0,) * 4})  # of another robot
    assert items_of(other, "Joint object")[0].low is None


def test_what_a_runtime_says_counts_before_what_the_code_does(tmp_path):  # R-B10
    model = with_tasks(tmp_path, {"nap": sheet(duration(1, 2, default=1.5))}, waiting("nap"))
    (item,) = items_of(model, "Pause object")
    assert (item.low, item.high, item.default) == ((1.0,), (2.0,), (1.5,))
    assert inputs_of(replace(model.libraries, sheets={}), model.libraries.tasks["nap"]) == ()


def test_of_several_tasks_the_widest_bounds_count_and_none_where_one_has_none(tmp_path):  # R-D08
    tasks = (waiting("nap"), waiting("rest"))
    model = with_tasks(tmp_path, {"nap": sheet(duration(1, 2)), "rest": sheet(duration(0, None, "-"))}, *tasks)
    (item,) = items_of(model, "Pause object")
    assert (item.low, item.high, item.unit) == ((0.0,), None, "s")


def test_a_bound_is_the_variable_behind_its_name_in_the_task(tmp_path):  # R-C04
    task = waiting("nap", aliases=(("TMAX", "LONGEST"),), inconst=("TMAX",))
    model = with_tasks(tmp_path, {"nap": sheet(duration(0, "TMAX"))}, task)
    assert items_of(replace(model, limits={"LONGEST": (9.0,)}), "Pause object")[0].high == (9.0,)


def test_an_input_of_another_type_takes_nothing_of_the_target(tmp_path):  # R-B10
    model = with_tasks(tmp_path, {"nap": sheet(InputSheet("n", "int", "m", "", 0, 1, None))}, waiting("nap"))
    assert items_of(model, "Pause object")[0].unit == ""
