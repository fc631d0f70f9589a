from onika.desk.environment.file.recordings_folder import recording_path, recordings_folder


def test_a_recording_is_called_by_its_application_and_when_it_began(tmp_path):  # R-X05
    path = recording_path(tmp_path, "assemble", 1_795_302_900.0)
    assert path.parent == recordings_folder(tmp_path)
    assert path.name.startswith("assemble-2026") and path.suffix == ".mcap"


def test_two_runs_of_one_second_have_files_of_their_own(tmp_path):
    recordings_folder(tmp_path).mkdir()
    first = recording_path(tmp_path, "assemble", 0.0)
    first.touch()
    second = recording_path(tmp_path, "assemble", 0.0)
    second.touch()
    assert len({first, second, recording_path(tmp_path, "assemble", 0.0)}) == 3
