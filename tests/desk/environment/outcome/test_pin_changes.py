from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.outcome.pin_changes import resettled, settled
from onika.desk.environment.state.content import Content
from onika.model.task import Task

A = Task("a", "a", outvar=("Q",), frequency=1.0)
B = Task("b", "b", invar=("Q",), frequency=1.0)


def test_a_document_none_of_whose_pins_have_changed_is_the_same_object(tmp_path):
    sitting = EnvironmentFixture(tmp_path, (A, B))
    doc = sitting.new("a")
    model = sitting.environment.model
    libraries = model.libraries.edited({"b": Task("b", "b", aliases=(("Q", "R"),), invar=("Q",), frequency=1.0)})
    content = model.documents[doc].content
    assert settled(content, model.libraries, libraries) is content
    assert resettled(model, model.libraries) is model


def test_the_second_task_of_a_variable_brings_its_locus_half_way_by_an_alias_too(tmp_path):  # R-C24
    free = Task("b", "b", aliases=(("Q", "R"),), invar=("Q",), frequency=1.0)
    sitting = EnvironmentFixture(tmp_path, (A, free))
    doc = sitting.new("a", "b")
    model = sitting.environment.model
    content = model.documents[doc].content
    libraries = model.libraries.edited({"b": B})
    joined = settled(content, model.libraries, libraries)
    alone = {locus.svar: locus for locus in content.configuration.loci}
    (locus,) = joined.configuration.loci
    assert (locus.svar, locus.conns) == ("Q", 2)
    assert (locus.x, locus.y) != (alone["Q"].x, alone["Q"].y)
    parted = settled(joined, libraries, model.libraries)
    assert {locus.svar for locus in parted.configuration.loci} == {"Q", "R"}
    assert isinstance(parted, Content)
