from kit.labs.small_tasks import MODULES, small_laboratory
from onika.store.base_directory import BaseDirectory


def test_every_task_and_configuration_of_the_small_laboratory_can_be_read(tmp_path):
    base = BaseDirectory(small_laboratory(tmp_path / "bench").path)
    assert set(base.tasks) == {*MODULES, "swell"}
    assert [base.task(name)[1] for name in base.tasks] == [()] * len(base.tasks)
    assert set(base.configurations) == {"pairC", "otherC"}
    assert [base.configuration(name)[1] for name in base.configurations] == [(), ()]
