"""An arm known by its constants alone: kinematics and dynamics of any chain or tree of joints.

Joints, masses and tool are given at q = 0 in frame 0, so that no frames of links are needed (decision 46). A private
MuJoCo model without contacts is built of them at the first question (every body frame is frame 0 at q = 0), so that
one code serves every arm, and fast: about 2 us a question.
"""

import mujoco
import numpy as np

from onika.laws.chain import text_of
from onika.laws.frames import Array, Numbers, as_array, quaternion_of_rotation
from onika.laws.screws import Parents, parents, places, screws, slides
from onika.laws.sentence import LawSentence

_SMALL_KG, _SMALL_KG_M2 = 1e-13, 1e-14  # a moving body needs some mass: what a link without one is given
_ROUNDING = 1e-6  # as a share: how far the largest moment of inertia may be above the other two by rounding


class ArmModel:
    """A chain or tree of n joints; the last one bears the load and the tool.

    `screw` double[n,6]: axis and moment of each joint (`onika.laws.screws`). `link` double[n,13], what each joint
    moves by itself: mass kg, centre x y z m, inertia about it xx yy zz xy xz yz kg m2, armature kg m2, viscous friction
    N m s/rad, dry friction N m (kg, N s/m, N where it slides). `parent` int[n]: the joint that bears each, -1 the base.
    `load` double[4]: mass kg and centre m. `tool` double[4,4]. All at q = 0 in frame 0. `base` double[4,4]: frame 0 in
    the world. What is left out is nothing: no mass, no load, no offset, a chain.
    """

    def __init__(
        self,
        screw: Numbers,
        link: Numbers | None = None,
        parent: Numbers | Parents | None = None,
        load: Numbers | None = None,
        base: Numbers | None = None,
        tool: Numbers | None = None,
    ) -> None:
        self.screw = screws(screw)
        self.n = n = len(self.screw)
        self.link = as_array(np.zeros((n, 13)) if link is None else link, (n, 13))
        self.parent = parents(parent, n)
        self.load = as_array(np.zeros(4) if load is None else load, (4,))
        self.base = as_array(np.eye(4) if base is None else base, (4, 4))
        self.tool = as_array(np.eye(4) if tool is None else tool, (4, 4))
        self.slides = slides(self.screw)
        self.armature, self.viscous, self.dry = (self.link[:, k].copy() for k in (10, 11, 12))
        self._built = False

    def forward(self, q: Numbers, out: Array | None = None) -> Array:
        """World pose double[4,4] of the tool at q (rad, m); fills and gives back `out` where given."""
        if not self._built:
            self._build()
        self._qpos[self._order] = q
        mujoco.mj_kinematics(self._model, self._data)
        pose = np.empty((4, 4)) if out is None else out
        pose[:3, :3] = self._site_turn
        pose[:3, 3] = self._site_place
        pose[3] = (0.0, 0.0, 0.0, 1.0)
        return pose

    def joint_places(self, q: Numbers) -> Array:
        """World place double[n,3] of each joint at q, on its axis and near the joint before it: where to draw it."""
        if not self._built:
            self._build()
        self._qpos[self._order] = q
        mujoco.mj_kinematics(self._model, self._data)
        anchors: Array = self._data.xanchor[self._order].copy()
        return anchors

    def bias(self, q: Numbers, qd: Numbers, out: Array | None = None) -> Array:
        """Torque double[n] (N m, N) that gravity and Coriolis ask for at q and qd; without friction."""
        if not self._built:
            self._build()
        torque = np.empty(self.n) if out is None else out
        self._pass(q, qd)
        mujoco.mj_rne(self._model, self._data, 0, self._torque)
        torque[:] = self._torque[self._order]
        return torque

    def torque(self, q: Numbers, qd: Numbers, qdd: Numbers, out: Array | None = None) -> Array:
        """Torque double[n] (N m, N) for the acceleration qdd (rad/s2, m/s2) at q and qd; without friction.

        tau = (M(q) + armature) qdd + c(q, qd) + g(q)
        """
        if not self._built:
            self._build()
        torque = np.empty(self.n) if out is None else out
        self._data.qacc[self._order] = qdd
        self._pass(q, qd)
        mujoco.mj_rne(self._model, self._data, 1, self._torque)
        np.multiply(self.armature, qdd, out=torque)
        torque += self._torque[self._order]
        return torque

    def inertia(self, q: Numbers) -> Array:
        """Mass matrix double[n,n] (kg m2, kg) at q, the armature in it: column by column from inverse dynamics."""
        rest = np.zeros(self.n)
        gravity = self.bias(q, rest)
        return np.array([self.torque(q, rest, row) - gravity for row in np.eye(self.n)])

    def jacobian(self, q: Numbers, out: Array | None = None) -> Array:
        """Jacobian double[6,n] of the tool at q in the world: three rows m/s, three rows rad/s."""
        if not self._built:
            self._build()
        self._qpos[self._order] = q
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_comPos(self._model, self._data)
        matrix = np.empty((6, self.n)) if out is None else out
        mujoco.mj_jacSite(self._model, self._data, self._jacobian[:3], self._jacobian[3:], 0)
        matrix[:] = self._jacobian[:, self._order]
        return matrix

    def _pass(self, q: Numbers, qd: Numbers) -> None:
        """The way outwards of the recursive dynamics: places and speeds."""
        model, data = self._model, self._data
        self._qpos[self._order] = q
        self._qvel[self._order] = qd
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_comVel(model, data)

    def _build(self) -> None:
        self._model = mujoco.MjModel.from_xml_string(self._text())
        self._data = mujoco.MjData(self._model)
        # MuJoCo numbers the joints of a tree branch by branch; in a chain they stand as here
        order = [self._model.joint(f"j{k}").id for k in range(self.n)]
        self._order: slice | list[int] = slice(None) if order == list(range(self.n)) else order
        # views into MuJoCo's own memory; asking the data object for one costs more than the kinematics
        self._qpos: Array = self._data.qpos
        self._qvel: Array = self._data.qvel
        self._site_turn: Array = self._data.site_xmat[0].reshape(3, 3)
        self._site_place: Array = self._data.site_xpos[0]
        self._torque, self._jacobian = np.empty(self.n), np.empty((6, self.n))
        self._built = True

    def _text(self) -> str:
        inner = ["" for _ in range(self.n)]
        inner[-1] = f"<site {_place(self.tool)}/>" + _load(self.load)
        root = ""
        anchors = places(self.screw)
        for k in reversed(range(self.n)):
            body = f"<body>{self._inertial(k)}{self._joint(k, anchors[k])}{inner[k]}</body>"
            before = int(self.parent[k])
            if before < 0:
                root = body + root
            else:
                inner[before] = body + inner[before]
        return (
            '<mujoco><compiler angle="radian"/><option gravity="0 0 -9.81"/>'
            f"<worldbody><body {_place(self.base)}>{root}</body></worldbody></mujoco>"
        )

    def _joint(self, k: int, anchor: Array) -> str:
        slide = bool(self.slides[k])
        axis = self.screw[k, 3:] if slide else self.screw[k, :3]
        kind = "slide" if slide else "hinge"
        return f'<joint name="j{k}" type="{kind}" axis="{text_of(axis)}" pos="{text_of(anchor)}"/>'

    def _inertial(self, k: int) -> str:
        row = self.link[k]
        turn, moments = _principal(row[4:10], k + 1)
        return (
            f'<inertial pos="{text_of(row[1:4])}" quat="{text_of(turn)}" '
            f'mass="{max(float(row[0]), _SMALL_KG)!r}" diaginertia="{text_of(moments)}"/>'
        )


