"""What the figures of a task are called on the page, in the order of §E.3 (requirement H02)."""

from onika.words.reason import Reason

TITLES = {
    "request_s": "study.f_request",
    "elapsed_s": "study.f_elapsed",
    "building_s": "study.f_building",
    "selection_s": "study.f_selection",
    "selections": "study.f_selections",
    "mean_selection_s": "study.f_mean_selection",
    "selection_spread_s": "study.f_selection_spread",
    "all_selections": "study.f_all_selections",
    "unselected": "study.f_unselected",
    "unselected_s": "study.f_unselected_time",
    "insertions": "study.f_insertions",
    "insertion_s": "study.f_insertion",
    "mean_insertion_s": "study.f_mean_insertion",
    "deletions": "study.f_deletions",
    "undone": "study.f_undone",
    "refused": "study.f_refused",
    "check_s": "study.f_check",
    "attempts": "study.f_attempts",
    "not_run": "study.f_not_run",
    "aborted": "study.f_aborted",
    "completed": "study.f_completed",
    "completed_run_s": "study.f_completed_run",
    "mean_completed_run_s": "study.f_mean_completed_run",
    "run_s": "study.f_run",
    "other_s": "study.f_other",
    "pauses": "study.f_pauses",
    "pause_s": "study.f_pause",
    "longest_pause_s": "study.f_longest_pause",
    "is_first_try": "study.f_first_try",
}
SHORT = (
    "elapsed_s", "building_s", "mean_selection_s", "selection_spread_s", "selections", "mean_insertion_s", "insertions",
    "deletions", "check_s", "pauses", "attempts", "is_first_try",
)  # fmt: skip
"""Those of the table of all subjects."""


def title_of(figure: str) -> Reason:
    """What a figure is called, with its unit."""
    return Reason.of(TITLES[figure])
