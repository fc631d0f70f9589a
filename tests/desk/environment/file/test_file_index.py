from pathlib import Path

from kit.labs.laboratory import HOLE, Laboratory, job
from onika.desk.environment.file.file_index import (
    again,
    application,
    is_application,
    is_configuration,
    listed,
    of_base,
    without,
)
from onika.desk.environment.state.model import Model
from onika.model.configuration import Configuration
from onika.model.rules.iconify import ActionType
from onika.store.base_directory import BaseDirectory
from onika.store.site import open_site

SYNTAX, _ = open_site([], {}, None).syntax()


def test_every_configuration_is_listed_with_its_number_of_tasks_and_the_faults_are_told(tmp_path):  # R-C06
    (tmp_path / "conf").mkdir()
    (tmp_path / "conf" / "two.conf").write_text("VERSION 1.2\nRMODFILE a\nCOORDS 1 2\nRMODFILE b\nCOORDS 1 2\nEOF\n")
    (tmp_path / "conf" / "bad.conf").write_text("VERSION 1.2\nRMODFILE a\nEOF\n")
    (tmp_path / "conf" / "notes.txt").write_text("")
    listing = listed([BaseDirectory(tmp_path), BaseDirectory(tmp_path / "nowhere")], SYNTAX)
    assert {Path(path).name: file.tasks for path, file in listing.files.items()} == {"two.conf": 2, "bad.conf": 0}
    assert {Path(fault.place.file).name for fault in listing.faults} == {"bad.conf"}
    sources = {Path(path).name: source for path, source in listing.sources.items()}
    assert isinstance(sources["two.conf"], Configuration) and sources["bad.conf"] is None


def test_every_application_is_listed_with_its_flows_and_icons_and_the_type_it_has_as_an_icon(tmp_path):  # R-D01, R-D09
    lab = Laboratory(tmp_path)
    lab.application("two", [job("a"), job("b")], [job("c")])
    lab.application("open", [job("jmoveC", "Joint job"), HOLE])
    lab.application("odd", [HOLE])
    (tmp_path / "appl" / "bad.appl").write_text("VERSION 1.3\nNONSENSE\nEOF\n")
    listing = listed([BaseDirectory(tmp_path)], SYNTAX)
    sizes = {
        application_entry.name: (application_entry.flows, application_entry.icons)
        for application_entry in listing.applications.values()
    }
    assert sizes == {"two": (2, 3), "open": (1, 1), "odd": (1, 0), "bad": (0, 0)}
    kinds = {Path(path).stem: source for path, source in listing.sources.items()}
    assert (kinds["two"], kinds["open"]) == (ActionType("Complete application"), ActionType("Joint application"))
    assert kinds["bad"] is None and kinds["odd"][0].reason
    assert {Path(fault.place.file).name for fault in listing.faults} == {"bad.appl"}
    assert application(BaseDirectory(tmp_path), "two", None).sources == {str(tmp_path / "appl" / "two.appl"): None}


def test_a_file_is_listed_again_and_what_is_as_it_was_is_the_same_model(tmp_path):  # R-C06
    path = Laboratory(tmp_path).application("one", [job("a")])
    model = listed([BaseDirectory(tmp_path)], SYNTAX).beside(Model())
    assert again(path, SYNTAX).beside(model) is model
    Laboratory(tmp_path).application("one", [job("a"), job("b")])
    assert again(path, SYNTAX).beside(model).application_files[str(path)].icons == 2
    path.unlink()
    assert again(path, SYNTAX) is None
    assert again(tmp_path / "conf" / "gone.conf", SYNTAX) is None


def test_what_is_listed_of_a_base_directory_goes_with_it(tmp_path):  # R-C01
    lab = Laboratory(tmp_path)
    lab.application("one", [job("a")])
    lab.configuration("c", "a 100")
    model = listed([BaseDirectory(tmp_path)], SYNTAX).beside(Model())
    paths = of_base(model, str(tmp_path))
    assert [Path(path).name for path in paths] == ["c.conf", "one.appl"]
    left = without(model, paths)
    assert (left.files, left.application_files, left.sources) == ({}, {}, {})
    assert without(left, paths) is left


def test_only_files_in_a_conf_folder_are_configurations_and_in_an_appl_folder_applications():  # R-B08
    assert is_configuration(Path("/a/conf/b.conf"))
    assert not is_configuration(Path("/a/module/b.conf"))
    assert not is_configuration(Path("/a/conf/b.rmod"))
    assert is_application(Path("/a/appl/b.appl"))
    assert not is_application(Path("/a/conf/b.appl"))
