"""What a visitor may do, by his role: each act has the least role that may do it, and whoever has less is refused.

A watcher looks and stops. An operator runs what is there, and changes no file. A programmer edits: whatever he writes
is code that runs on this machine. The owner ends the runtime, and says whom the environment trusts and what its buttons
do.
An act that stands in no row is the owner's. (F10, law 23)
"""

from collections.abc import Callable, Mapping
from typing import Any

from onika.link.caller import Role
from onika.web.access.entrance import Visitor
from onika.wire import act
from onika.words.reason import NOTHING, Reason

WATCHING: frozenset[type] = frozenset(
    (
        act.Stop,
        act.Watch,
        act.Scene,
        act.Meshes,
        act.SampleVariables,
        act.Company,
        act.LookAtBookings,
        act.Glance,
        act.RecordedScene,
        act.Course,
    )
)
"""What changes nothing and asks for nothing but what is open, and Stop."""

_OPERATING: frozenset[type] = frozenset(
    (
        *(act.Open, act.OpenInPlace, act.Peek, act.Close, act.Check, act.ListSets, act.Note),
        *(act.Connect, act.AddStation, act.PlaceFlow, act.RemoveStation, act.Disconnect),
        *(act.KeepAlive, act.SwitchTo, act.LetGo, act.Turn, act.Toggle, act.TurnGroup, act.Clear, act.Reinit),
        *(act.FindRoom, act.AskModule, act.TellModule, act.WriteVariable, act.CheckMemory, act.LogReadings),
        *(act.Answer, act.Push, act.Reset, act.AddUnit, act.RecordByHand),
        *(act.Take, act.Release, act.Hand, act.Decline, act.OnlyWatch, act.WatchNoMore, act.SteerTaken),
        *(act.BookRobot, act.ProlongBooking, act.TakeBackBooking),
        *(act.Run, act.Redirect, act.Seats, act.FindWorlds, act.Steer, act.SkipTo, act.Dismiss),
        *(act.PutBack, act.Touch),
        *(act.Preflight, act.ForeseenInstant, act.WhatIf, act.Teach, act.PointAt, act.FitTargets),
        *(act.SteerReplay, act.OpenRecording, act.CloseRecording, act.Recordings, act.CompareWith, act.ShareRecording),
    )
)

_OWNING: frozenset[type] = frozenset(
    (
        act.StartAnew,
        act.SetButton,
        act.TakeLibrary,
        act.DropLibrary,
        act.GiveLibraryRights,
        act.SendBack,
        act.AddPlace,
        act.DropPlace,
        act.TrustSite,
    )
)

_PROGRAMMING: frozenset[type] = frozenset(
    (
        *(act.New, act.Save, act.Reload, act.Keep, act.Undo, act.Redo),
        *(act.Place, act.Exchange, act.Remove, act.Move, act.Flip, act.Align, act.Arrange, act.Show),
        *(act.Copy, act.Cut, act.Paste, act.Group, act.Ungroup, act.SaveGroup, act.Insert, act.Rate, act.Unit),
        *(act.OpenLibrary, act.CloseLibrary, act.Alias, act.LibraryRate, act.Local),
        *(act.KeepSet, act.SwitchSet, act.RemoveSet, act.SaveTask, act.ForgetTask),
        *(act.ReadText, act.WriteText, act.NewModule, act.ArrangeTask, act.ArrangeIcon, act.LoadModule),
        *(act.CompareWithShipped, act.GoBackToShipped, act.ListReplaced, act.BringBack),
        *(
            act.ListRemoteLibraries,
            act.ListOwnChanges,
            act.BrowseLibrary,
            act.LookAtNetwork,
            act.Renew,
            act.Draft,
            act.MakeJob,
        ),
        *(act.Prefer, act.Press, act.Halt),
        *(
            act.ListPuzzles,
            act.BeginPuzzle,
            act.NewApplication,
            act.InsertIcon,
            act.InsertBranch,
            act.SetConditions,
            act.ExchangeIcon,
        ),
        *(act.RemoveIcons, act.MoveIcons, act.CopyIcons, act.CutIcons, act.PasteIcons, act.EditIcon),
        *(act.SetBreakpoint, act.SetSynchTag, act.SetLoop, act.RepeatSteps, act.RemoveLoop),
        *(act.AddFlow, act.RemoveFlow, act.SetParallel, act.OpenDictionary, act.CloseDictionary),
        *(act.MakeTarget, act.EditOnikon, act.RemoveOnikon, act.Continue, act.KeepTest),
    )
)

_ROWS = (
    (WATCHING, Role.VIEWER),
    (_OPERATING, Role.OPERATOR),
    (_PROGRAMMING, Role.PROGRAMMER),
    (_OWNING, Role.OWNER),
)
LEAST: Mapping[type, Role] = {kind: role for kinds, role in _ROWS for kind in kinds}
"""The least role for each act."""

_MORE: Mapping[type, Callable[[Any], bool]] = {
    act.Connect: lambda command: bool(command.url or command.token),
    act.AddStation: lambda command: bool(command.url or command.token),
    act.Run: lambda command: command.saves_unsaved,
    act.Close: lambda command: command.discards,
    act.LetGo: lambda command: command.discards,
}
"""Acts that are a programmer's where this is so: they go to an address that somebody names, which may start a program
(`ssh://`), or they write or throw away what was edited."""


def least(command: act.AnyAct) -> Role:
    """The least role that may do it."""
    role = LEAST.get(type(command), Role.OWNER)
    needs_more = _MORE.get(type(command))
    if needs_more is not None and needs_more(command):
        return max(role, Role.PROGRAMMER)
    return role


def refusal(visitor: Visitor, command: act.AnyAct) -> Reason:
    """Why he may not do it; empty: he may."""
    wanted = least(command)
    if visitor.role >= wanted:
        return NOTHING
    if visitor.role is Role.VIEWER:
        return Reason.of("desk.only_watch_and_stop", user=visitor.user)
    return Reason.of("desk.act_of_role", user=visitor.user, role=visitor.role.word, least=wanted.word)
