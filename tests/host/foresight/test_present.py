from kit.faults.fault_planting import FaultyRuntime
from onika.host.foresight.present import present
from onika.model.lifecycle import State
from onika.ring.drive import DriveMode


def test_the_present_is_what_runs_and_what_is_held_by_hand():  # R-X24
    runtime = FaultyRuntime().start()
    modes = {"yard:m0": DriveMode.DRIVEN}
    situation = present(runtime.program.subsystems, modes, {}, "")
    assert {address for address, facts in situation.tasks.items() if facts.state is State.ON} == {
        ("flow0", "mass"),
        ("flow0", "push"),
        ("flow0", "lamp"),
        ("hand", "mass2"),
        ("hand", "push2"),
    }
    assert [run.application for run in situation.runs] == ["test"]
    assert situation.holders == {"hand": "other"}
    assert situation.tasks["hand", "mass2"].device == "yard:m1"
