"""What a run for a puzzle has to be so that it counts: the work of the program alone (requirements G10, H07)."""

from onika.desk.environment.runs import flow_stations
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.placed_puzzle import placed_puzzle
from onika.model.puzzle import Puzzle
from onika.store.site import Site
from onika.wire import act
from onika.wire.plan import Plan
from onika.words.reason import NOTHING, Reason


def puzzle_of(opened: OpenApplication, site: Site) -> Puzzle | None:
    """The puzzle by which an application is judged; None: none, or it is gone."""
    placed = placed_puzzle(opened.puzzle, site) if opened.puzzle else None
    return None if placed is None else placed.puzzle


def uncounted(opened: OpenApplication, plan: Plan, command: act.Run) -> Reason:
    """Why its run will not count; nothing: it may."""
    if not opened.puzzle:
        return NOTHING
    if flow_stations.apart(opened, plan):
        return Reason.of("run.puzzle_apart")
    if opened.redirects:
        return Reason.of("run.puzzle_redirected")
    if not command.puts_back:
        return Reason.of("run.puzzle_not_put_back")
    return NOTHING
