from onika.model.lifecycle import LifecycleInput
from onika.runtime.partner.absence import without_partner


def test_without_its_partner_a_passive_task_falls_silent_and_any_other_fails():  # R-X24
    assert without_partner(is_passive=True) is LifecycleInput.OFF
    assert without_partner(is_passive=False) is LifecycleInput.FAIL
