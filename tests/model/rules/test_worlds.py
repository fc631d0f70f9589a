from onika.model.rules.worlds import all_relocated, relocated, worlds_of
from onika.model.task import LocalLine, Task

ARM = Task("arm", "arm", local=(LocalLine("ROBOT", ("puma560",)), LocalLine("DEVICE", ("cell:arm_left", "1"))))
LAMP = Task("lamp", "lamp", local=(LocalLine("DEVICE", ("yard:lamp",)),))
SERVO = Task("pd", "pd", local=(LocalLine("STIFF", ("9",)),))
ODD = Task("odd", "odd", local=(LocalLine("DEVICE", ("cell",)), LocalLine("DEVICE", ())))


def test_tasks_tell_the_worlds_in_which_their_devices_are():  # R-E09
    assert worlds_of([ARM, LAMP, SERVO, ARM, ODD]) == ("cell", "yard")
    assert worlds_of([SERVO]) == ()


def test_a_task_in_another_world_has_the_same_device_there_and_all_else_as_it_was():  # R-E09
    there = relocated(ARM, {"cell": "boxes", "yard": "cell"})
    assert there.local == (LocalLine("ROBOT", ("puma560",)), LocalLine("DEVICE", ("boxes:arm_left", "1")))
    assert (there.name, there.module, worlds_of([ARM])) == ("arm", "arm", ("cell",))


def test_a_task_without_a_device_in_such_a_world_is_the_same_one():  # R-E09
    assert all(relocated(task, {"sea": "boxes"}) is task for task in (ARM, LAMP, SERVO, ODD))


def test_of_many_tasks_each_goes_where_its_own_world_went():  # R-E09
    tasks = {task.name: task for task in (ARM, LAMP, SERVO)}
    assert all_relocated(tasks, {}) is tasks
    moved = all_relocated(tasks, {"cell": "boxes@copy"})
    assert (worlds_of(moved.values()), moved["pd"]) == (("boxes@copy", "yard"), SERVO)
