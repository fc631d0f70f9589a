"""Every act that a page can send, by every role: the hub carries out what the role may, and nothing else (F10).

The rows are written down once more here, by name: whoever adds an act has to say whose it is.
"""

from typing import get_args

import msgspec
import pytest
from msgspec import inspect

from kit.wire.message_fuzz import MessageFuzz
from onika.link.caller import Role
from onika.web.access.act_rights import LEAST
from onika.web.access.entrance import Visitor
from onika.web.hub import Hub
from onika.wire import act, page

WATCHER = """Stop Watch Scene Meshes SampleVariables Company LookAtBookings Glance RecordedScene Course"""
OPERATOR = """Open OpenInPlace Peek Close Check ListSets Note Connect AddStation PlaceFlow RemoveStation Disconnect
KeepAlive SwitchTo LetGo Turn Toggle TurnGroup Clear Reinit FindRoom AskModule TellModule WriteVariable
CheckMemory LogReadings Answer Push Reset AddUnit RecordByHand Take Release Hand Decline OnlyWatch
WatchNoMore SteerTaken BookRobot ProlongBooking TakeBackBooking
Run Redirect Seats FindWorlds Steer SkipTo Dismiss PutBack Touch Preflight
ForeseenInstant WhatIf Teach PointAt FitTargets OpenRecording CloseRecording Recordings CompareWith
ShareRecording SteerReplay"""
PROGRAMMER = """New Save Reload Keep Undo Redo Place Exchange Remove Move Flip Align Arrange Show Copy Cut Paste Group
Ungroup SaveGroup Insert Rate Unit OpenLibrary CloseLibrary Alias LibraryRate Local KeepSet SwitchSet
RemoveSet SaveTask ForgetTask ReadText WriteText NewModule ArrangeTask ArrangeIcon LoadModule
CompareWithShipped GoBackToShipped ListReplaced BringBack ListRemoteLibraries ListOwnChanges BrowseLibrary LookAtNetwork
Renew Draft
MakeJob Prefer Press Halt NewApplication InsertIcon InsertBranch SetConditions ExchangeIcon RemoveIcons
MoveIcons CopyIcons CutIcons PasteIcons EditIcon SetBreakpoint SetSynchTag SetLoop RepeatSteps
RemoveLoop AddFlow RemoveFlow SetParallel OpenDictionary CloseDictionary MakeTarget EditOnikon
RemoveOnikon Continue KeepTest ListPuzzles BeginPuzzle"""
OWNER = """StartAnew SetButton TakeLibrary DropLibrary GiveLibraryRights SendBack AddPlace DropPlace TrustSite"""
ROWS = dict(zip(Role, (WATCHER, OPERATOR, PROGRAMMER, OWNER), strict=True))
KINDS = get_args(act.AnyAct)


class Done:
    """An environment that only notes what reaches it."""

    def __init__(self):
        self.listeners, self.done = [], []
        self.revision, self.tree = 0, page.Tree()

    def do(self, command, by, answer):
        self.done.append(type(command))

    def become(self, change):
        pass


class Nothing:
    def watch(self, *_):
        pass


def test_every_act_has_its_row():  # R-F10
    assert {kind.__name__: LEAST[kind] for kind in KINDS} == {
        name: role for role, names in ROWS.items() for name in names.split()
    }


def bodies(kind):
    """Acts of a kind, with and without what may be left out, as a page would send them."""
    fuzz = MessageFuzz((kind,), msgspec.json.encode, 1, {})
    made = []
    while len(made) < 20:
        body = b'{"cid":1,"act":' + fuzz.body(()) + b"}"
        try:
            page.decode(body)
        except ValueError:
            continue
        made.append(body)
    return made


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_an_act_reaches_the_environment_from_nobody_below_its_row(kind):  # R-F10
    environment = Done()
    hub = Hub(environment, Nothing())
    clients = {role: hub.come(Visitor(role.word, role, role.word)) for role in Role}
    is_taken = set()
    for body in bodies(kind):
        for role, client in clients.items():
            environment.done.clear()
            client.outbox = Kept()
            hub.take(client, body)
            is_refused = any(message["t"] == "Refused" for message in client.outbox.messages)
            assert is_refused is (role < LEAST[kind]) or (role < Role.PROGRAMMER and is_refused)
            assert not (is_refused and environment.done)
            assert role >= LEAST[kind] or is_refused
            is_taken |= set() if is_refused else {role}
    assert Role.OWNER in is_taken
    assert inspect.type_info(kind).tag == kind.__name__


class Kept:
    """An outbox that only keeps."""

    def __init__(self):
        self.messages = []

    def put(self, message):
        self.messages.append(msgspec.json.decode(message))

    def patch(self, message):
        pass
