import pytest

from onika.agent.site_state import SiteState


def test_a_site_is_what_it_was_when_it_is_served_again(tmp_path):  # R-F06
    first = SiteState(tmp_path / "state", "cmu")
    first.close()
    again, other = SiteState(tmp_path / "state", "cmu"), SiteState(tmp_path / "state", "sandia")
    assert again.identity == first.identity != other.identity
    again.close()
    other.close()
    assert (tmp_path / "state" / "site-cmu").stat().st_mode & 0o077 == 0


def test_two_programs_do_not_serve_one_site(tmp_path):  # R-F06
    first = SiteState(tmp_path, "cmu")
    with pytest.raises(OSError, match="cmu is served by another program"):
        SiteState(tmp_path, "cmu")
    first.close()
    SiteState(tmp_path, "cmu").close()
