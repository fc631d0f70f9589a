"""Small bases as files: one on two wheels, of which one is turned round, and one on slides, with a world for each."""

from collections.abc import Mapping

ROVER = """<mujoco><compiler angle="radian"/><worldbody><body name="car" pos="0 0 0.1">
<geom type="box" size="0.2 0.1 0.03" mass="3"/>
<geom type="sphere" size="0.03" pos="0.2 0 -0.07" mass="0.1" condim="1" priority="1"/>
<body name="left" pos="0 0.2 0"><joint name="left" axis="0 1 0"/>
<geom type="ellipsoid" size="0.1 0.02 0.1" mass="0.5"/></body>
<body name="right" pos="0 -0.2 0"><joint name="right" axis="0 -1 0"/>
<geom type="ellipsoid" size="0.1 0.02 0.1" mass="0.5"/></body>
</body></worldbody>
<actuator><motor name="l" joint="left" ctrlrange="-5 5"/><motor name="r" joint="right" ctrlrange="-5 5"/></actuator>
</mujoco>"""

CROSS = """<mujoco><compiler angle="radian"/><worldbody><body name="cross" pos="0 0 0.1">
<joint name="x" type="slide" axis="1 0 0"/><joint name="y" type="slide" axis="0 1 0"/><joint name="turn" axis="0 0 1"/>
<geom type="box" size="0.2 0.2 0.05" mass="10"/>
<body name="post" pos="0 0 0.1"><joint name="bend" axis="0 1 0" range="-1 1"/>
<geom type="capsule" size="0.02" fromto="0 0 0 0 0 0.3" mass="1"/><site name="tip" pos="0 0 0.3"/></body>
</body></worldbody></mujoco>"""

ROBOT = "VERSION 2.0\nFILE {file}.xml\nBASE base\n{moves}\nSPEED 1 2\n{more}EOF\n"
WORLD = (
    "VERSION 2.0\nCONTACT elliptic 10\nFLOOR 0\nPLACE bay\nROBOTS {robots}\nAT 1 2 0 90\nBUTTON panic\nSTOPS bay\nEOF\n"
)

FILES: Mapping[str, str] = {
    "world/floor.world": WORLD.format(robots="rover cross"),
    "robot/rover.robot": ROBOT.format(file="rover", moves="WHEELS l r 0.1 0.4", more=""),
    "robot/cross.robot": ROBOT.format(file="cross", moves="SLIDES x y turn", more="ARM arm\nTOOL tip\nFROM cross\n"),
    "robot/rover.xml": ROVER,
    "robot/cross.xml": CROSS,
}
"""At one place, turned by a quarter: a rover, or a base on slides with an arm of one joint."""
