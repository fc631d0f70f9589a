"""Keeps a run as a test: demands of later runs what stays the same when the run is disturbed (requirement X07)."""

from collections.abc import Callable, Collection, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

from onika.desk.run.settings import RunSettings
from onika.desk.trial.account import CompletedAction, Elements, FlowAccount, RunAccount, give_account, measured
from onika.desk.trial.home import home_of
from onika.desk.trial.tolerance import LASTS_S, demand, readable, tolerance
from onika.desk.trial.variables import FLOORS, KeptVariable
from onika.files import kept, text, whole
from onika.model.kept import Demand, KeptAction, KeptFlow, KeptRun
from onika.store.site import Site
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason

SHAKES = 4
"""How many runs with shaken worlds and other seeds are looked at beside the one that is kept."""


@dataclass(frozen=True, slots=True)
class KeepResult:
    """A run that was kept, and what is worth knowing of it; without one, why not."""

    kept: KeptRun | None
    notes: tuple[Reason, ...] = ()
    refusal: Reason = NOTHING
    hash: str = ""
    """Of the run, to be compared with another."""


Progress = Callable[[int, int], None]
"""Told which run begins, from 1, and how many there will be; or nobody is."""


def keep(
    settings: RunSettings, site: Site, *, workers: int = 1, shakes: int = SHAKES, progress: Progress | None = None
) -> KeepResult:
    """Do a run, and others with shaken worlds, and keep what they have in common.

    progress    with one worker, who is told how far it is
    """
    refusal = unkeepable(settings)
    if refusal:
        return KeepResult(None, refusal=refusal)
    plain = _plain(settings)
    shaken = [replace(plain, seed=settings.seed + n, shake=settings.seed + n) for n in range(1, shakes + 1)]
    if workers > 1:
        with ThreadPoolExecutor(workers) as pool:
            first, *others = pool.map(lambda settings: give_account(settings, site), [plain, *shaken])
    else:  # no pool: it would keep a program that is about to end from ending
        first, *others = _one_by_one([plain, *shaken], site, progress or (lambda *_: None))
    return kept_of(settings, first, others)


def _one_by_one(attempts: Sequence[RunSettings], site: Site, progress: Progress) -> Iterable[RunAccount]:
    """Of a run that cannot be kept the others say nothing: they are not done."""
    for number, attempt in enumerate(attempts, start=1):
        progress(number, len(attempts))
        account = give_account(attempt, site)
        yield account
        if number == 1 and not _is_good(account):
            return


def _is_good(account: RunAccount) -> bool:
    return not (account.refusals or account.cause) and all(holds for _, _, holds in account.expectations)


def keep_in(
    path: Path,
    settings: RunSettings,
    site: Site,
    *,
    workers: int = 1,
    seen: str = "",
    progress: Progress | None = None,
    say: Callable[[Reason], str] = str,
) -> tuple[bool, tuple[Reason, ...]]:
    """Keep a run in a test file: whether that could be done, and what is to be said of it, for a command or a page.

    seen    the hash of the run that the user has seen; empty: he has seen none
    say     makes the words of the comment at the head of a new file
    """
    refusal = unkeepable(settings, path)
    if refusal:
        return False, (refusal,)
    result = keep(settings, site, workers=workers, progress=progress)
    if result.kept is None:
        return False, (result.refusal,)
    notes = list(result.notes)
    if seen and result.hash != seen:
        notes.append(Reason.of("trial.not_the_same"))
    file = site.application_file(settings.name)
    named = replace(result.kept, application=file.stem if file is not None else settings.name)
    source = home_of(path, site).application_file(named.application)
    if file is not None and (source is None or not source.samefile(file)):
        folder = str(file.absolute().parent.parent)
        notes.append(Reason.of("trial.other_application", name=named.application, folder=folder))
    unwritten = store(named, path, say)
    if unwritten is not None:
        return False, (unwritten.sentence,)
    actions, demands = _count(named)
    return True, (Reason.of("trial.kept", actions=actions, values=demands), *notes)


