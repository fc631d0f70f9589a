from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.outcome.other_tasks import with_other_tasks
from onika.model.configuration import Configuration
from onika.model.task import Task
from onika.words.reason import Reason

TASKS = (
    Task("cubic", "cubic", outvar=("Q_REF",), frequency=100.0),
    Task("pd", "pd", invar=("Q_REF",), frequency=100.0),
)


def test_a_document_with_no_task_left_has_no_locus_left(tmp_path):  # R-C09
    fixture = EnvironmentFixture(tmp_path, TASKS)
    doc = fixture.new("cubic", "pd")
    model = fixture.environment.model
    document = model.documents[doc]
    assert document.content.configuration.loci

    done = with_other_tasks(model, document, Configuration(document.name), Reason.plain("removing all"))

    changed = done.model.documents[doc].content
    assert (changed.names, changed.configuration.loci) == ((), ())
    assert (str(done.label), done.doc) == ("removing all", doc)
