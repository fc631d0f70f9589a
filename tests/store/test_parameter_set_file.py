from onika.model.parameter_set import ParameterSet
from onika.model.task import LocalLine
from onika.store import parameter_set_file
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped
from onika.store.site import Site
from onika.words.fault import Refusal

SOFT = ParameterSet("soft", (("pd", LocalLine("STIFF", ("0.5",))),))


def site(tmp_path, home="home"):
    return Site((BaseDirectory(tmp_path),), shipped() / "prefs", tmp_path / home if home else None)


def test_sets_lie_beside_their_configuration(tmp_path):
    assert parameter_set_file.place(tmp_path, "move", site(tmp_path)) == tmp_path / "conf" / "move.sets"


def test_sets_of_what_comes_with_onika_are_kept_in_ones_own_base_directory(tmp_path):
    own = site(tmp_path)
    path = parameter_set_file.place(shipped() / "puma", "jmoveC", own)
    assert path == own.own / "conf" / "jmoveC.sets"
    assert isinstance(parameter_set_file.place(shipped() / "puma", "jmoveC", site(tmp_path, home="")), Refusal)


def test_what_is_kept_is_opened_again_and_another_writer_is_noticed(tmp_path):
    path = tmp_path / "conf" / "move.sets"
    assert parameter_set_file.opened(path) == (None, ())
    saved = parameter_set_file.kept(path, (SOFT,), None)
    again, faults = parameter_set_file.opened(path)
    assert (again, faults) == (saved, ())
    path.write_text(path.read_text() + "# mine\n")
    assert isinstance(parameter_set_file.kept(path, (), again), Refusal)
    assert "# mine" in path.read_text()
