"""A watch on how an arm follows its reference."""

import numpy as np

from onika.module import InConst, InVar, Local, Module, ModuleError

MOVES = 1e-3  # rad/s


class Following(Module):
    """Watches that the measured joints follow the reference, and stops the run where they cannot be true.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int           -      number of joints
             INCONST  Q^_MAX  double[NDOF]  rad/s  highest joint speeds
             INVAR    Q_REF   double[NDOF]  rad    reference position
             INVAR    Q_MEZ   double[NDOF]  rad    measured position
    Local    AWAY    double  rad  how far a joint may be from its reference
             FAST    double  -    share of Q^_MAX at which a measured joint may move from one cycle to the next
             SILENT  double  s    how long what is measured may stay the same while the reference moves
    Errors   jump          a measured joint moved faster than FAST Q^_MAX: ERROR
             silent        no measured joint changed for SILENT, though references moved: ERROR
             stuck         one measured joint did not change for SILENT, though its reference moved: ERROR
             away          a joint is further than AWAY from its reference: ERROR
             no reference  Q_REF was not written since the hardware held: only jumps are seen until it is
    """

    NDOF = InConst("int", "-", "number of joints")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    Q_REF = InVar("double[NDOF]", "rad", "reference position")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")

    AWAY = Local("double", "rad", "how far a joint may be from its reference", default=0.1, low=1e-4, high=10.0)
    FAST = Local(
        "double",
        "-",
        "share of Q^_MAX at which a measured joint may move from one cycle to the next",
        default=1.5,
        low=0.1,
        high=100.0,
    )
    SILENT = Local(
        "double",
        "s",
        "how long what is measured may stay the same while the reference moves",
        default=0.1,
        low=0.001,
        high=60.0,
    )

    def on(self, inputs):
        # a reference from before the last hold is not followed, and nobody is away from it
        self._stale = None if self.continues("Q_REF") else self.Q_REF.copy()
        self._measured, self._wanted = self.Q_MEZ.copy(), self.Q_REF.copy()
        self._same = np.zeros(self.NDOF)  # for how long each has been the same while its reference moved
        self._all_same = 0.0  # for how long all of them have been the same

    def cycle(self):
        moved = np.abs(self.Q_MEZ - self._measured)
        wanted = np.abs(self.Q_REF - self._wanted)
        self._measured[:], self._wanted[:] = self.Q_MEZ, self.Q_REF
        self._check_jump(moved / self.dt)
        if self._stale is not None and np.array_equal(self.Q_REF, self._stale):
            return
        if self._stale is not None:
            self._stale = None
            return  # the first reference may lie anywhere, as seen from a stale one
        self._same[wanted > MOVES * self.dt] += self.dt
        self._same[moved > 0.0] = 0.0
        self._all_same = 0.0 if moved.any() else self._all_same + self.dt
        self._check_change()
        self._check_place()

    def _check_jump(self, speed):
        if (speed <= self.FAST * self.Qd_MAX).all():
            return
        joint = int((speed / self.Qd_MAX).argmax())
        raise ModuleError(
            "joint {joint} is measured to move at {speed:.2f} rad/s, and can move at {most:.2f} rad/s",
            joint=joint + 1,
            speed=float(speed[joint]),
            most=float(self.Qd_MAX[joint]),
        )

    def _check_change(self):
        longest = float(self._same.max())
        if longest < self.SILENT - self.dt / 2.0:  # sums of periods are not exact
            return
        if self._all_same >= longest:
            raise ModuleError("nothing measured has changed for {time:.3f} s while the arm was to move", time=longest)
        raise ModuleError(
            "joint {joint} is measured to stand still for {time:.3f} s while it was to move",
            joint=int(self._same.argmax()) + 1,
            time=longest,
        )

    def _check_place(self):
        away = np.abs(self.Q_REF - self.Q_MEZ)
        joint = int(away.argmax())
        if away[joint] > self.AWAY:
            raise ModuleError(
                "joint {joint} is measured {away:.3f} rad from where it is to be, {most:g} rad are allowed",
                joint=joint + 1,
                away=float(away[joint]),
                most=self.AWAY,
            )
