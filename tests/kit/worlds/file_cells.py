"""Small worlds as files: an arm of three joints that stands at a place, a slide, a gripper, a cube that moves."""

from collections.abc import Mapping

from onika.wire.world_source import WorldFile, WorldSource, digest_of

ARM = """<mujoco model="elbow">
  <compiler angle="radian" autolimits="true"/>
  <worldbody>
    <body name="foot">
      <geom name="foot" type="cylinder" size="0.08 0.2" pos="0 0 0.2"/>
      <body name="upper" pos="0 0 0.4">
        <joint name="turn" axis="0 0 1" range="-3 3" armature="0.02" damping="0.1"/>
        <geom type="capsule" size="0.03" fromto="0 0 0 0.3 0 0" mass="2"/>
        <body name="lower" pos="0.3 0 0">
          <joint name="bend" axis="0 1 0" range="-2 2" armature="0.02"/>
          <geom type="capsule" size="0.025" fromto="0 0 0 0.18 0 0" mass="1"/>
          <body name="quill" pos="0.25 0 0">
            <joint name="lift" type="slide" axis="0 0 1" range="-0.1 0.1" armature="0.1"/>
            <geom type="box" size="0.02 0.02 0.02" mass="0.3"/>
            <site name="tip" pos="0 0 -0.1" euler="3.14159265358979 0 0"/>
            <body name="finger1" pos="0.0 0.01 -0.08">
              <joint name="finger1" type="slide" axis="0 1 0" range="0 0.03" damping="5"/>
              <geom type="box" size="0.01 0.002 0.02" mass="0.02"/>
            </body>
            <body name="finger2" pos="0.0 -0.01 -0.08">
              <joint name="finger2" type="slide" axis="0 -1 0" range="0 0.03" damping="5"/>
              <geom type="box" size="0.01 0.002 0.02" mass="0.02"/>
            </body>
          </body>
        </body>
      </body>
    </body>
  </worldbody>
  <equality><joint joint1="finger1" joint2="finger2" polycoef="0 1 0 0 0"/></equality>
  <actuator>
    <motor name="turn" joint="turn" ctrlrange="-40 40"/>
    <motor name="bend" joint="bend" ctrlrange="-40 40"/>
    <motor name="lift" joint="lift" ctrlrange="-200 200"/>
    <position name="squeeze" joint="finger1" kp="400" ctrlrange="0 0.03" forcerange="-20 20"/>
  </actuator>
</mujoco>
"""

ROBOT = """VERSION 2.0
FILE elbow.xml
ARM arm
TOOL tip
HOME 0.2 0.3 0
SPEED 3 3 0.5
GRIPPER gripper
MOVES squeeze
OPEN 0.03 0.06
CLOSED 0 0
EOF
"""

CUBE = """<mujoco><worldbody><body name="cube">
<geom name="cube" type="box" size="0.02 0.02 0.02" mass="0.1" rgba="1 0 0 1"/>
<site name="top" pos="0 0 0.02"/></body></worldbody></mujoco>"""

TABLE = """<mujoco><worldbody><geom name="board" type="box" size="0.3 0.3 0.02"/>
<site name="patch" type="box" size="0.05 0.05 0.01" pos="0 0 0.02"/></worldbody>
<sensor><touch name="patch" site="patch"/></sensor></mujoco>"""

WORLD = """VERSION 2.0
DESC an arm and a cube
FLOOR 0
PART table
FILE table.xml
AT 0.6 -0.9 0.02 0
PART cube
FILE cube.xml
AT 0.6 -0.9 0.06 0
FREE 0.01
PLACE left
ROBOTS elbow stiff
AT 0 0 0 0
PLACE right
ROBOTS elbow
AT 2 0 0 180
SWITCH rests
NEAR cube.top table.patch 0.05
LAMP lamp
WHEN rests
SHINES cube.cube
BUTTON panic
STOPS left right
EOF
"""

CELL: Mapping[str, str] = {
    "world/cell.world": WORLD,
    "robot/elbow.robot": ROBOT,
    "robot/stiff.robot": ROBOT.replace("SPEED", "DRIVE torque\nHOME 0.2 0.3 0\nSPEED").replace(
        "HOME 0.2 0.3 0\n", "", 1
    ),
    "robot/elbow.xml": ARM,
    "world/cube.xml": CUBE,
    "world/table.xml": TABLE,
}
"""An arm that takes positions, one at the same place that takes torques, a second place, a cube on a table, a lamp."""


def files_of(texts: Mapping[str, str] = CELL, world: str = "cell") -> WorldSource:
    """These texts as the files of a world."""
    files = tuple(WorldFile(name, f"/lab/{name}", text.encode()) for name, text in texts.items())
    return WorldSource(world, digest_of(files), files)


def changed(name: str, old: str, new: str) -> WorldSource:
    """The files of the cell with one text changed."""
    if old not in CELL[name]:
        raise ValueError(f"expected {old!r} in {name}")
    return files_of({**CELL, name: CELL[name].replace(old, new, 1)})
