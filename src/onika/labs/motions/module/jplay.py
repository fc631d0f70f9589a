"""A taught path, played."""

from pathlib import Path

from onika.laws.joint_motion import JointMotion
from onika.laws.paths.joined_path import JoinedPath
from onika.laws.paths.taught_path import TaughtPath, path_of_text
from onika.laws.sentence import sentence_of
from onika.module import AskAgain, InConst, Input, InVar, Local, Module, ModuleError, OutVar, finish


class Jplay(Module):
    """Plays a path that was taught: first from where the arm is to where the path begins, then along it.

    Between the rows of the file the path is smooth, and it is at rest at both ends. The file is read at `on`.

    Kind     trigger, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int           -      number of joints
             INCONST  QMIN    double[NDOF]  rad    lower joint limits
             INCONST  QMAX    double[NDOF]  rad    upper joint limits
             INCONST  Q^_MAX  double[NDOF]  rad/s  highest joint speeds
             INVAR    Q_MEZ   double[NDOF]  rad    measured position; the start where no reference is in force
             OUTVAR   Q_REF   double[NDOF]  rad    reference position; preloaded at `on`, it is the start
             OUTVAR   Q^_REF  double[NDOF]  rad/s  reference speed
    Local    SPEED            double        -      share of Q^_MAX that a motion may peak at
             SETTLE           double        s      how long the arm may take to come to rest
             AWAY             double        rad    how far from its target a joint may come to rest
    Input    file             string        -      file of the path, as `teach` writes it
    Finish   flow 0, loop FALSE, when the time is over and the arm stands at the end of the path, or SETTLE later
    Errors   no path       the file is not there, or not of this arm: asks again, stays OFF
             out of reach  a row is beyond QMIN..QMAX: asks again, stays OFF
             too fast      taught faster than SPEED: warns and takes as long as it needs
             blocked       a joint is further than AWAY from its target when its time is over: ERROR
    Get/Set  progress 0..1, of the whole time / -
    Source   dissertation §4.4
    """

    trigger = True

    NDOF = InConst("int", "-", "number of joints")
    QMIN = InConst("double[NDOF]", "rad", "lower joint limits")
    QMAX = InConst("double[NDOF]", "rad", "upper joint limits")
    Qd_MAX = InConst("double[NDOF]", "rad/s", "highest joint speeds", name="Q^_MAX")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position; the start where no reference is in force")
    Q_REF = OutVar("double[NDOF]", "rad", "reference position; preloaded at `on`, it is the start")
    Qd_REF = OutVar("double[NDOF]", "rad/s", "reference speed", name="Q^_REF")

    SPEED = Local("double", "-", "share of Q^_MAX that a motion may peak at", default=0.6, low=0.01, high=1.0)
    SETTLE = Local("double", "s", "how long the arm may take to come to rest", default=0.5, low=0.0)
    AWAY = Local("double", "rad", "how far from its target a joint may come to rest", default=0.05, low=1e-3)

    file = Input("string", "-", "file of the path, as `teach` writes it")

    def on(self, inputs):
        start = (self.Q_REF if self.continues("Q_REF") else self.Q_MEZ).copy()
        speed = self.SPEED * self.Qd_MAX
        try:
            times, rows = path_of_text(Path(inputs.file).read_text(encoding="utf-8"), self.NDOF)
            path = TaughtPath(times, rows, speed)
            path.check_range(self.QMIN, self.QMAX)
        except OSError as wrong:
            raise AskAgain("{file}: {why}", file=inputs.file, why=wrong.strerror or "") from None
        except ValueError as wrong:
            raise AskAgain("{file}: {why}", file=inputs.file, why=sentence_of(wrong)) from None
        if path.stretch > 1.0 + 1e-9:
            self.warn("taught too fast for the joint speeds; the path takes {duration:.2f} s", duration=path.duration)
        joined = JoinedPath(start, path, speed)
        self._motion = JointMotion(joined, joined.end, self.Q_MEZ, self.SETTLE)
        self.Q_REF = start
        self.Qd_REF = 0.0

    def cycle(self):
        self.Q_REF, self.Qd_REF = self._motion.advance(self.dt)
        if not self._motion.is_over(self.Q_MEZ, self.dt):
            return None
        if why := self._motion.short(self.Q_MEZ, self.AWAY):
            raise ModuleError(why)
        return finish()

    def get(self, name):
        if name == "progress":
            return self._motion.progress
        return super().get(name)
