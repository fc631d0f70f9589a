"""Models of robots that drive, of which descriptions are made: a car on two wheels, and a sled with an arm."""


def car(free: str, kind: str, size: str, turned: str = "") -> str:
    """A car; `free` is its free joint, the others are the shape of its wheels."""
    wheel = f'<geom type="{kind}" size="{size}" {turned} mass="0.3" friction="1.2 0 0"/>'
    return f"""<mujoco><worldbody><body name="car" pos="0 0 0.2">{free}
<geom size="0.1" mass="2" contype="0" conaffinity="0"/>
<geom type="sphere" size="0.02" pos="-0.1 0 -0.16" mass="0.1" condim="1" priority="1"/>
<body name="l" pos="0.02 0.15 -0.1"><joint name="l" axis="0 1 0" damping="0.001"/>{wheel}</body>
<body name="r" pos="0.02 -0.15 -0.1"><joint name="r" axis="0 -1 0" damping="0.001"/>{wheel}</body>
</body></worldbody>
<actuator><motor name="right" joint="r" ctrlrange="-2 2"/><motor name="left" joint="l" ctrlrange="-2 2"/></actuator>
</mujoco>"""


CAR = car("<freejoint/>", "sphere", "0.08")

SLED = """<mujoco><worldbody><body name="cart" pos="0 0 0.1"><joint name="x" type="slide" axis="1 0 0" damping="0.01"/>
<geom size="0.05" mass="2" contype="0" conaffinity="0"/>
<body name="cross"><joint name="y" type="slide" axis="0 1 0" damping="0.01"/>
<geom size="0.05" mass="2" contype="0" conaffinity="0"/>
<body name="deck"><joint name="w" axis="0 0 1" damping="0.01"/>
<geom size="0.05" mass="2" contype="0" conaffinity="0"/>
<body name="upper" pos="0 0 0.1"><joint name="a" axis="0 1 0" range="-90 90" armature="0.05"/>
<geom type="capsule" size="0.02" fromto="0 0 0 0 0 0.3" mass="1"/>
<body name="fore" pos="0 0 0.3"><joint name="b" axis="0 1 0" range="-90 90" armature="0.05"/>
<geom type="capsule" size="0.02" fromto="0 0 0.03 0 0 0.3" mass="1"/>
<site name="tip" pos="0 0 0.3"/></body></body></body></body></body></worldbody>
<actuator><motor name="mx" joint="x" ctrlrange="-200 200"/>
<motor name="my" joint="y" ctrlrange="-200 200"/>
<motor name="mw" joint="w" ctrlrange="-50 50"/>
<motor name="ma" joint="a" ctrlrange="-50 50"/>
<motor name="mb" joint="b" ctrlrange="-50 50"/></actuator></mujoco>"""
