"""What a user does in the environment, as the page or anybody else sends it; the desk answers each exactly once.

`doc` is the id of an open document, `tasks` are names of tasks on its canvas, coordinates are pixels of the canvas.
An act that would touch hardware or lose something is refused first, with the same act `confirmed` as its remedy.
"""

from typing import Any, Literal

from msgspec import Struct

Names = tuple[str, ...]
Point = tuple[int, int]


class Act(Struct, frozen=True, forbid_unknown_fields=True, tag_field="t", tag=True, omit_defaults=True):
    """One thing that a user does."""


# -- documents


class New(Act, frozen=True):
    """Open a blank configuration."""


class Open(Act, frozen=True):
    """Open a configuration, by its file or by its name on the search path, beside the others (decision 15)."""

    path: str


class OpenInPlace(Act, frozen=True):
    """Open a configuration in place of one, which reconfigures what lives there (C15); told before it happens."""

    doc: str
    path: str
    confirmed: bool = False


class Close(Act, frozen=True):
    """Close a document; one that is not saved is refused unless `discards`, one whose tasks are ON is asked about.

    alive   what becomes of tasks that live: they end with it where none is ON; else `end` or `leave` says it
    """

    doc: str
    discards: bool = False
    alive: Literal["ask", "end", "leave"] = "ask"


class Save(Act, frozen=True):
    """Save a document where it was opened, or under a name (in a base directory, else its own)."""

    doc: str
    name: str = ""
    base: str = ""
    overwrites: bool = False


class Reload(Act, frozen=True):
    """Take over what stands in the file now; what was changed here can be had back by Undo."""

    doc: str


class Keep(Act, frozen=True):
    """Go on with what is here although the file has changed; the next Save overwrites it."""

    doc: str


class Undo(Act, frozen=True):
    """Take the last step of a document back, in the running system too (law 22)."""

    doc: str
    confirmed: bool = False


class Redo(Act, frozen=True):
    """Do the step again that was taken back last."""

    doc: str
    confirmed: bool = False


# -- the canvas


class Place(Act, frozen=True):
    """Place a task; where the document is connected, it is spawned, OFF."""

    doc: str
    task: str
    x: int
    y: int
    rtpu: str = ""
    in_left: bool = True


class Exchange(Act, frozen=True):
    """Place a task where another stands, in its stead."""

    doc: str
    old: str
    new: str


class Remove(Act, frozen=True):
    """Remove tasks, and kill them where they live."""

    doc: str
    tasks: Names


class Move(Act, frozen=True):
    """Move tasks and loci to these corners, as one step."""

    doc: str
    tasks: dict[str, Point] = {}
    loci: dict[str, Point] = {}


class Flip(Act, frozen=True):
    """Turn the direction of data flow in the icons of tasks."""

    doc: str
    tasks: Names


class Align(Act, frozen=True):
    """Bring tasks onto one line, or to equal distances."""

    doc: str
    tasks: Names
    edge: Literal["left", "right", "top", "bottom", "columns", "rows"]


class Show(Act, frozen=True):
    """Show or hide the connections of variables."""

    doc: str
    svars: Names
    is_shown: bool


class Copy(Act, frozen=True):
    """Take tasks into the buffer; replied with their text, which may travel by mail."""

    doc: str
    tasks: Names


class Cut(Act, frozen=True):
    """Take tasks into the buffer and remove them."""

    doc: str
    tasks: Names


class Paste(Act, frozen=True):
    """Place what is in the buffer, or in a text that was copied elsewhere, with its upper left corner here."""

    doc: str
    x: int
    y: int
    text: str = ""


class Group(Act, frozen=True):
    """Handle tasks as one from now on, under a name: a supermodule; in this order they come (C17)."""

    doc: str
    name: str
    tasks: Names


class Ungroup(Act, frozen=True):
    """Expand a supermodule into its parts."""

    doc: str
    name: str


class SaveGroup(Act, frozen=True):
    """Save a supermodule as a configuration of its own, which Insert recalls; where no base is named, in its own."""

    doc: str
    name: str
    base: str = ""
    overwrites: bool = False


class Insert(Act, frozen=True):
    """Place all tasks of a configuration as a supermodule of its name, with its upper left corner here; all or none."""

    doc: str
    path: str
    x: int
    y: int


class TurnGroup(Act, frozen=True):
    """Turn a supermodule ON in its order, or OFF the other way round."""

    doc: str
    name: str
    is_on: bool


class Rate(Act, frozen=True):
    """The rate of a task in this configuration in Hz; 0: as its file says."""

    doc: str
    task: str
    hz: float


class Unit(Act, frozen=True):
    """The processing unit that a task of this configuration lives on."""

    doc: str
    task: str
    rtpu: str


class Check(Act, frozen=True):
    """Check the configuration: all rules and warnings (C26); replied with the sentences."""

    doc: str


# -- libraries and tasks


class OpenLibrary(Act, frozen=True):
    """Add a base directory to the libraries that are open."""

    path: str


class CloseLibrary(Act, frozen=True):
    """Close a library; what is placed stays."""

    library: str


