"""Motors at the end of a model."""

import mujoco

from kit.worlds.file_cells import ARM
from onika.store.motor_repair import with_motors


def test_each_joint_gets_a_motor_and_all_else_stays():  # R-X19
    bare = ARM.replace('<motor name="turn" joint="turn" ctrlrange="-40 40"/>', "")
    repaired = with_motors(bare.encode(), ("turn",)).decode()
    assert repaired.startswith(bare[: bare.index("</mujoco>")])
    model = mujoco.MjModel.from_xml_string(repaired)
    assert [model.actuator(k).name for k in range(model.nu)] == ["bend", "lift", "squeeze", "turn_motor"]
    assert not model.actuator("turn_motor").ctrllimited[0]


def test_it_stands_at_the_end_of_the_document_itself_and_names_are_quoted():  # R-X19
    text = b"<mujoco><!-- </mujoco> --></mujoco >"
    repaired = with_motors(text, ('a"b',))
    assert repaired.index(b"<actuator>") > text.index(b"-->") and b"'a\"b'" in repaired
    assert with_motors(b"<robot/>", ("a",)) == b"<robot/>"
