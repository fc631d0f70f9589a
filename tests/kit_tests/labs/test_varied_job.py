from kit.labs.laboratory import Laboratory
from kit.labs.varied_job import placed, varied
from onika.files import conf


def read(path):
    configuration, faults = conf.read(path.read_text(), path.stem, str(path))
    assert faults == ()
    return configuration


def test_a_job_gets_further_tasks_behind_its_first_one_and_loses_others(tmp_path):
    varied(
        Laboratory(tmp_path), "ownC", "jmoveC", [placed("noise", 500, "LOCAL       SIGMA 0.1")], without=["led_monitor"]
    )
    names = read(tmp_path / "conf" / "ownC.conf").names
    assert names == ("puma", "noise", "diff", "gravcomp", "pd", "torque_sum", "jtraj")


def test_lines_go_behind_those_of_their_task(tmp_path):
    varied(Laboratory(tmp_path), "ownC", "pauseC", lines={"pause": "LOCAL       MORE 1\n"})
    (pause,) = read(tmp_path / "conf" / "ownC.conf").placed
    assert pause.task == "pause" and not pause.is_as_filed
