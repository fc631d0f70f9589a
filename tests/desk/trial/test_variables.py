from onika.desk.trial.variables import KeptVariable, kept_after, robots
from onika.wire.plan import PlannedAction, PlannedFlow, PlannedTask
from onika.wire.sheet import ModuleSheet, PortSheet


def sheet(*ports, **more):
    outputs = tuple(PortSheet("OUTVAR", name, shape, unit, "") for name, shape, unit in ports)
    kinds = {"trigger": False, "hardware": False, **more}
    return ModuleSheet(outputs, (), (), passive=False, crit=1, doc="", **kinds)


def task(name, device="", **more):
    local = (("DEVICE", (device,)),) if device else ()
    plain = {"frequency": 50.0, "type": "periodic", "aliases": (), "inconst": (), "outconst": (), "invar": ()}
    return PlannedTask(name, name, name, f"{name}.rmod", "rt0", outvar=(), local=local, **(plain | more))


SHEETS = {
    "arm": sheet(("Q_MEZ", "double[NDOF]", "rad"), ("NAME", "string", "-"), hardware=True),
    "hand": sheet(("GRIP_MEZ", "double[3]", "m,m/s,N"), hardware=True),
    "lamp": sheet(("LAMP", "int", "-")),
    "path": sheet(
        ("Q_REF", "double[NDOF]", "rad"), ("Q^_REF", "double[NDOF]", "rad/s"), ("X_REF", "double[4,4]", "-"),
        trigger=True,
    ),
    "servo": sheet(("TAU", "double[NDOF]", "N m")),
    "shut": sheet(("GRIP", "double", "-"), ("PRESS", "double", "N"), trigger=True),
}  # fmt: skip
TASKS = (
    task("arm", "boxes:arm"), task("hand", "boxes:hand"), task("lamp", "boxes:lamp"), task("path"), task("servo"),
    task("shut", aliases=(("GRIP", "GRIP_LEFT"),)),
)  # fmt: skip


def kept(*on):
    action = PlannedAction("a", "a", None, "a.appl", on, (), "")
    return [variable.name for variable in kept_after(PlannedFlow("flow0", TASKS, (action,)), action, SHEETS)]


def test_what_devices_measure_and_what_they_are_to_follow_is_kept():  # R-X07
    assert kept("arm", "path", "servo") == ["Q_MEZ", "Q_REF"]


def test_a_single_number_of_a_trigger_is_kept_under_its_alias():  # R-C04, R-X07
    assert kept("hand", "shut") == ["GRIP_MEZ", "GRIP_LEFT"]


def test_a_lamp_is_measured_though_no_hardware():  # R-X07
    assert kept("lamp") == ["LAMP"]


def test_tasks_that_are_off_say_nothing():  # R-X07
    assert kept("servo") == []


def test_elements_of_several_units_have_their_own():
    variable = KeptVariable("GRIP_MEZ", ("m", "m/s", "N"), True, True, "hand")
    assert [variable.unit_of(f"GRIP_MEZ[{at}]") for at in range(3)] == ["m", "m/s", "N"]
    assert KeptVariable("Q", ("rad",), True, True, "arm").unit_of("Q") == "rad"


def test_the_robots_of_a_flow_are_its_hardware_tasks_and_their_devices():  # R-X07
    flow = PlannedFlow("flow0", TASKS, ())
    assert robots(flow, SHEETS) == (("arm", "boxes:arm"), ("hand", "boxes:hand"))
