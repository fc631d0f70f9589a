"""Motors for joints of a model in MJCF that nothing drives: written at its end, all else stays as it is (X19)."""

import re
from collections.abc import Sequence
from xml.sax.saxutils import quoteattr

_END = re.compile(rb"</mujoco\s*>(?!.*</mujoco\s*>)", re.DOTALL)


def with_motors(content: bytes, joints: Sequence[str]) -> bytes:
    """The document with a motor at each of these joints, without a limit of its own."""
    motors = "".join(
        f'    <motor name={quoteattr(f"{joint}_motor")} joint={quoteattr(joint)} ctrllimited="false"/>\n'
        for joint in joints
    )
    block = f"  <actuator>\n{motors}  </actuator>\n".encode()
    return _END.sub(lambda end: block + end[0], content, count=1)
