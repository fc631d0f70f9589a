from dataclasses import replace

from onika.desk.environment.initial_model import opened
from onika.desk.environment.state.arrangements import with_arrangements
from onika.store.site import open_site


def test_the_orders_of_all_open_folders_are_read_and_what_is_wrong_is_told_once(tmp_path):  # R-D24, R-B07
    site = open_site([tmp_path], {}, tmp_path / "home")
    for folder in ("module", "dict"):
        (tmp_path / folder).mkdir()
    (tmp_path / "dict" / "OnikaArrangement.dta").write_text("VERSION     2.0\n\nPLACE       b\nPLACE       a\n\nEOF\n")
    own = tmp_path / "home" / "onika" / "module"
    own.mkdir(parents=True)
    (own / "OnikaArrangement.dta").write_text("nonsense\n")
    model, _ = opened(site, None, {})
    assert model.arrangements == {str(tmp_path / "dict"): ("b", "a")}
    again, faults = with_arrangements(model, site)
    assert again is model
    assert {fault.place.file for fault in faults} == {str(own / "OnikaArrangement.dta")}
    assert len(faults) == len(set(faults))  # four shipped libraries share the file
    assert with_arrangements(replace(model, arrangements={}), site)[0].arrangements == model.arrangements
