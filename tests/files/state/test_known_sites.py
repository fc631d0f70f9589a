from onika.files.state.known_sites import KnownSite, KnownSites


def test_a_site_is_known_again_by_what_it_is_and_not_by_where(tmp_path):  # R-F06
    sites = KnownSites(tmp_path / "sites")
    assert sites.meet("cmu", "a", "cmu.example:7995") is None
    assert sites.meet("cmu", "a", "elsewhere:7995") is None
    assert sites.all() == {"cmu": KnownSite("a", "elsewhere:7995")}


def test_another_site_of_the_same_name_is_told_and_not_believed(tmp_path):  # R-F06
    sites = KnownSites(tmp_path / "sites")
    sites.meet("cmu", "a", "cmu.example:7995")
    assert sites.meet("cmu", "b", "other:7995") == KnownSite("a", "cmu.example:7995")
    assert sites.forget("cmu") and not sites.forget("cmu")
    assert sites.meet("cmu", "b", "other:7995") is None


def test_a_file_that_is_none_knows_no_site_and_is_nobody_elses(tmp_path):
    path = tmp_path / "sites"
    path.write_text("{")
    sites = KnownSites(path)
    assert sites.all() == {}
    sites.meet("cmu", "a", "x")
    assert path.stat().st_mode & 0o077 == 0
    assert [file.name for file in tmp_path.iterdir()] == ["sites"]
