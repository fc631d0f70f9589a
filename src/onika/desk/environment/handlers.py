"""What each act does: one table."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from onika.desk.environment import buttons, diary, preferences
from onika.desk.environment.canvas import (
    check,
    clipboard,
    connection,
    groups,
    in_place,
    libraries,
    library_tasks,
    placement,
    retuning,
    source_texts,
    task_commands,
)
from onika.desk.environment.control import control_authority, held_subsystems, view_only
from onika.desk.environment.environment import Handler
from onika.desk.environment.file import application_undo, applications, configurations, undo
from onika.desk.environment.icons import (
    branches,
    clipboard as icon_buffer,
    dictionaries,
    icon_edit,
    insertion,
    jobs,
    loops,
    marks,
    moves,
    revision,
    targets,
    teaching,
)
from onika.desk.environment.outcome.on_application import is_application
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.reconcile import presence
from onika.desk.environment.review import (
    comparison,
    continuation,
    downsampled,
    opening as reviewing,
    recordings,
    relink,
    snapshot,
)
from onika.desk.environment.runs import begin, kept_test, preflight, redirection, restart, steering as steering_run
from onika.desk.environment.show import preview, scene
from onika.desk.environment.state.model import Model
from onika.wire import act

_AtOnce = Callable[[Model, Any, Surroundings], Done | No]


def _by_kind(of_configuration: _AtOnce, of_application: _AtOnce) -> _AtOnce:
    """What an act does that both kinds of documents know: the id says which it is."""

    def handler(model: Model, asked: Any, outside: Surroundings) -> Done | No:
        carry_out = of_application if is_application(asked.doc) else of_configuration
        return carry_out(model, asked, outside)

    return handler


def _opening(model: Model, asked: act.Open, outside: Surroundings) -> Done | No:
    """The ending says what is opened; of a name alone a configuration, else an application."""
    ending, bases = Path(asked.path).suffix, outside.site.directories
    is_other = ending == ".appl"
    if ending not in (".appl", ".conf") and not any(asked.path in base.configurations for base in bases):
        is_other = any(asked.path in base.applications for base in bases)
    carry_out = applications.open_file if is_other else configurations.open_file
    return carry_out(model, asked, outside)


HANDLERS: Mapping[type, Handler] = {
    act.New: configurations.new,
    act.Open: relink.relinked(_opening),
    act.Peek: preview.peek,
    act.Save: _by_kind(configurations.save, applications.save),
    act.Close: _by_kind(configurations.close, applications.close),
    act.Reload: relink.relinked(_by_kind(configurations.reload, applications.reload)),
    act.Keep: _by_kind(configurations.keep, applications.keep),
    act.Undo: _by_kind(undo.undo, application_undo.undo),
    act.Redo: _by_kind(undo.redo, application_undo.redo),
    act.Place: placement.place,
    act.Exchange: placement.exchange,
    act.Remove: placement.remove,
    act.Move: placement.move,
    act.Flip: placement.flip,
    act.Align: placement.align,
    act.Show: placement.show,
    act.OpenLibrary: libraries.open_library,
    act.CloseLibrary: libraries.close_library,
    act.Alias: library_tasks.alias,
    act.LibraryRate: library_tasks.library_rate,
    act.Local: library_tasks.local,
    act.SaveTask: library_tasks.save_task,
    act.ForgetTask: library_tasks.forget_task,
    act.ReadText: source_texts.read_text,
    act.WriteText: source_texts.write_text,
    act.Copy: clipboard.copy,
    act.Cut: clipboard.cut,
    act.Paste: clipboard.paste,
    act.Group: groups.group,
    act.Ungroup: groups.ungroup,
    act.SaveGroup: groups.save_group,
    act.Insert: groups.insert,
    act.TurnGroup: groups.turn_group,
    act.Check: check.check,
    act.Draft: jobs.draft,
    act.MakeJob: jobs.make_job,
    act.Prefer: preferences.prefer,
    act.Press: buttons.press,
    act.Halt: buttons.halt,
    act.SetButton: buttons.set_button,
    act.Note: diary.note,
    act.OpenInPlace: in_place.open_in_place,
    act.Rate: retuning.rate,
    act.Unit: retuning.unit,
    act.Connect: connection.connect,
    act.Disconnect: connection.disconnect,
    act.Turn: task_commands.turn,
    act.Toggle: task_commands.toggle,
    act.Clear: task_commands.clear,
    act.Reinit: task_commands.reinit,
    act.Renew: task_commands.renew,
    act.Answer: steering_run.answer,
    act.Stop: control_authority.stop,
    act.Reset: control_authority.reset,
    act.Take: control_authority.take,
    act.Release: control_authority.release,
    act.Hand: control_authority.hand,
    act.Decline: control_authority.decline,
    act.OnlyWatch: view_only.only_watch,
    act.WatchNoMore: view_only.watch_no_more,
    act.Company: presence.look_around,
    act.SteerTaken: held_subsystems.steer_taken,
    act.Scene: scene.scene,
    act.Run: begin.run,
    act.Steer: steering_run.steer_line,
    act.Preflight: preflight.preflight,
    act.Redirect: redirection.redirect,
    act.Seats: redirection.seats,
    act.SkipTo: steering_run.skip_to,
    act.Dismiss: steering_run.dismiss,
    act.StartAnew: restart.start_anew,
    act.NewApplication: applications.new,
    act.InsertIcon: insertion.insert_icon,
    act.InsertBranch: insertion.insert_branch,
    act.ExchangeIcon: insertion.exchange_icon,
    act.RemoveIcons: insertion.remove_icons,
    act.MoveIcons: moves.move_icons,
    act.CopyIcons: icon_buffer.copy_icons,
    act.CutIcons: icon_buffer.cut_icons,
    act.PasteIcons: icon_buffer.paste_icons,
    act.EditIcon: icon_edit.edit_icon,
    act.SetBreakpoint: marks.set_breakpoint,
    act.SetSynchTag: marks.set_synch_tag,
    act.SetLoop: loops.set_loop,
    act.RemoveLoop: loops.remove_loop,
    act.SetConditions: branches.set_conditions,
    act.AddFlow: branches.add_flow,
    act.RemoveFlow: branches.remove_flow,
    act.SetParallel: branches.set_parallel,
    act.OpenDictionary: dictionaries.open_dictionary,
    act.CloseDictionary: dictionaries.close_dictionary,
    act.MakeTarget: targets.make_target,
    act.Teach: teaching.teach,
    act.EditOnikon: revision.edit_onikon,
    act.RemoveOnikon: revision.remove_onikon,
    act.Continue: continuation.continue_run,
    act.KeepTest: kept_test.keep_test,
    act.OpenRecording: reviewing.open_recording,
    act.CloseRecording: reviewing.close_recording,
    act.Recordings: recordings.recordings,
    act.CompareWith: comparison.compare_with,
    act.Glance: snapshot.glance,
    act.RecordedScene: snapshot.recorded_scene,
    act.Course: downsampled.course,
}
