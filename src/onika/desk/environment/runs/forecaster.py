"""What open applications would come to is foreseen while they are edited: one at a time, in the background (E16).

A forecast begins when an application that could run has rested for a moment. The next edit ends it, and so does any
run: nothing is foreseen while something moves.
"""

from base64 import b64encode
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import partial

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.desk.environment.runs.begin import ready
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import Foretelling, MishapAtStep, OpenApplication
from onika.desk.run.forecast import Forecast, ForecastResult, ForeseenMishap
from onika.model.syntax import Syntax
from onika.store.site import Site
from onika.wire import act
from onika.wire.view import ForeseenInstantView
from onika.words.reason import Reason

REST_S = 0.15
"""How long an application rests before it is foreseen."""


@dataclass(slots=True)
class _Subject:
    """An application that is foreseen, as it was when that began; what foresees it, once that is under way."""

    opened: OpenApplication
    forecast: Forecast | None = None
    is_ended: bool = False

    def end(self) -> None:
        self.is_ended = True
        if self.forecast is not None:
            self.forecast.end()


class Forecaster:
    """Foresees open applications; `worker` is where, and how what comes of it is told."""

    def __init__(self, site: Site, worker: BackgroundWorker) -> None:
        self._site = site
        self._worker = worker
        self._subject: _Subject | None = None
        self._rest: dict[str, tuple[object, float]] = {}

    def look(self, model: Model, now_s: float) -> None:
        """End what is not wanted any more, and begin what is; asked again and again."""
        rested = self._rested(model, now_s)
        subject = self._subject
        if subject is not None and (model.going or not _is_current(subject.opened, model)):
            subject.end()
        if subject is not None or model.going or model.syntax is None:
            return
        following = next(iter(_unforeseen(rested)), None)
        if following is not None:
            self._begin(following, model.syntax)

    def close(self) -> None:
        """End what is under way; nothing more is told."""
        if self._subject is not None:
            self._subject.end()
        self._worker.close()

    def _rested(self, model: Model, now_s: float) -> list[OpenApplication]:
        """The applications that have not changed for a moment, the newest first."""
        former, self._rest = self._rest, {}
        rested: list[OpenApplication] = []
        for doc, opened in model.applications.items():
            since = former.get(doc, (None, now_s))
            if since[0] is not opened.application:
                since = (opened.application, now_s)
            self._rest[doc] = since
            if now_s - since[1] >= REST_S:
                rested.insert(0, opened)
        return rested

    def _begin(self, opened: OpenApplication, syntax: Syntax) -> None:
        subject = self._subject = _Subject(opened)
        self._worker.tell(partial(told, doc=opened.id, foretelling=Foretelling(opened.application, opened.redirects)))
        self._worker.do(partial(self._carry_out, subject, syntax))

    def _carry_out(self, subject: _Subject, syntax: Syntax) -> None:
        """In the worker's thread."""
        try:
            foretelling = self._foretold(subject, syntax)
        finally:
            self._subject = None
        if foretelling is None or subject.is_ended:
            self._worker.tell(partial(told, doc=subject.opened.id, foretelling=None))
        else:
            self._worker.tell(partial(told, doc=subject.opened.id, foretelling=foretelling))

    def _foretold(self, subject: _Subject, syntax: Syntax) -> Foretelling | None:
        opened = subject.opened
        prepared = ready(opened, self._site, syntax, passes_breakpoints=True)
        if prepared.plan is None or prepared.faults:
            return Foretelling(opened.application, opened.redirects, is_going=False)
        subject.forecast = forecast = Forecast(prepared.plan, prepared.targets)
        if subject.is_ended:
            return None
        return _foretelling(opened, forecast.carry_out())


def told(model: Model, doc: str, foretelling: Foretelling | None) -> Done:
    """The model with what is foreseen of an application; None: it is not foreseen any more."""
    opened = model.applications.get(doc)
    if opened is None:
        return Done(model)
    return Done(model.with_application(replace(opened, foretelling=foretelling)))


def instant(model: Model, command: act.ForeseenInstant, _outside: Services) -> Done | No:
    """Reply with a `view.ForeseenInstantView`."""
    opened = model.applications.get(command.doc)
    foretold = None if opened is None else opened.foretold
    if foretold is None or not 1 <= command.number <= len(foretold.mishaps):
        return No(Reason.of("run.not_foreseen_any_more"))
    mishap = foretold.mishaps[command.number - 1]
    scene, poses = foretold.scenes.get(mishap.world, {}), b64encode(mishap.poses).decode()
    shown = ForeseenInstantView(mishap.world, mishap.at_s, mishap.text, scene, poses, mishap.lit)
    return Done(model, value=shown)


def _unforeseen(rested: Iterable[OpenApplication]) -> Iterable[OpenApplication]:
    """Those that could run and are not foreseen as they are now."""
    for opened in rested:
        judgement = opened.judgement
        can_run = judgement is not None and opened.is_judged and all(one.level != "fault" for one in judgement.faults)
        has_steps = any(flow.steps for flow in opened.application.flows)
        if can_run and has_steps and not opened.is_partial and not opened.is_foretold:
            yield opened


def _is_current(subject: OpenApplication, model: Model) -> bool:
    opened = model.applications.get(subject.id)
    return opened is not None and opened.application is subject.application and opened.redirects == subject.redirects


def _foretelling(opened: OpenApplication, result: ForecastResult) -> Foretelling:
    return Foretelling(
        opened.application,
        opened.redirects,
        is_going=False,
        lasts_s=result.lasts_s,
        cause=result.cause,
        mishaps=tuple(map(_at_step, result.mishaps)),
        standing=result.standing,
        watched=result.watched,
        scenes=result.scenes,
    )


def _at_step(mishap: ForeseenMishap) -> MishapAtStep:
    """At the step of the application itself, also where it happens within one that it uses."""
    action = mishap.action
    step = 0 if action is None else (*action.spot, action.line)[0]
    return MishapAtStep(step, mishap.text, mishap.at_s, mishap.world, mishap.poses, mishap.lit)
