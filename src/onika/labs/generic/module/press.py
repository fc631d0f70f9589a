"""A force of the tool on what it meets."""

import numpy as np

from onika.laws.frames import rotation_exp
from onika.laws.paths.pressing import Pressing
from onika.module import AskAgain, Input, InVar, Local, Module, ModuleError, OutVar, finish

QUIET = 0.05  # s: how long the force is looked at from which pressing is counted


class PressingForce(Module):
    """Brings the tool to press with a force and a torque, along the axes of the world, and holds them for a while.

    It goes where the force points, as fast as it lacks, until it presses so; across it the tool stays where it is.
    Forces count from those that it feels when it begins, so that what it carries presses on nothing.

    Kind     trigger, periodic, 50..1000 Hz
    Ports    INVAR   X_MEZ  double[4,4]  -          measured pose; the start where no reference is in force
             INVAR   F_MEZ  double[6]    N,N m      force on the tool and torque about it, along the axes of the world
             OUTVAR  X_REF  double[4,4]  -          reference pose; preloaded at `on`, it is the start
    Local    SPEED          double       m/s        the highest speed
             TURN           double       rad/s      the highest speed of turning
             GAIN           double       m/s/N      how fast it goes for a force that lacks
             TWIST          double       rad/s/N m  how fast it turns for a torque that lacks
             NEAR           double       -          share of what is wanted that may lack
             HOLD           double       s          how long it presses
             FAR            double       m          how far it goes at most; of turning as many rad
             MOST           double       s          how long it takes at most
    Input    force          double[6]    -          force (N) and torque (N m) that the tool is to press with
    Finish   flow 0, loop FALSE, when for HOLD no more than NEAR of it lacked
    Errors   no force       all six are 0, or more than 200 N or 50 N m: asks again, stays OFF
             nothing met    it has gone FAR: ERROR, the tool stays where it is
             not held       it is not there after MOST: ERROR
    Get/Set  lacks, in N, of the force / -
    Source   Mason 1981; Craig, Introduction to Robotics, §11
    """

    trigger = True

    X_MEZ = InVar("double[4,4]", "-", "measured pose; the start where no reference is in force")
    F_MEZ = InVar("double[6]", "N,N m", "force on the tool and torque about it, along the axes of the world")
    X_REF = OutVar("double[4,4]", "-", "reference pose; preloaded at `on`, it is the start")

    SPEED = Local("double", "m/s", "the highest speed", default=0.02, low=1e-4)
    TURN = Local("double", "rad/s", "the highest speed of turning", default=0.1, low=1e-4)
    GAIN = Local("double", "m/s/N", "how fast it goes for a force that lacks", default=4e-4, low=1e-7)
    TWIST = Local("double", "rad/s/N m", "how fast it turns for a torque that lacks", default=1e-2, low=1e-7)
    NEAR = Local("double", "-", "share of what is wanted that may lack", default=0.1, low=0.01, high=1.0)
    HOLD = Local("double", "s", "how long it presses", default=0.5, low=0.0)
    FAR = Local("double", "m", "how far it goes at most; of turning as many rad", default=0.3, low=1e-3)
    MOST = Local("double", "s", "how long it takes at most", default=30.0, low=0.1)

    force = Input("double[6]", "-", "force (N) and torque (N m) that the tool is to press with")

    def on(self, inputs):
        force, torque = inputs.force[:3], inputs.force[3:]
        hard, twisted = float(np.linalg.norm(force)), float(np.linalg.norm(torque))
        if not (hard + twisted > 0.0 and hard <= 200.0 and twisted <= 50.0):
            raise AskAgain("expected a force up to 200 N or a torque up to 50 N m")
        self._pushing = Pressing(force, self.SPEED, self.GAIN)
        self._turning = Pressing(torque, self.TURN, self.TWIST)
        self._at_first, self._looks = np.zeros(6), 0
        self._time, self._pressed = 0.0, 0.0
        self.X_REF = (self.X_REF if self.continues("X_REF") else self.X_MEZ).copy()

    def cycle(self):
        self._time += self.dt
        if self._looks * self.dt < QUIET:
            self._looks += 1
            self._at_first += (self.F_MEZ - self._at_first) / self._looks
            return None
        felt = self.F_MEZ - self._at_first
        self.X_REF[:3, 3] += self._pushing.step(felt[:3], self.dt)
        self.X_REF[:3, :3] = rotation_exp(self._turning.step(felt[3:], self.dt)) @ self.X_REF[:3, :3]
        self._look_for_trouble()
        is_there = all(abs(way.lacks(part)) <= self.NEAR * way.most for way, part in self._ways(felt))
        self._pressed = self._pressed + self.dt if is_there else 0.0
        return finish() if is_there and self._pressed > self.HOLD - self.dt / 2.0 else None

    def get(self, name):
        if name == "lacks":
            return self._pushing.lacks((self.F_MEZ - self._at_first)[:3])
        return super().get(name)

    def _ways(self, felt):
        return (self._pushing, felt[:3]), (self._turning, felt[3:])

    def _look_for_trouble(self):
        if max(self._pushing.way, self._turning.way) > self.FAR:
            raise ModuleError("nothing to press on was met within {far:g} m or rad", far=self.FAR)
        if self._time > self.MOST:
            raise ModuleError("the tool did not come to press as hard as was wanted within {most:g} s", most=self.MOST)
