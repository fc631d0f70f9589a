from kit.desk.dictionary_fixture import DictionaryFixture
from onika.desk.environment.icons.measured_variables import measures_of
from onika.desk.environment.icons.measuring_remedies import ways_to_measure
from onika.wire import act


def test_configurations_that_measure_it_could_be_opened_those_of_its_own_job_first(tmp_path):  # R-X01
    cabinet = DictionaryFixture(tmp_path)
    kind = cabinet.environment.model.syntax.find("Cartesian object")
    measures = measures_of(cabinet.environment.model, kind)
    ways = ways_to_measure(cabinet.environment.model, measures, kind)
    assert 0 < len(ways) <= 3
    assert all(isinstance(way.act, act.Open) for way in ways)
    labels = [str(way.label) for way in ways]
    assert all("cmove" in label for label in labels)  # they take Cartesian targets, and nothing special is in them
    doc = cabinet.do(ways[0].act)
    ways = ways_to_measure(cabinet.environment.model, measures, kind)
    assert ways[0].act == act.Connect(doc)
