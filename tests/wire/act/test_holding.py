import pytest

from onika.wire import act, page


def test_what_is_taken_is_a_documents_or_is_named():  # R-X12
    named = page.decode('{"cid":1,"act":{"t":"Take","subsystem":"flow0"}}').act
    assert (named.doc, named.subsystem, named.confirmed) == ("", "flow0", False)
    assert page.decode('{"cid":1,"act":{"t":"Take","doc":"c1"}}').act == act.Take("c1")


def test_a_run_that_was_taken_is_steered_by_these_wishes_only():  # R-X12
    with pytest.raises(ValueError, match="wish"):
        page.decode('{"cid":1,"act":{"t":"SteerTaken","subsystem":"flow0","wish":"skip"}}')
