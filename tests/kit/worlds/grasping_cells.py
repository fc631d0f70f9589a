"""A small world in which an arm from a file takes things off a table: cubes, a post that is round, a plate too wide."""

from kit.worlds.file_cells import ARM, CELL, files_of
from onika.ring.device import DeviceOrder
from onika.wire.world_source import WorldSource
from onika.workcell.cell.file_world import FileWorld

TOP = 0.2
"""Height of the table."""
AT_CUBE = (0.0, 0.0, -0.08)
"""The joints where the fingers are about the first cube."""

_ROUND = """<mujoco><worldbody><body name="post">
<geom type="cylinder" size="0.018 0.04" mass="0.1"/></body></worldbody></mujoco>"""
_WIDE = """<mujoco><worldbody><body name="plate">
<geom type="box" size="0.1 0.1 0.01" mass="0.1"/></body></worldbody></mujoco>"""
_WORLD = """VERSION 2.0
FLOOR 0
PART table
FILE table.xml
AT 0.55 0 0.18 0
PART cube
FILE cube.xml
AT 0.55 0 0.22 {turn}
FREE
NAME en the red cube
NAME es el cubo rojo
PART other
FILE cube.xml
AT 0.45 0.2 0.22 0
FREE
PART post
FILE post.xml
AT 0.55 -0.2 0.24 0
FREE
PART plate
FILE plate.xml
AT 0.35 -0.2 0.21 0
FREE
PLACE left
ROBOTS elbow
SWITCH laid
PRESSED table.patch 0.5
LAMP lamp
WHEN laid
EOF
"""


_JAWS = """            <geom type="box" size="0.01 0.002 0.03" pos="0 -0.024 -0.07"/>
            <body name="jaw" pos="0 -0.018 -0.02">
              <joint name="jaw" axis="1 0 0" range="0 1.9" armature="0.001" damping="0.05"/>
              <geom type="box" size="0.01 0.002 0.04" pos="0 0 -0.04" mass="0.02"/>
            </body>
"""


def grasping_files(turn: float = 0.0) -> WorldSource:
    """The files; the first cube is turned by so many degrees."""
    texts = {"world/cell.world": _WORLD.format(turn=turn), "world/post.xml": _ROUND, "world/plate.xml": _WIDE}
    return files_of({**CELL, **texts})


def one_jaw(motor: str = '<position name="squeeze" joint="jaw" kp="10" ctrlrange="0 1.9" forcerange="-1 1"/>') -> str:
    """The model of the arm with a jaw that turns and one that does not move, which are parallel when closed."""
    first, last = (
        ARM.index('            <body name="finger1"'),
        ARM.index("          </body>\n        </body>\n      </body>"),
    )
    servo = ARM[ARM.index('    <position name="squeeze"') : ARM.index("  </actuator>")]
    text = ARM[:first] + _JAWS + ARM[last:].replace(servo, f"    {motor}\n")
    return text.replace('  <equality><joint joint1="finger1" joint2="finger2" polycoef="0 1 0 0 0"/></equality>\n', "")


def files_with(robot: str, model: str) -> WorldSource:
    """The same world with an arm of this description and model, and firm friction."""
    world = {"world/cell.world": _WORLD.format(turn=0.0).replace("FLOOR", "CONTACT elliptic 10\nFLOOR", 1)}
    things = {"world/post.xml": _ROUND, "world/plate.xml": _WIDE}
    return files_of({**CELL, **world, **things, "robot/elbow.robot": robot, "robot/elbow.xml": model})


class Cell:
    """The world, with its arm and gripper claimed, moved by hand; without forces unless said otherwise."""

    def __init__(self, turn: float = 0.0, *, has_forces: bool = False, files: WorldSource | None = None) -> None:
        self.world = FileWorld(files or grasping_files(turn))
        self.has_forces = has_forces
        self.arm = "elbow_left" if has_forces else "elbow_left_kin"
        self.world.claim(self.arm, 1)
        self.world.claim("gripper_left", 1)
        self.opening = 0.06
        self.posture = [0.0, 0.0, 0.0]

    def tick(self, times: int) -> None:
        """So many steps with a command each."""
        for _ in range(times):
            speeds = [0.0, 0.0, 0.0] if self.has_forces else []
            self.world.command(self.arm, 1, DeviceOrder.DRIVE, [*self.posture, *speeds])
            self.world.command("gripper_left", 1, DeviceOrder.DRIVE, [self.opening, 0.0])
            self.world.step(self.world.now_ns + self.world.step_ns)

    def go(self, *posture: float) -> None:
        """To this posture."""
        start = self.posture
        for k in range(1, 301):
            self.posture = [a + (b - a) * k / 300 for a, b in zip(start, posture, strict=True)]
            self.tick(1)
        self.tick(100)

    def grip(self, opening: float) -> None:
        """Open or close the fingers."""
        self.opening = opening
        self.tick(200)

    def place(self, part: str) -> list[float]:
        """Where a part is."""
        row: list[float] = self.world._plant.data.joint(f"{part}.free").qpos[:3].tolist()
        return row
