from onika.desk.trial.home import home_of
from onika.store.site import open_site


def test_a_test_beside_applications_is_at_home_in_their_base_directory(tmp_path):  # R-X07
    site = open_site([], {}, None)
    own, lone = tmp_path / "lab", tmp_path / "alone" / "tests"
    for folder in (own / "appl", own / "tests", lone):
        folder.mkdir(parents=True)
    assert home_of(own / "tests" / "a.test", site).directories[0].path == own
    assert home_of(lone / "a.test", site) == site
    assert home_of(own / "a.test", site) == site
