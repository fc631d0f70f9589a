from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model


def test_blank_configurations_take_the_first_free_number():  # R-C21
    model = Model()
    assert model.blank().name == "Untitled-1"
    model = model.with_document(Document("c1", Content(model.blank())))
    assert model.blank().name == "Untitled-2"
    assert model.without("c1").blank().name == "Untitled-1"
