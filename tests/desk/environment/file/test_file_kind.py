import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.file.file_kind import FileReading, names_of, place
from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.state.open_file import DocumentKind
from onika.model.configuration import Configuration
from onika.store.opened_text import OpenedText
from onika.words.reason import Reason


@pytest.fixture
def sitting(tmp_path):
    sitting = EnvironmentFixture(tmp_path)
    sitting.base.save_configuration(Configuration("lamp"))
    return sitting


def test_a_file_is_found_by_its_path_or_by_its_name(sitting):  # R-C06
    path = sitting.base.configuration_file("lamp")
    for wish in ("lamp", str(path)):
        base, name = place(wish, DocumentKind.CONFIGURATION, sitting.surroundings)
        assert (base.path, name) == (sitting.base.path, "lamp")


@pytest.mark.parametrize(
    ("kind", "key"),
    [
        (DocumentKind.CONFIGURATION, "run.none_on_path_configuration"),
        (DocumentKind.APPLICATION, "run.none_on_path_application"),
    ],
)
def test_a_name_that_nobody_has_is_refused_with_the_kind_of_file(sitting, kind, key):
    assert place("gone", kind, sitting.surroundings) == No(Reason.of(key, name="gone"))


def test_a_file_in_another_folder_belongs_to_no_base_directory(sitting, tmp_path):
    stray = tmp_path / "lamp.appl"
    stray.write_text("")
    assert "stands in no folder appl/" in str(place(str(stray), DocumentKind.APPLICATION, sitting.surroundings).reason)


def test_names_are_listed_by_kind(sitting):
    assert names_of(sitting.base, DocumentKind.CONFIGURATION) == ("lamp",)
    assert names_of(sitting.base, DocumentKind.APPLICATION) == ()


def test_a_file_is_read_whole_unless_it_says_otherwise(sitting):
    opened = OpenedText(Configuration("lamp"), sitting.base.configuration_file("lamp"), "")
    assert not FileReading(sitting.base, opened).is_partial
