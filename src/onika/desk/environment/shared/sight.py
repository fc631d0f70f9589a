"""What of the tree a shared file holds: the application of the run, and whatever its icons need to be drawn and told.

Nothing of the machine goes with it: no paths, no other files, no preferences.
"""

from collections.abc import Iterable
from pathlib import PurePath
from typing import TypeVar

from msgspec import structs

from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.wire.view import ApplicationView, RecordingView, ReviewView, TaskView, Tree
from onika.words.reason import NOTHING

_T = TypeVar("_T")
_ENDS = ("start", "end")


def sight(subject: ReviewedRun, tree: Tree) -> Tree:
    """The tree of an environment that looks at a recording, as whoever gets a file of it may see it."""
    doc = subject.view.doc if subject.view.doc in tree.applications else ""
    application = tree.applications.get(doc)
    shown = {doc: _bare(application)} if application is not None else {}
    steps = list(application.steps.values()) if application is not None else []
    plan = subject.review.run.prepare.plan
    modules = {code.module for code in plan.code}
    tasks = {task.name for flow in plan.flows for task in flow.tasks}
    pictures = {*_ENDS, *(step.picture for step in steps)}
    return Tree(
        tasks={name: _of_nowhere(view) for name, view in tree.tasks.items() if name in tasks},
        module_sentences={name: said for name, said in tree.module_sentences.items() if name in modules},
        edges=tree.edges,
        applications=shown,
        types=_named(tree.types, (step.type for step in steps)),
        pictures=_named(tree.pictures, pictures),
        job_types=tree.job_types,
        review=ReviewView(_bare_recording(subject.view, doc)),
    )


def _named(entries: dict[str, _T], names: Iterable[str]) -> dict[str, _T]:
    wanted = set(names)
    return {name: entry for name, entry in entries.items() if name in wanted}


def _of_nowhere(task: TaskView) -> TaskView:
    library = PurePath(task.library).name
    return structs.replace(task, library=library, path="", code="", is_changed=False)


def _bare(application: ApplicationView) -> ApplicationView:
    """What was drawn, without what is known of its file and of its next run."""
    return ApplicationView(
        application.name,
        application.order,
        is_parallel=application.is_parallel,
        flows=application.flows,
        steps=application.steps,
        holes=application.holes,
        is_judged=True,
    )


def _bare_recording(recording: RecordingView, doc: str) -> RecordingView:
    file = PurePath(recording.path).name
    return structs.replace(recording, path=file, doc=doc, cannot_continue=NOTHING)