def _place(pose: Array) -> str:
    return f'pos="{text_of(pose[:3, 3])}" quat="{text_of(quaternion_of_rotation(pose[:3, :3]))}"'


def _load(load: Array) -> str:
    """A point of mass; none where it weighs nothing."""
    if not load[0] > 0.0:
        return ""
    moments = text_of((_SMALL_KG_M2,) * 3)
    return f'<body><inertial pos="{text_of(load[1:])}" mass="{float(load[0])!r}" diaginertia="{moments}"/></body>'


def _principal(inertia: Array, joint: int) -> tuple[Array, Array]:
    """Quaternion and principal moments of xx yy zz xy xz yz; raises ValueError where no body has such."""
    xx, yy, zz, xy, xz, yz = inertia.tolist()
    moments, axes = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if np.linalg.det(axes) < 0.0:
        axes[:, 0] *= -1.0
    least, middle, most = moments.tolist()
    lack = most - least - middle
    if not (least >= -_ROUNDING * most and lack <= _ROUNDING * most):
        raise ValueError(
            LawSentence(
                "laws.inertia_impossible",
                "expected moments of inertia of link {joint} of which none is larger than the other two together, "
                "found {least:.4g} {middle:.4g} {most:.4g}",
                joint=joint,
                least=least,
                middle=middle,
                most=most,
            )
        )
    possible = moments + max(lack, 0.0)
    return quaternion_of_rotation(axes), np.maximum(possible, _SMALL_KG_M2)
