from onika.laws.device import no_hand, no_lamp


def test_a_hand_is_told_from_other_devices():  # R-X02
    assert no_hand({"ROBOT": "gripper"}) is None
    assert no_hand({"ROBOT": "puma560"}) == "expected a hand behind the device, found puma560"
    assert no_hand({"BOXES": "plus"}) == "expected a hand behind the device, found another device"


def test_the_lamp_is_told_from_other_devices():  # R-X02
    assert no_lamp({"BOXES": "plus"}) is None
    assert no_lamp({"WHEN": "on_pad"}) is None
    assert no_lamp({"ROBOT": "puma560"}) == "expected the lamp behind the device, found puma560"
    assert no_lamp({}) == "expected the lamp behind the device, found none"
