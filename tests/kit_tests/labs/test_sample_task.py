from kit.labs.sample_task import SampleTask, law_task, source
from kit.runtime.executive_rig import ExecutiveRig
from oracle.law_task import Moment


def test_a_probe_adds_its_inputs_to_its_outputs_as_the_law_sees_it():
    task = law_task(SampleTask("a", invar=("V0",), outvar=("V1",)))
    moment = Moment(0, task.period, {"V0": 3.0}, {"V1": 4.0}, {})
    task.code["init"](moment)
    task.code["cycle"](moment)
    assert moment.outputs == {"V1": 4.0 + 3.0 + 1.0}


def test_a_probe_is_a_module_with_the_same_ports():
    probe = SampleTask("a", inconst=("C0",), invar=("C0", "V0"), outvar=("V1",), finish_after=2)
    rig = ExecutiveRig().spawn("a", source(probe))
    ports = {port.port for port in rig.task("a").spawn.ports}
    assert (ports, rig.task("a").trigger) == ({"C0", "V0", "V1"}, True)


def test_only_a_probe_that_takes_goes_on_where_the_code_before_it_stood():
    assert ["take" in law_task(SampleTask("a", takes=takes)).code for takes in (False, True)] == [False, True]
    assert ["def take" in source(SampleTask("a", takes=takes)) for takes in (False, True)] == [False, True]
