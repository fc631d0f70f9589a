"""A rule-based expert system that says what is wrong with an arm."""

import operator
import re

import numpy as np

from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar

_COMPARISONS = {"<": operator.lt, ">": operator.gt}
_MEASURES = ("away", "speed", "wanted", "effort")
_NUMBER_OF_RULES = 8
_CONDITION = re.compile(r"(\w+)(?:\s*([<>])\s*([-+.\deE]+))?")


class Diagnosis(Module):
    """Draws conclusions from what it sees of an arm, by rules with certainties, forward from rule to rule.

    It looks at the joint that is farthest from its reference: `away` (rad) how far, `speed` (rad/s) how fast it is
    measured to move, `wanted` (rad/s) how fast its reference moves, `effort` the share of TAUMAX that it is given. A
    rule is `away > 0.03 and speed < 0.02 then stands 0.9`: its conclusion is as certain as its least certain condition,
    times the number at its end. A conclusion may be a condition of other rules. Two rules with one conclusion add up to
    a + b - a b. What is told is the most certain conclusion that is no condition itself.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF        int           -     number of joints
             INCONST  TAUMAX      double[NDOF]  N m   highest joint torques
             INVAR    Q_REF       double[NDOF]  rad   reference position
             INVAR    Q_MEZ       double[NDOF]  rad   measured position
             INVAR    TAU_REF     double[NDOF]  N m   wanted torque
             OUTVAR   CONCLUSION  line          -     the most certain conclusion, and why; empty: none
             OUTVAR   CERTAINTY   double        -     how certain it is, 0..1
    Local    RULE1                line          -     a rule
             RULE2                line          -     a rule
             RULE3                line          -     a rule
             RULE4                line          -     a rule
             RULE5                line          -     a rule
             RULE6                line          -     a rule
             RULE7                line          -     a rule
             RULE8                line          -     a rule
             STOP                 double        -     a conclusion that is so certain for LASTING is an error; 2: never
             LASTING              double        s     how long it has to be so certain
    Errors   no rule              a rule that is none, or that follows from itself
             concluded            a conclusion is as certain as STOP for LASTING: ERROR, with the reasons
             no reference         Q_REF was not written since the hardware held: nothing is concluded until it is
    Source   paper III of the source; Shortliffe & Buchanan, Mathematical Biosciences 23 (1975)
    """

    NDOF = InConst("int", "-", "number of joints")
    TAUMAX = InConst("double[NDOF]", "N m", "highest joint torques")
    Q_REF = InVar("double[NDOF]", "rad", "reference position")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    TAU_REF = InVar("double[NDOF]", "N m", "wanted torque")
    CONCLUSION = OutVar("line", "-", "the most certain conclusion, and why; empty: none")
    CERTAINTY = OutVar("double", "-", "how certain it is, 0..1")

    RULE1 = Local("line", "-", "a rule", default="")
    RULE2 = Local("line", "-", "a rule", default="")
    RULE3 = Local("line", "-", "a rule", default="")
    RULE4 = Local("line", "-", "a rule", default="")
    RULE5 = Local("line", "-", "a rule", default="")
    RULE6 = Local("line", "-", "a rule", default="")
    RULE7 = Local("line", "-", "a rule", default="")
    RULE8 = Local("line", "-", "a rule", default="")
    STOP = Local(
        "double", "-", "a conclusion that is so certain for LASTING is an error; 2: never", default=2.0, low=0.0
    )
    LASTING = Local("double", "s", "how long it has to be so certain", default=0.1, low=0.0, high=60.0)

    def init(self):
        lines = (getattr(self, f"RULE{number + 1}") for number in range(_NUMBER_OF_RULES))
        rules = [self._rule(line) for line in lines if line.strip()]
        self._rules = self._in_order(rules)
        premises = {name for conditions, _, _ in rules for name, _, _ in conditions}
        self._ends = [name for _, name, _ in self._rules if name not in premises]

    def on(self, inputs):
        # a reference from before the last hold is not followed, and nobody is away from it
        self._stale = None if self.continues("Q_REF") else self.Q_REF.copy()
        self._measured, self._wanted = self.Q_MEZ.copy(), self.Q_REF.copy()
        self._lasting = 0.0
        self.CONCLUSION, self.CERTAINTY = "", 0.0

    def cycle(self):
        values = self._measures()
        if self._stale is not None and np.array_equal(self.Q_REF, self._stale):
            return
        self._stale = None
        certainties, reasons = self._infer(values)
        strongest = max(self._ends, key=lambda name: certainties[name], default="")
        self.CERTAINTY = certainties.get(strongest, 0.0)
        why = f"{strongest}, because {reasons[strongest]}" if self.CERTAINTY > 0.0 else ""
        self.CONCLUSION = why[:200]
        self._lasting = self._lasting + self.dt if self.CERTAINTY >= self.STOP else 0.0
        if self._lasting >= max(self.LASTING, self.dt) - self.dt / 2.0:  # sums of periods are not exact
            raise ModuleError("{conclusion} (certainty {certainty:.2f})", conclusion=why, certainty=self.CERTAINTY)

    def _measures(self):
        """What is seen of the joint that is farthest from its reference."""
        away = np.abs(self.Q_REF - self.Q_MEZ)
        joint = int(away.argmax())
        speed = abs(self.Q_MEZ[joint] - self._measured[joint]) / self.dt
        wanted = abs(self.Q_REF[joint] - self._wanted[joint]) / self.dt
        self._measured[:], self._wanted[:] = self.Q_MEZ, self.Q_REF
        effort = abs(self.TAU_REF[joint]) / self.TAUMAX[joint]
        return dict(zip(_MEASURES, (away[joint], speed, wanted, effort), strict=True))

    def _infer(self, values):
        """How certain each conclusion is, and from what it follows."""
        certainties, reasons = {name: 0.0 for _, name, _ in self._rules}, {}
        for conditions, name, strength in self._rules:
            parts = [
                certainties[fact] if sign is None else float(_COMPARISONS[sign](values[fact], bound))
                for fact, sign, bound in conditions
            ]
            certainty = strength * min(parts)
            if certainty > 0.0:
                why = " and ".join(
                    fact if sign is None else f"{fact} {sign} {bound:g}" for fact, sign, bound in conditions
                )
                reasons[name] = f"{reasons[name]}; {why}" if name in reasons else why
                certainties[name] += certainty - certainties[name] * certainty
        return certainties, reasons

    def _rule(self, line):
        """Conditions, conclusion, strength."""
        premise, then, end = line.partition(" then ")
        conditions = [self._condition(part) for part in premise.split(" and ")]
        conclusion, _, strength = end.strip().partition(" ")
        try:
            certainty = float(strength or 1.0)
        except ValueError:
            certainty = 0.0
        is_name = conclusion.isidentifier() and conclusion not in _MEASURES
        if not then or None in conditions or not is_name or not 0.0 < certainty <= 1.0:
            raise ModuleError(
                "expected a rule as in `away > 0.03 and speed < 0.02 then stands 0.9`, found {rule}", rule=line
            )
        return conditions, conclusion, certainty

    def _condition(self, text):
        """Measure, comparison, number; or a conclusion alone. None: neither."""
        parts = _CONDITION.fullmatch(text.strip())
        if parts is None or (parts[1] in _MEASURES) != (parts[2] is not None):
            return None
        try:
            return parts[1], parts[2], float(parts[3] or 0.0)
        except ValueError:
            return None

    def _in_order(self, rules):
        """The rules so that every conclusion is drawn before it is a condition."""
        ordered, left = [], list(rules)
        while left:
            open_names = {name for _, name, _ in left}
            ready = [rule for rule in left if not open_names & {fact for fact, _, _ in rule[0]}]
            if not ready:
                raise ModuleError(
                    "expected rules that do not follow from themselves, found {names}", names=sorted(open_names)
                )
            ordered += ready
            left = [rule for rule in left if rule not in ready]
        concluded = {name for _, name, _ in ordered} | set(_MEASURES)
        for conditions, _, _ in ordered:
            for fact, _, _ in conditions:
                if fact not in concluded:
                    raise ModuleError("expected a rule that concludes {name}, found none", name=fact)
        return ordered
