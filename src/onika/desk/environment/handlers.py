"""What each act does: one table."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from onika.desk.environment import (
    buffer,
    buttons,
    canvas,
    check,
    company,
    connecting,
    diary,
    documents,
    groups,
    holding,
    inplace,
    jobs,
    libraries,
    living,
    peeking,
    preferring,
    promise,
    retuning,
    scenery,
    taken,
    tasks,
    texts,
    undoing,
)
from onika.desk.environment.environment import Handler
from onika.desk.environment.model import Model
from onika.desk.environment.outcome import Done, No
from onika.desk.environment.surroundings import Surroundings
from onika.desk.upper.dictionary import dictionaries, revising, targets, teaching
from onika.desk.upper.flow import (
    branching,
    buffer as icon_buffer,
    editing,
    filing,
    inserting,
    looping,
    marking,
    moving,
    past,
)
from onika.desk.upper.flow.on_application import is_application
from onika.desk.upper.review import comparing, courses, glancing, listing as recordings, opening as reviewing, relinking
from onika.desk.upper.run import anew, beginning, continuing, keeping, preflight, redirecting, steering as steering_run
from onika.wire import act


def _by_kind(of_configuration: Handler, of_application: Handler) -> Handler:
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
    carry_out = filing.open_file if is_other else documents.open_file
    return carry_out(model, asked, outside)


HANDLERS: Mapping[type, Handler] = {
    act.New: documents.new,
    act.Open: relinking.relinked(_opening),
    act.Peek: peeking.peek,
    act.Save: _by_kind(documents.save, filing.save),
    act.Close: _by_kind(documents.close, filing.close),
    act.Reload: relinking.relinked(_by_kind(documents.reload, filing.reload)),
    act.Keep: _by_kind(documents.keep, filing.keep),
    act.Undo: _by_kind(undoing.undo, past.undo),
    act.Redo: _by_kind(undoing.redo, past.redo),
    act.Place: canvas.place,
    act.Exchange: canvas.exchange,
    act.Remove: canvas.remove,
    act.Move: canvas.move,
    act.Flip: canvas.flip,
    act.Align: canvas.align,
    act.Show: canvas.show,
    act.OpenLibrary: libraries.open_library,
    act.CloseLibrary: libraries.close_library,
    act.Alias: tasks.alias,
    act.LibraryRate: tasks.library_rate,
    act.Local: tasks.local,
    act.SaveTask: tasks.save_task,
    act.ForgetTask: tasks.forget_task,
    act.ReadText: texts.read_text,
    act.WriteText: texts.write_text,
    act.Copy: buffer.copy,
    act.Cut: buffer.cut,
    act.Paste: buffer.paste,
    act.Group: groups.group,
    act.Ungroup: groups.ungroup,
    act.SaveGroup: groups.save_group,
    act.Insert: groups.insert,
    act.TurnGroup: groups.turn_group,
    act.Check: check.check,
    act.Draft: jobs.draft,
    act.MakeJob: jobs.make_job,
    act.Prefer: preferring.prefer,
    act.Press: buttons.press,
    act.Halt: buttons.halt,
    act.SetButton: buttons.set_button,
    act.Note: diary.note,
    act.OpenInPlace: inplace.open_in_place,
    act.Rate: retuning.rate,
    act.Unit: retuning.unit,
    act.Connect: connecting.connect,
    act.Disconnect: connecting.disconnect,
    act.Turn: living.turn,
    act.Toggle: living.toggle,
    act.Clear: living.clear,
    act.Reinit: living.reinit,
    act.Renew: living.renew,
    act.Answer: steering_run.answer,
    act.Stop: holding.stop,
    act.Reset: holding.reset,
    act.Take: holding.take,
    act.Release: holding.release,
    act.Hand: holding.hand,
    act.Decline: holding.decline,
    act.OnlyWatch: promise.only_watch,
    act.WatchNoMore: promise.watch_no_more,
    act.Company: company.look_around,
    act.SteerTaken: taken.steer_taken,
    act.Scene: scenery.scene,
    act.Run: beginning.run,
    act.Steer: steering_run.steer_line,
    act.Preflight: preflight.preflight,
    act.Redirect: redirecting.redirect,
    act.Seats: redirecting.seats,
    act.SkipTo: steering_run.skip_to,
    act.Dismiss: steering_run.dismiss,
    act.StartAnew: anew.start_anew,
    act.NewApplication: filing.new,
    act.InsertIcon: inserting.insert_icon,
    act.InsertBranch: inserting.insert_branch,
    act.ExchangeIcon: inserting.exchange_icon,
    act.RemoveIcons: inserting.remove_icons,
    act.MoveIcons: moving.move_icons,
    act.CopyIcons: icon_buffer.copy_icons,
    act.CutIcons: icon_buffer.cut_icons,
    act.PasteIcons: icon_buffer.paste_icons,
    act.EditIcon: editing.edit_icon,
    act.SetBreakpoint: marking.set_breakpoint,
    act.SetSynchTag: marking.set_synch_tag,
    act.SetLoop: looping.set_loop,
    act.RemoveLoop: looping.remove_loop,
    act.SetConditions: branching.set_conditions,
    act.AddFlow: branching.add_flow,
    act.RemoveFlow: branching.remove_flow,
    act.SetParallel: branching.set_parallel,
    act.OpenDictionary: dictionaries.open_dictionary,
    act.CloseDictionary: dictionaries.close_dictionary,
    act.MakeTarget: targets.make_target,
    act.Teach: teaching.teach,
    act.EditOnikon: revising.edit_onikon,
    act.RemoveOnikon: revising.remove_onikon,
    act.Continue: continuing.continue_run,
    act.KeepTest: keeping.keep_test,
    act.OpenRecording: reviewing.open_recording,
    act.CloseRecording: reviewing.close_recording,
    act.Recordings: recordings.recordings,
    act.CompareWith: comparing.compare_with,
    act.Glance: glancing.glance,
    act.RecordedScene: glancing.recorded_scene,
    act.Course: courses.course,
}
