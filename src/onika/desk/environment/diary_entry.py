"""An act as a line of the diary: the seven columns of the thesis's event log (requirement H01, §6.2.2.4, §E.2).

Time, event, object, the object's id, the associated object, its id, the window. An id tells one thing from another of
that name: `c2` is a document, `c2/pd` a task in it. Nothing is `none` and its id `0`; windows are called as in §A.5.
What was refused begins with `try_`. Behind an act stands what was given with it, `enter_values`; of a step that was
taken back or done again its label is the associated object. The end of a run stands where it happens, `end_appl`.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from onika.desk.environment import application_entry, diary_values
from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.state.open_file import DocumentKind
from onika.wire import act
from onika.words.reason import Reason

_EVENTS: dict[type, tuple[str, str]] = {
    act.New: ("new_conf", "conf"),
    act.Open: ("open_conf", "conf"),
    act.OpenInPlace: ("replace_conf", "conf"),
    act.Close: ("close_conf", "conf"),
    act.Save: ("save_conf", "conf"),
    act.Reload: ("reload_conf", "conf"),
    act.Keep: ("keep_conf", "conf"),
    act.Undo: ("undo", "conf"),
    act.Redo: ("redo", "conf"),
    act.Place: ("insert_icon", "conf"),
    act.Exchange: ("exchange_icon", "conf"),
    act.Remove: ("delete_icon", "conf"),
    act.Move: ("move_icon", "conf"),
    act.Flip: ("flip_icon", "conf"),
    act.Align: ("align_icon", "conf"),
    act.Arrange: ("arrange_conf", "conf"),
    act.Show: ("show_locus", "conf"),
    act.Copy: ("copy_icon", "conf"),
    act.Cut: ("cut_icon", "conf"),
    act.Paste: ("paste_icon", "conf"),
    act.Group: ("group_icon", "conf"),
    act.Ungroup: ("ungroup_icon", "conf"),
    act.SaveGroup: ("save_group", "conf"),
    act.Insert: ("insert_conf", "conf"),
    act.TurnGroup: ("turn_group", "conf"),
    act.Rate: ("set_rate", "conf"),
    act.Unit: ("set_rtpu", "conf"),
    act.Check: ("check_conf", "conf"),
    act.NewApplication: ("new_appl", "appl"),
    act.ListPuzzles: ("list_puzzles", "main"),
    act.BeginPuzzle: ("begin_puzzle", "appl"),
    act.InsertIcon: ("insert_icon", "appl"),
    act.InsertBranch: ("insert_branch", "appl"),
    act.SetConditions: ("set_conditions", "appl"),
    act.ExchangeIcon: ("exchange_icon", "appl"),
    act.RemoveIcons: ("delete_icon", "appl"),
    act.MoveIcons: ("move_icon", "appl"),
    act.CopyIcons: ("copy_icon", "appl"),
    act.CutIcons: ("cut_icon", "appl"),
    act.PasteIcons: ("paste_icon", "appl"),
    act.EditIcon: ("edit_icon", "appl"),
    act.SetBreakpoint: ("set_marker", "appl"),
    act.SetSynchTag: ("set_synchtag", "appl"),
    act.SetLoop: ("set_whiletag", "appl"),
    act.RepeatSteps: ("set_whiletag", "appl"),
    act.RemoveLoop: ("remove_whiletag", "appl"),
    act.AddFlow: ("add_flow", "appl"),
    act.RemoveFlow: ("delete_flow", "appl"),
    act.SetParallel: ("set_parallel", "appl"),
    act.OpenDictionary: ("open_dict", "dict"),
    act.CloseDictionary: ("close_dict", "dict"),
    act.MakeTarget: ("new_target", "dict"),
    act.EditOnikon: ("edit_icon", "dict"),
    act.RemoveOnikon: ("delete_icon", "dict"),
    act.ArrangeIcon: ("move_icon", "dict"),
    act.ArrangeTask: ("move_task", "lexi"),
    act.Teach: ("teach_target", "dict"),
    act.PointAt: ("point_at_target", "dict"),
    act.FitTargets: ("fit_target", "conf"),
    act.OpenLibrary: ("open_lexi", "lexi"),
    act.CloseLibrary: ("close_lexi", "lexi"),
    act.Alias: ("set_alias", "lexi"),
    act.LibraryRate: ("set_rate", "lexi"),
    act.Local: ("set_local", "lexi"),
    act.KeepSet: ("keep_set", "conf"),
    act.SwitchSet: ("switch_set", "conf"),
    act.RemoveSet: ("delete_set", "conf"),
    act.SaveTask: ("save_task", "lexi"),
    act.ForgetTask: ("forget_task", "lexi"),
    act.ReadText: ("view_text", "lexi"),
    act.WriteText: ("save_text", "lexi"),
    act.NewModule: ("new_module", "lexi"),
    act.CompareWithShipped: ("compare_with_shipped", "main"),
    act.GoBackToShipped: ("go_back_to_shipped", "main"),
    act.ListReplaced: ("list_replaced", "main"),
    act.BringBack: ("bring_back", "main"),
    act.ListRemoteLibraries: ("list_remote_libraries", "main"),
    act.BrowseLibrary: ("browse_library", "main"),
    act.TakeLibrary: ("take_library", "main"),
    act.DropLibrary: ("drop_library", "main"),
    act.GiveLibraryRights: ("give_library_rights", "main"),
    act.ListOwnChanges: ("list_own_changes", "main"),
    act.SendBack: ("send_back", "main"),
    act.AddPlace: ("add_place", "main"),
    act.DropPlace: ("drop_place", "main"),
    act.TrustSite: ("trust_site", "main"),
    act.Connect: ("connect", "conf"),
    act.AddStation: ("add_station", "main"),
    act.RemoveStation: ("remove_station", "main"),
    act.PlaceFlow: ("place_flow", "appl"),
    act.Disconnect: ("disconnect", "conf"),
    act.KeepAlive: ("keep_conf", "conf"),
    act.SwitchTo: ("switch_conf", "conf"),
    act.LetGo: ("release_conf", "conf"),
    act.Turn: ("turn_task", "conf"),
    act.Toggle: ("toggle_task", "conf"),
    act.Clear: ("clear_task", "conf"),
    act.Reinit: ("reinit_task", "conf"),
    act.Renew: ("renew_task", "conf"),
    act.Answer: ("answer_task", "conf"),
    act.AskModule: ("get_value", "conf"),
    act.TellModule: ("set_value", "conf"),
    act.WriteVariable: ("write_variable", "conf"),
    act.CheckMemory: ("check_memory", "conf"),
    act.LogReadings: ("log_readings", "conf"),
    act.Stop: ("stop", "main"),
    act.Reset: ("reset", "main"),
    act.AddUnit: ("add_unit", "main"),
    act.RecordByHand: ("record_conf", "conf"),
    act.FindRoom: ("find_room", "conf"),
    act.Take: ("take", "conf"),
    act.Release: ("release", "conf"),
    act.Hand: ("hand_over", "conf"),
    act.Decline: ("decline", "conf"),
    act.OnlyWatch: ("only_watch", "main"),
    act.WatchNoMore: ("watch_no_more", "main"),
    act.BookRobot: ("book", "main"),
    act.ProlongBooking: ("prolong_booking", "main"),
    act.TakeBackBooking: ("take_back_booking", "main"),
    act.Draft: ("try_job", "dict"),
    act.MakeJob: ("new_job", "dict"),
    act.Prefer: ("set_preference", "main"),
    act.Press: ("press_button", "button"),
    act.Halt: ("halt_button", "button"),
    act.SetButton: ("set_button", "button"),
    act.Run: ("run_appl", "appl"),
    act.Steer: ("steer_appl", "appl"),
    act.Redirect: ("redirect_task", "appl"),
    act.SteerTaken: ("steer_taken", "main"),
    act.Preflight: ("check_reach", "appl"),
    act.SkipTo: ("skip_to_icon", "appl"),
    act.Dismiss: ("dismiss_run", "appl"),
    act.StartAnew: ("start_runtime_anew", "main"),
    act.PutBack: ("put_back", "main"),
    act.Touch: ("touch_part", "main"),
    act.OpenRecording: ("open_recording", "main"),
    act.CloseRecording: ("close_recording", "main"),
    act.CompareWith: ("compare_recording", "main"),
    act.Continue: ("continue_run", "main"),
    act.ShareRecording: ("share_recording", "main"),
    act.KeepTest: ("keep_test", "appl"),
    act.WhatIf: ("ask_what_if", "main"),
}
"""Not here: what a page asks for by itself, which no user does."""

_BOTH = (act.Open, act.Close, act.Save, act.Reload, act.Keep, act.Undo, act.Redo, act.Check, act.MakeJob, act.Draft)
"""Acts on either kind of document: of an application they are called so, and stand in its window."""

_THINGS = (
    "onikon", "tasks", "task", "new", "svars", "variable", "name", "library",
    "path", "url", "place", "values", "loci", "line", "part",
)  # fmt: skip
"""The fields of acts that name what is acted upon; the first that says something counts."""


_PARTING = re.compile(r"[\x00-\x1f\x7f\x85\u2028\u2029]+")
"""What ends a line or a column."""


@dataclass(frozen=True, slots=True)
class DiaryEntry:
    """What a line says, but for its time."""

    event: str
    object: str = ""
    id: str = ""
    associated: str = ""
    associated_id: str = ""
    window: str = ""

    def columns(self, at_s: float) -> tuple[str, ...]:
        """The seven columns; `at_s` is seconds since 1970."""
        things = (_word(self.object, "none"), _word(self.id, "0"))
        associated = (_word(self.associated, "none"), _word(self.associated_id, "0"))
        return (f"{at_s:.3f}", _word(self.event, "none"), *things, *associated, _word(self.window, "root"))


def is_of_user(command: act.AnyAct) -> bool:
    """Whether an act has a line: not what a page asks for by itself."""
    return isinstance(command, act.Note) or type(command) in _EVENTS


def entries(command: act.AnyAct, answer: ActAnswer, names: Mapping[str, str]) -> tuple[DiaryEntry, ...]:
    """What is written of an act: nothing of one that no user does. `names` are those of documents by their ids."""
    if isinstance(command, act.Note):
        return (
            DiaryEntry(
                command.event, command.object, command.id, command.associated, command.associated_id, command.window
            ),
        )
    if not is_of_user(command):
        return ()
    event, window = _event_of(command, answer)
    name = event if answer.no is None or event.startswith("try_") else f"try_{event}"
    things = _things(command, answer, names)
    line = DiaryEntry(name, *things, window)
    values = diary_values.given(command, things, (*_THINGS, "old", "dictionary"))
    if not values:
        return (line,)
    written = diary_values.written(values)
    return line, DiaryEntry("enter_values", _listed(values), written, line.object, line.id, window)


def end_of(run: Run) -> DiaryEntry:
    """What is written of a run that has come to its end: how, and the number of the run."""
    why = "completed" if run.view.is_completed else run.view.cause.text
    return DiaryEntry("end_appl", run.view.name, run.doc, why, str(run.view.number), "appl")


def _event_of(command: act.AnyAct, answer: ActAnswer) -> tuple[str, str]:
    """What an act is called, and the window in which it is done."""
    event, window = _EVENTS[type(command)]
    if isinstance(command, _BOTH) and _is_of_application(command, answer):
        return event.replace("conf", "appl").replace("job", "appl_icon"), window.replace("conf", "appl")
    match command:
        case act.Turn():
            return "turn_on_task" if command.is_on else "turn_off_task", window
        case act.TurnGroup():
            return "turn_on_group" if command.is_on else "turn_off_group", window
        case act.Touch():
            return "press_part" if command.is_pressed else "let_go_part", window
        case act.Show():
            return "show_locus" if command.is_shown else "hide_locus", window
    return event, window


def _things(command: act.AnyAct, answer: ActAnswer, names: Mapping[str, str]) -> tuple[str, str, str, str]:
    """Object, its id, associated object, its id."""
    if of_application := application_entry.things(command, answer.value, names):
        return of_application
    doc: str = getattr(command, "doc", "")
    document = (names.get(doc, ""), doc)
    match command:
        case act.New() | act.Open():
            opened = str(answer.value or "")
            return names.get(opened, getattr(command, "path", "")), opened, "", ""
        case act.Exchange():
            return command.new, f"{doc}/{command.new}", command.old, f"{doc}/{command.old}"
        case act.Undo() | act.Redo() if isinstance(answer.value, Reason):
            return *document, answer.value.text, answer.value.key
        case act.Touch():
            return command.part, f"{command.world}/{command.part}", command.world, command.world
        case act.Alias():
            return command.task, command.task, f"{command.pin}={command.svar}", command.pin
        case act.Paste() | act.Insert() if isinstance(answer.value, tuple):
            return _listed(answer.value), _ids(doc, answer.value), *document
        case act.Group():
            return _listed(command.tasks), _ids(doc, command.tasks), command.name, f"{doc}/{command.name}"
    things = _named(command)
    if not things:
        return *document, "", ""
    return _listed(things), _ids(doc, things), *document


def _is_of_application(command: act.AnyAct, answer: ActAnswer) -> bool:
    """Whether an act that both kinds of documents know was about an application."""
    if isinstance(command, act.Open):
        return DocumentKind.of(str(answer.value or "")) is DocumentKind.APPLICATION or command.path.endswith(".appl")
    return DocumentKind.of(getattr(command, "doc", "")) is DocumentKind.APPLICATION


def _named(command: act.AnyAct) -> tuple[str, ...]:
    """What an act names beside its document."""
    names: list[str] = []
    for name in _THINGS:
        value = getattr(command, name, ())
        several = [value] if isinstance(value, str) else value or ()
        names += [name for name in several if name and isinstance(name, str)]  # the values of a target name nothing
        if names and not isinstance(command, act.Move):
            break
    return tuple(names)


def _listed(names: Iterable[str]) -> str:
    return ",".join(names)


def _ids(doc: str, names: Iterable[str]) -> str:
    return ",".join(f"{doc}/{name}" if doc else name for name in names)


def _word(text: str, nothing: str) -> str:
    """A column: one line without the sign that parts columns."""
    return _PARTING.sub(" ", text).strip() or nothing
