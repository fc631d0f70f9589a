from pathlib import Path

from onika.desk.environment.listing import entry, is_configuration, listed
from onika.store.base_directory import BaseDirectory


def test_every_configuration_is_listed_with_its_number_of_tasks_and_the_faults_are_told(tmp_path):  # R-C06
    (tmp_path / "conf").mkdir()
    (tmp_path / "conf" / "two.conf").write_text("VERSION 1.2\nRMODFILE a\nCOORDS 1 2\nRMODFILE b\nCOORDS 1 2\nEOF\n")
    (tmp_path / "conf" / "bad.conf").write_text("VERSION 1.2\nRMODFILE a\nEOF\n")
    (tmp_path / "conf" / "notes.txt").write_text("")
    found, faults = listed([BaseDirectory(tmp_path), BaseDirectory(tmp_path / "nowhere")])
    assert {Path(path).name: file.tasks for path, file in found.items()} == {"two.conf": 2, "bad.conf": 0}
    assert {Path(one.place.file).name for one in faults} == {"bad.conf"}
    assert entry(BaseDirectory(tmp_path), "two")[0].base == str(tmp_path)


def test_only_files_in_a_conf_folder_are_configurations():  # R-B08
    assert is_configuration(Path("/a/conf/b.conf"))
    assert not is_configuration(Path("/a/module/b.conf"))
    assert not is_configuration(Path("/a/conf/b.rmod"))
