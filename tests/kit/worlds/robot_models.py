"""Models of robots as others publish them: with faults planted in a URDF, and without a gripper, a site, a limit."""

PLAIN = """<mujoco model="plain">
  <worldbody>
    <body name="post" pos="0 0 0.3">
      <joint name="turn" axis="0 0 1" armature="0.05"/>
      <geom type="capsule" size="0.03" fromto="0 0 0 0.3 0 0" mass="2"/>
      <body name="rod" pos="0.3 0 0">
        <joint name="bend" axis="0 1 0" range="-100 100" armature="0.05"/>
        <geom type="capsule" size="0.02" fromto="0.06 0 0 0.3 0 0" mass="1"/>
      </body>
    </body>
  </worldbody>
</mujoco>
"""
"""Two joints, of which one has no limits; no actuators, no site, no gripper."""

STATUE = """<mujoco><worldbody><body name="stone"><geom size="0.1"/></body></worldbody></mujoco>"""
"""Nothing moves."""

FAULTY = """<?xml version="1.0"?>
<!-- six axes with planted faults -->
<robot name="six" xmlns:xacro="http://x">
  <link name="base"><visual><geometry><mesh filename="package://six/meshes/gone.stl"/></geometry></visual>
    <collision><geometry><cylinder radius="0.06" length="0.1"/></geometry></collision></link>
  <link name="l1"><inertial><origin xyz="0 0 0.1" rpy="0 0 0"/><mass value="3"/>
  <inertia ixx="0.01" iyy="0.01" izz="0.5" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin xyz="0 0 0.1"/><geometry><cylinder radius="0.05" length="0.25"/></geometry></collision></link>
  <link name="l2"><inertial><origin xyz="0 0 0.2"/><mass value="3"/>
  <inertia ixx="0.04" iyy="0.04" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin xyz="0 0 0.2"/><geometry><cylinder radius="0.05" length="0.4"/></geometry></collision>
    <visual><geometry><mesh filename="meshes/l2.dae"/></geometry></visual></link>
  <link name="l3"><inertial><mass value="2"/>
  <inertia ixx="0.02" iyy="0.02" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><box size="0 0.1 0.1"/></geometry></collision></link>
  <link name="l4"><inertial><mass value="1"/>
  <inertia ixx="0.005" iyy="0.005" izz="0.005" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="l5"/>
  <link name="l6"><inertial><mass value="0.3"/>
  <inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="tool0"/>
  <link name="fl"><inertial><mass value="0.05"/>
  <inertia ixx="0.0001" iyy="0.0001" izz="0.0001" ixy="0" ixz="0" iyz="0"/></inertial><collision><geometry>
  <box size="0.02 0.01 0.04"/></geometry></collision></link>
  <link name="fr"><inertial><mass value="0.05"/>
  <inertia ixx="0.0001" iyy="0.0001" izz="0.0001" ixy="0" ixz="0" iyz="0"/></inertial><collision><geometry>
  <box size="0.02 0.01 0.04"/></geometry></collision></link>
  <joint name="j1" type="revolute"><parent link="base"/><child link="l1"/><origin xyz="0 0 0.1" rpy="0 0 0"/>
  <axis xyz="0 0 1"/><limit lower="-2.9" upper="2.9" effort="80" velocity="2.0 rad/s"/></joint>
  <joint name="j2" type="revolute"><parent link="l1"/><child link="l2"/><origin xyz="0 0 0.2"/>
  <axis xyz="0 1 0"/><axis xyz="1 0 0"/><limit lower="-2" upper="2" effort="80" velocity="2"/></joint>
  <joint name="j3" type="revolute"><parent link="l2"/><child link="l3"/><origin xyz="0 0 0.4"/>
  <axis xyz="0 1 0"/><limit lower="-2.5" upper="2.5" effort="60" velocity="2"/></joint>
  <joint name="j4" type="revolute"><parent link="l3"/><child link="l4"/><origin xyz="0 0 0.2"/>
  <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="30" velocity="3"/></joint>
  <joint name="j5" type="revolute"><parent link="l4"/><child link="l5"/><origin xyz="0 0 0.2"/>
  <axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="none" velocity="3"/></joint>
  <joint name="j6" type="continuous"><parent link="l5"/><child link="l6"/><origin xyz="0 0 0.08"/>
  <axis xyz="0 0 1"/><limit effort="10" velocity="3"/></joint>
  <joint name="tool" type="fixed"><parent link="l6"/><child link="tool0"/><origin xyz="0 0 0.12"/></joint>
  <joint name="finger_l" type="prismatic"><parent link="l6"/><child link="fl"/><origin xyz="0 0.01 0.1"/>
  <axis xyz="0 1 0"/><limit lower="0" upper="0.04" effort="20" velocity="0.1"/></joint>
  <joint name="finger_r" type="prismatic"><parent link="l6"/><child link="fr"/><origin xyz="0 -0.01 0.1"/>
  <axis xyz="0 -1 0"/><limit lower="0" upper="0.04" effort="20" velocity="0.1"/><mimic joint="finger_l"/>
  </joint>
  <gazebo/><transmission name="t"/>
</robot>
trailing
"""
"""Six axes and a gripper in URDF with what is often wrong: see `FAULTS`."""

FAULTS = (
    "what stands behind the end of the robot is struck out",
    "j1 limit: velocity '2.0 rad/s' is read as 2.0",
    "j2: a second `axis` is struck out",
    "j5 limit: effort was no number: it is left out",
    "package://six/meshes/gone.stl is not there, nor "
    "beside the model or in a folder above it: shapes made of it are left out",
    "l1: its inertia is impossible; the nearest possible one stands for it",
    "meshes/l2.dae is not there, nor beside the model or in a folder above it: shapes made of it are left out",
    "l3: a shape that has no size, or is none, is left out",
    "l5 has no mass",
)
"""What is told of them, in order."""


def _finger(name: str, side: int, more: str = "") -> str:
    return f"""<link name="{name}"><inertial><mass value="0.03"/>
  <inertia ixx="1e-5" iyy="1e-5" izz="1e-5" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><box size="0.008 0.02 0.05"/></geometry></collision></link>
<joint name="{name}" type="prismatic"><parent link="quill"/><child link="{name}"/>
  <origin xyz="{0.004 * side} 0 -0.13"/><axis xyz="{side} 0 0"/>
  <limit lower="0" upper="0.04" effort="30" velocity="0.2"/>{more}</joint>
"""


HOIST = f"""<robot name="hoist"><link name="base"/>
<link name="quill"><inertial><mass value="2"/>
  <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="z" type="prismatic"><parent link="base"/><child link="quill"/><origin xyz="0 0 0.4"/><axis xyz="0 0 1"/>
  <limit lower="-0.3" upper="0.05" effort="200" velocity="0.5"/></joint>
{_finger("finger_left", 1)}{_finger("finger_right", -1, '<mimic joint="finger_left"/>')}</robot>
"""
"""A slide with two fingers, one of which follows the other, as a URDF has them: without motors, gears and places."""
