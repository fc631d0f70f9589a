"""An arm known by its constants alone: forward kinematics, gravity and Coriolis torque, Jacobian.

A private MuJoCo model without contacts is built from the constants at the first question (body frame i = DH frame i),
so that one code serves every serial arm, and fast: about 2 us a question.
"""

import mujoco
import numpy as np

from onika.laws.chain import Link, kinds_of, links, text_of
from onika.laws.frames import Array, Numbers, as_array, quaternion_of_rotation

_SMALL = 1e-9  # a moving body needs some mass: what a chain without a table of masses is given


class SerialArm:
    """A serial arm of n joints.

    `dh` double[n,4]: a m, alpha rad, d m, theta offset rad (standard DH), a full turn more where the joint slides.
    `dyn` double[n,9]: mass kg, centre x y z m in frame i, principal inertia about it kg m2, armature kg m2, viscous
    friction N m s/rad (kg and N s/m where it slides). `load` double[4]: mass kg and centre m, in the last DH frame.
    `base`, `tool` double[4,4]: frame 0 in the world, the tool in the last DH frame. `kind` double[n]: 0 revolute,
    1 prismatic; left out, it is read from `dh`. What else is left out is nothing: no mass, no load, no offset.
    """

    def __init__(
        self,
        dh: Numbers,
        dyn: Numbers | None = None,
        load: Numbers | None = None,
        base: Numbers | None = None,
        tool: Numbers | None = None,
        kind: Numbers | None = None,
    ) -> None:
        n = np.size(dh) // 4
        self.n = n
        self.dh = as_array(dh, (n, 4))
        self.dyn = as_array(np.zeros((n, 9)) if dyn is None else dyn, (n, 9))
        self.load = as_array(np.zeros(4) if load is None else load, (4,))
        self.base = as_array(np.eye(4) if base is None else base, (4, 4))
        self.tool = as_array(np.eye(4) if tool is None else tool, (4, 4))
        self.kind = as_array(kinds_of(self.dh) if kind is None else kind, (n,))
        self.viscous = self.dyn[:, 8].copy()
        self._built = False

    def forward(self, q: Numbers, out: Array | None = None) -> Array:
        """World pose double[4,4] of the tool at q (rad, m); fills and gives back `out` where given."""
        if not self._built:
            self._build()
        self._qpos[:] = q
        mujoco.mj_kinematics(self._model, self._data)
        pose = np.empty((4, 4)) if out is None else out
        pose[:3, :3] = self._site_turn
        pose[:3, 3] = self._site_place
        pose[3] = (0.0, 0.0, 0.0, 1.0)
        return pose

    def bias(self, q: Numbers, qd: Numbers, out: Array | None = None) -> Array:
        """Torque double[n] (N m, N) that gravity and Coriolis ask for at q and qd; without viscous friction."""
        if not self._built:
            self._build()
        model, data = self._model, self._data
        self._qpos[:] = q
        self._qvel[:] = qd
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_comVel(model, data)
        torque = np.empty(self.n) if out is None else out
        mujoco.mj_rne(model, data, 0, torque)
        return torque

    def jacobian(self, q: Numbers, out: Array | None = None) -> Array:
        """Jacobian double[6,n] of the tool at q in the world: three rows m/s, three rows rad/s."""
        if not self._built:
            self._build()
        self._qpos[:] = q
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_comPos(self._model, self._data)
        matrix = np.empty((6, self.n)) if out is None else out
        mujoco.mj_jacSite(self._model, self._data, matrix[:3], matrix[3:], 0)
        return matrix

    def _build(self) -> None:
        self._model = mujoco.MjModel.from_xml_string(self._text())
        self._data = mujoco.MjData(self._model)
        # views into MuJoCo's own memory; asking the data object for one costs more than the kinematics
        self._qpos: Array = self._data.qpos
        self._qvel: Array = self._data.qvel
        self._site_turn: Array = self._data.site_xmat[0].reshape(3, 3)
        self._site_place: Array = self._data.site_xpos[0]
        self._built = True

    def _text(self) -> str:
        inner = f"<site {_place(self.tool)}/>"
        if self.load[0] > 0.0:
            inner += (
                f'<body><inertial pos="{text_of(self.load[1:])}" mass="{float(self.load[0])!r}" '
                f'diaginertia="{_SMALL} {_SMALL} {_SMALL}"/></body>'
            )
        for link, row in zip(reversed(links(self.dh, self.kind)), self.dyn[::-1], strict=True):
            inner = _body(link, row, inner)
        return (
            '<mujoco><compiler angle="radian"/><option gravity="0 0 -9.81"/>'
            f"<worldbody><body {_place(self.base)}>{inner}</body></worldbody></mujoco>"
        )


def _place(pose: Array) -> str:
    return f'pos="{text_of(pose[:3, 3])}" quat="{text_of(quaternion_of_rotation(pose[:3, :3]))}"'


def _body(link: Link, row: Array, inner: str) -> str:
    mass, inertia = max(float(row[0]), _SMALL), np.maximum(row[4:7], _SMALL)
    return (
        f'<body pos="{text_of(link.position)}" quat="{text_of(link.quaternion)}">'
        f'<inertial pos="{text_of(row[1:4])}" mass="{mass!r}" diaginertia="{text_of(inertia)}"/>'
        f'<joint type="{"slide" if link.slides else "hinge"}" axis="{text_of(link.axis)}" '
        f'pos="{text_of(link.anchor)}" armature="{float(row[7])!r}"/>{inner}</body>'
    )