def _count(kept_run: KeptRun) -> tuple[int, int]:
    actions = [action for flow in kept_run.flows for action in flow.actions]
    demands = [*(action.after for action in actions), *(flow.at_end for flow in kept_run.flows)]
    return len(actions), sum(map(len, demands))


def store(kept_run: KeptRun, path: Path, say: Callable[[Reason], str] = str) -> Refusal | None:
    """Write a test; the comments of one that stood there stay."""
    former, faults = ("", ()) if not path.exists() else text.load(path, str(path))
    if former is None:
        return Refusal(faults[0].sentence)
    written = kept.write(kept_run, former)
    if not former:
        head = say(Reason.of("trial.file_head", name=kept_run.application))
        written = f"{head}\n\n{written}"
    done = whole.write(path, written, whole.ANYTHING if path.exists() else whole.ABSENT)
    return done if isinstance(done, Refusal) else None


def kept_of(settings: RunSettings, first: RunAccount, others: Sequence[RunAccount]) -> KeepResult:
    """What is kept of a run, by the accounts of it and of others that are as good."""
    if first.refusals:
        return KeepResult(
            None, refusal=Reason.of("trial.reasons", reasons=tuple(fault.sentence for fault in first.refusals))
        )
    if first.cause:
        return KeepResult(None, refusal=Reason.of("trial.only_ended", cause=first.cause))
    failed = [text for text, _, holds in first.expectations if not holds]
    if failed:
        return KeepResult(None, refusal=Reason.of("trial.only_good", text=failed[0]))
    alike = [account for account in others if not account.cause and _way(account) == _way(first)]
    notes: list[Reason] = []
    if len(alike) < len(others):
        count = len(others) - len(alike)
        notes.append(Reason.of("trial.went_another_way", count=count, number=len(others)))
    flows = [_flow(number, first, alike) for number, part in enumerate(first.parts) if part.passed]
    return KeepResult(
        KeptRun(
            application=settings.name,
            digest=first.digest,
            flows=tuple(flows),
            meetings=tuple(first.meetings),
            seed=settings.seed,
            settle_s=settings.settle_s,
            answers=settings.answers,
            expectations=tuple(expectation.text for expectation in settings.expectations),
            redirects=tuple(map(str, settings.redirects)),
        ),
        tuple(notes),
        hash=first.hash,
    )


def unkeepable(settings: RunSettings, path: Path | None = None) -> Reason:
    """Why a run like this cannot be kept, in such a file; nothing where it can."""
    file_ending = Reason.of("trial.file_ending", ending=kept.ENDING)
    objections = {
        file_ending: path is not None and path.suffix != kept.ENDING,
        Reason.of("trial.in_virtual_time"): not settings.is_virtual or settings.scale is not None,
        Reason.of("trial.own_runtime"): settings.elsewhere is not None,
        Reason.of("trial.not_steered"): settings.script is not None,
        Reason.of("trial.from_beginning"): settings.source is not None,
        Reason.of("trial.flows_by_own_names"): bool(settings.subsystems),
    }
    wrong = tuple(reason for reason, is_so in objections.items() if is_so)
    if wrong:
        return Reason.of("trial.reasons", reasons=wrong)
    return NOTHING


def _plain(settings: RunSettings) -> RunSettings:
    """What of a run a test can do again: nobody looks on, nothing is recorded."""
    return RunSettings(
        name=settings.name,
        is_virtual=True,
        has_black_box=False,
        expectations=settings.expectations,
        settle_s=settings.settle_s,
        seed=settings.seed,
        answers=settings.answers,
        redirects=settings.redirects,
    )


def _way(account: RunAccount) -> list[list[str]]:
    return [[passed.name for passed in part.passed] for part in account.parts]