class Alias(Act, frozen=True):
    """Give the state variable behind a coded name; an empty one means the coded name (C04, C23)."""

    task: str
    pin: str
    svar: str
    doc: str = ""
    """Where it was done, whose Undo takes it back."""


class LibraryRate(Act, frozen=True):
    """A task's rate in Hz for later placements of this session (decision 10)."""

    task: str
    hz: float


class Local(Act, frozen=True):
    """The LOCAL lines of a task, each a key and its words."""

    task: str
    lines: tuple[tuple[str, Names], ...]
    doc: str = ""


class SaveTask(Act, frozen=True):
    """Write what was changed of a task to its `.rmod`."""

    task: str
    overwrites: bool = False


class ForgetTask(Act, frozen=True):
    """Take a task as its file says again."""

    task: str


class ReadText(Act, frozen=True):
    """Ask for the text of a task's `.rmod` or of its module's code; replied by `view.TextView`."""

    task: str
    kind: Literal["rmod", "code"]


class WriteText(Act, frozen=True):
    """Save such a text where the file is still what was read (`stamp`), and tell its faults."""

    task: str
    kind: Literal["rmod", "code"]
    text: str
    stamp: str
    overwrites: bool = False


# -- the running system


class Connect(Act, frozen=True):
    """Connect a configuration with a runtime: merge it with what runs there (C12, C18).

    url     empty: the runtime of this environment
    """

    doc: str
    url: str = ""
    token: str = ""
    subsystem: str = ""
    confirmed: bool = False


class Disconnect(Act, frozen=True):
    """Leave what runs as it is, and go on unconnected."""

    doc: str


class Turn(Act, frozen=True):
    """Turn tasks ON or OFF."""

    doc: str
    tasks: Names
    is_on: bool
    arguments: str = ""
    confirmed: bool = False


class Toggle(Act, frozen=True):
    """ON to OFF and back; a task in ERROR is cleared (C11)."""

    doc: str
    task: str


class Clear(Act, frozen=True):
    """Bring a task out of ERROR, and on again where that is wanted."""

    doc: str
    task: str
    turns_on: bool = False


class Reinit(Act, frozen=True):
    """Initialise a task anew, and all that need its constants."""

    doc: str
    task: str


class Renew(Act, frozen=True):
    """Exchange the code of a living task for what its file says now; on failure the old one stays (law 21)."""

    doc: str
    task: str


class Answer(Act, frozen=True):
    """Answer what a task asks, in the words of an argument line (C13)."""

    doc: str
    task: str
    line: str


class Stop(Act, frozen=True):
    """Stop everything: every drive holds (law 27). Always carried out first, never refused."""


class Reset(Act, frozen=True):
    """After a Stop: allow motion again."""


class Take(Act, frozen=True):
    """Become the holder of a document's subsystem."""

    doc: str


class Release(Act, frozen=True):
    """Let another become the holder."""

    doc: str


class Watch(Act, frozen=True):
    """What this browser wants to see from now on: variables as `DOC/NAME`, worlds by name, figures of tasks."""

    variables: Names = ()
    worlds: Names = ()
    figures: bool = False
    hz: float = 30.0


class Scene(Act, frozen=True):
    """Ask for what a world consists of; replied with it."""

    world: str


# -- jobs


class Draft(Act, frozen=True):
    """Ask what job a configuration would make; replied by `view.DraftView` (C16)."""

    doc: str


class MakeJob(Act, frozen=True):
    """Save the configuration and its onikon, with a picture of 1024 digits (C16, D07)."""

    doc: str
    picture: str
    description: str = ""
    overwrites: bool = False


# -- the user's own


class Prefer(Act, frozen=True):
    """Change preferences, by their names (§A.5); replied with those refused."""

    values: dict[str, Any]


class Press(Act, frozen=True):
    """Run the command of a user's button."""

    name: str


class Halt(Act, frozen=True):
    """End the command of a user's button."""

    name: str


class SetButton(Act, frozen=True):
    """Add a button or change it; an empty command removes it."""

    name: str
    command: str
    spawns_terminal: bool = False


class Note(Act, frozen=True):
    """What the page alone knows of: a selection, a view opened (H01); into the diary, no step."""

    event: str
    object: str = ""
    id: str = ""
    associated: str = ""
    associated_id: str = ""
    window: str = ""


AnyAct = (
    New
    | Open
    | OpenInPlace
    | Close
    | Save
    | Reload
    | Keep
    | Undo
    | Redo
    | Place
    | Exchange
    | Remove
    | Move
    | Flip
    | Align
    | Show
    | Copy
    | Cut
    | Paste
    | Group
    | Ungroup
    | SaveGroup
    | Insert
    | TurnGroup
    | Rate
    | Unit
    | Check
    | OpenLibrary
    | CloseLibrary
    | Alias
    | LibraryRate
    | Local
    | SaveTask
    | ForgetTask
    | ReadText
    | WriteText
    | Connect
    | Disconnect
    | Turn
    | Toggle
    | Clear
    | Reinit
    | Renew
    | Answer
    | Stop
    | Reset
    | Take
    | Release
    | Watch
    | Scene
    | Draft
    | MakeJob
    | Prefer
    | Press
    | Halt
    | SetButton
    | Note
)
