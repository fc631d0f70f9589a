from pathlib import Path

from onika.store.remote.checkout_path import checkout_path, is_checked_out


def test_every_lock_has_its_own_folder_of_a_library():  # R-F03
    one = checkout_path(Path("/c/onika"), Path("/home/ann/onika"), "wings")
    other = checkout_path(Path("/c/onika"), Path("/home/bob/onika"), "wings")
    assert one != other
    assert one.name == other.name == "wings"


def test_what_is_of_others_is_known_by_where_it_stands():  # R-F03
    folder = checkout_path(Path("/c/onika"), Path("/home/ann/onika"), "wings")
    assert is_checked_out(folder) and is_checked_out(folder / "module" / "wink.py")
    assert not is_checked_out(folder.parent) and not is_checked_out(Path("/home/ann/onika/libraries/wings"))
