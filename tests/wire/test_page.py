import pytest

from onika.wire import page


@pytest.mark.parametrize("body", [b"", b"{}", b"null", b'{"cid":"x","act":{"t":"New"}}', b'{"cid":1,"act":{}}'])
def test_what_is_no_act_is_a_value_error(body):
    with pytest.raises(ValueError):
        page.decode(body)


def test_a_run_that_was_taken_is_steered_by_few_wishes_only():  # R-X12
    with pytest.raises(ValueError, match="wish"):
        page.decode('{"cid":1,"act":{"t":"SteerTaken","subsystem":"flow0","wish":"skip"}}')