def _flow(number: int, first: RunAccount, alike: Sequence[RunAccount]) -> KeptFlow:
    part, others = first.parts[number], [account.parts[number] for account in alike]
    actions = []
    for at, passed in enumerate(part.passed):
        following = part.passed[at + 1] if at + 1 < len(part.passed) else None
        actions.append(_action(passed, following, [account.passed[at] for account in others]))
    names = {variable.name for variable in measured(part)}
    notices = tuple(only_news(tuple(on_the_way(actions, names))))
    return KeptFlow(part.subsystem, part.robots, notices, tuple(_at_end(part, others)))


def _action(
    passed: CompletedAction, following: CompletedAction | None, others: Sequence[CompletedAction]
) -> KeptAction:
    lasted = [account.ended_s - account.began_s for account in (passed, *others)]
    within = tolerance(LASTS_S, max(abs(duration - lasted[0]) for duration in lasted))
    within = within if within is not None else round(max(lasted), 1)
    lasting = [variable for variable in passed.variables if variable.is_measured or _lasts(variable, passed, following)]
    after = _demands(lasting, passed.values, [account.values for account in others])
    return KeptAction(passed.name, readable(lasted[0], within), within, tuple(after))


def _lasts(reference: KeptVariable, passed: CompletedAction, following: CompletedAction | None) -> bool:
    """Whether what was read is still the reference of this action: the next one has begun at the same instant.

    It is where nobody else writes it, and where the robot stands just there.
    """
    theirs = {variable.name: variable.writer for variable in (following.variables if following else ())}
    if theirs.get(reference.name, reference.writer) == reference.writer:
        return True
    wanted, reach = passed.values[reference.name], 2 * FLOORS.get(reference.units[0], 0.0)
    measured = [
        passed.values[variable.name]
        for variable in passed.variables
        if variable.is_measured and variable.units == reference.units
    ]
    return any(
        len(values) == len(wanted) and all(abs(a - b) <= reach for a, b in zip(values, wanted, strict=True))
        for values in measured
    )


def _at_end(part: FlowAccount, others: Sequence[FlowAccount]) -> Iterable[Demand]:
    return _demands(measured(part), part.at_end, [account.at_end for account in others])


def _demands(variables: Iterable[KeptVariable], values: Elements, others: Sequence[Elements]) -> Iterable[Demand]:
    for variable in variables:
        for address in values:
            if address == variable.name or address.startswith(f"{variable.name}["):
                runs = [values[address], *(other[address] for other in others if address in other)]
                requirement = demand(address, variable.unit_of(address), variable.is_real, runs)
                if requirement is not None:
                    yield requirement


def on_the_way(actions: Sequence[KeptAction], measured: Collection[str]) -> Iterable[KeptAction]:
    """The actions, marked where one only leads away, as a lift does.

    The action before it changed something else while this robot stood, and all that it is measured to change is changed
    again by the very next. Places that are visited one after the other are not marked: each may be the purpose.
    """
    latest: dict[str, Demand] = {}
    former: set[str] = set()
    for at, action in enumerate(actions):
        seen = {each.address: each for each in action.after if each.address.partition("[")[0] in measured}
        changed = {address for address, each in seen.items() if _differs(latest.get(address), each)}
        latest |= seen
        following = {each.address: each for each in actions[at + 1].after} if at + 1 < len(actions) else {}
        is_passed_over = all(
            address in following and _differs(latest[address], following[address]) for address in changed
        )
        leads_away = bool(changed) and bool(former) and not changed & former
        yield replace(action, is_on_way=leads_away and is_passed_over)
        former = changed


def only_news(actions: Sequence[KeptAction]) -> Iterable[KeptAction]:
    """The actions, without whole numbers that are what they were: a lamp is told when it changes."""
    latest: dict[str, Demand] = {}
    for action in actions:
        after = tuple(each for each in action.after if each.tolerance or latest.get(each.address) != each)
        latest |= {each.address: each for each in action.after}
        yield replace(action, after=after)


def _differs(before: Demand | None, now: Demand) -> bool:
    if before is None or len(before.values) != len(now.values):
        return True
    within = max(before.tolerance, now.tolerance)
    return any(abs(a - b) > within for a, b in zip(before.values, now.values, strict=True))
