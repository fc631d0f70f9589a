from onika.store.remote.checkout_path import checkout_path
from onika.store.remote.rights import is_confined, put_word


def test_what_is_of_a_library_of_others_may_compute_until_the_word_says_otherwise(tmp_path):  # R-X16
    folder = checkout_path(tmp_path / "onika", tmp_path / "base", "cmu.puma")
    code = folder / "module" / "pd.py"
    folder.mkdir(parents=True)
    assert is_confined(code)
    put_word(folder, has_all_rights=True)
    assert not is_confined(code)
    assert is_confined(folder.with_name("cmu.puma2") / "module" / "pd.py")
    put_word(folder, has_all_rights=False)
    put_word(folder, has_all_rights=False)
    assert is_confined(code)


def test_what_is_of_nobody_else_is_not_confined(tmp_path):
    assert not is_confined(tmp_path / "onika" / "module" / "pd.py")
