"""The partner that a test leads by the hand."""

import pytest

from onika.runtime.partner.partner import Partner
from onika.testing.fake_partner import FakePartner, wait


def test_it_hears_and_says_what_the_test_wants(tmp_path):
    with FakePartner(tmp_path) as outsider:
        partner = Partner(outsider.address)
        partner.ask("what", x=1)
        call = outsider.accept()
        question = call.read()
        assert (question["ask"], question["x"]) == ("what", 1)
        call.answer(question, y=2)
        assert wait(partner)
        assert partner.answer.fields["y"] == 2
        assert not call.has_ended()
        partner.close()
        assert call.has_ended()


def test_where_it_does_not_listen_nobody_calls(tmp_path):
    outsider = FakePartner(tmp_path, listens=False)
    with pytest.raises(RuntimeError, match="open it first"):
        outsider.accept()


def test_nothing_comes_of_waiting_where_nothing_is_asked(tmp_path):
    with FakePartner(tmp_path) as outsider:
        assert not wait(Partner(outsider.address), 0.01)
