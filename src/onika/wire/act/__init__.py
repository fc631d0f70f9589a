"""What a user does in the environment, as the page or anybody else sends it; the desk answers each exactly once.

`doc` is the id of an open document, `tasks` are names of tasks on its canvas, coordinates are pixels of the canvas.
An act that would touch hardware or lose something is refused first, with the same act `confirmed` as its remedy.
"""

from onika.wire.act.act import Act as Act, Names as Names, Point as Point
from onika.wire.act.application import (
    AddFlow as AddFlow,
    CopyIcons as CopyIcons,
    CutIcons as CutIcons,
    EditIcon as EditIcon,
    ExchangeIcon as ExchangeIcon,
    InsertBranch as InsertBranch,
    InsertIcon as InsertIcon,
    MoveIcons as MoveIcons,
    NewApplication as NewApplication,
    PasteIcons as PasteIcons,
    RemoveFlow as RemoveFlow,
    RemoveIcons as RemoveIcons,
    RemoveLoop as RemoveLoop,
    RepeatSteps as RepeatSteps,
    SetBreakpoint as SetBreakpoint,
    SetConditions as SetConditions,
    SetLoop as SetLoop,
    SetParallel as SetParallel,
    SetSynchTag as SetSynchTag,
    Steps as Steps,
    Values as Values,
)
from onika.wire.act.booking import (
    BookRobot as BookRobot,
    LookAtBookings as LookAtBookings,
    ProlongBooking as ProlongBooking,
    TakeBackBooking as TakeBackBooking,
)
from onika.wire.act.canvas import (
    Align as Align,
    Arrange as Arrange,
    Check as Check,
    Copy as Copy,
    Cut as Cut,
    Exchange as Exchange,
    Flip as Flip,
    Group as Group,
    Insert as Insert,
    Move as Move,
    Paste as Paste,
    Place as Place,
    Rate as Rate,
    Remove as Remove,
    SaveGroup as SaveGroup,
    Show as Show,
    TurnGroup as TurnGroup,
    Ungroup as Ungroup,
    Unit as Unit,
)
from onika.wire.act.dictionary import (
    ArrangeIcon as ArrangeIcon,
    CloseDictionary as CloseDictionary,
    EditOnikon as EditOnikon,
    FitTargets as FitTargets,
    MakeTarget as MakeTarget,
    OpenDictionary as OpenDictionary,
    PointAt as PointAt,
    RemoveOnikon as RemoveOnikon,
    Teach as Teach,
)
from onika.wire.act.document import (
    Close as Close,
    Keep as Keep,
    New as New,
    Open as Open,
    OpenInPlace as OpenInPlace,
    Peek as Peek,
    Redo as Redo,
    Reload as Reload,
    Save as Save,
    Undo as Undo,
)
from onika.wire.act.holding import (
    Company as Company,
    Decline as Decline,
    Hand as Hand,
    OnlyWatch as OnlyWatch,
    Release as Release,
    SteerTaken as SteerTaken,
    Take as Take,
    WatchNoMore as WatchNoMore,
)
from onika.wire.act.job import Draft as Draft, MakeJob as MakeJob
from onika.wire.act.library import (
    Alias as Alias,
    ArrangeTask as ArrangeTask,
    CloseLibrary as CloseLibrary,
    ForgetTask as ForgetTask,
    LibraryRate as LibraryRate,
    LoadModule as LoadModule,
    Local as Local,
    NewModule as NewModule,
    OpenLibrary as OpenLibrary,
    ReadText as ReadText,
    SaveTask as SaveTask,
    WriteText as WriteText,
)
from onika.wire.act.network import (
    AddPlace as AddPlace,
    DropPlace as DropPlace,
    LookAtNetwork as LookAtNetwork,
    TrustSite as TrustSite,
)
from onika.wire.act.own import (
    Halt as Halt,
    Note as Note,
    Prefer as Prefer,
    Press as Press,
    SetButton as SetButton,
    SteerReplay as SteerReplay,
)
from onika.wire.act.own_copy import (
    BringBack as BringBack,
    CompareWithShipped as CompareWithShipped,
    GoBackToShipped as GoBackToShipped,
    ListReplaced as ListReplaced,
)
from onika.wire.act.parameter_set import (
    KeepSet as KeepSet,
    ListSets as ListSets,
    RemoveSet as RemoveSet,
    SwitchSet as SwitchSet,
)
from onika.wire.act.puzzle import BeginPuzzle as BeginPuzzle, ListPuzzles as ListPuzzles
from onika.wire.act.remote_library import (
    BrowseLibrary as BrowseLibrary,
    DropLibrary as DropLibrary,
    GiveLibraryRights as GiveLibraryRights,
    ListOwnChanges as ListOwnChanges,
    ListRemoteLibraries as ListRemoteLibraries,
    SendBack as SendBack,
    TakeLibrary as TakeLibrary,
)
from onika.wire.act.review import (
    CloseRecording as CloseRecording,
    CompareWith as CompareWith,
    Continue as Continue,
    Course as Course,
    Glance as Glance,
    KeepTest as KeepTest,
    OpenRecording as OpenRecording,
    RecordedScene as RecordedScene,
    Recordings as Recordings,
    ShareRecording as ShareRecording,
)
from onika.wire.act.run import (
    Dismiss as Dismiss,
    FindWorlds as FindWorlds,
    ForeseenInstant as ForeseenInstant,
    Preflight as Preflight,
    PutBack as PutBack,
    Redirect as Redirect,
    Run as Run,
    Seats as Seats,
    SkipTo as SkipTo,
    StartAnew as StartAnew,
    Steer as Steer,
    Touch as Touch,
    WhatIf as WhatIf,
)
from onika.wire.act.running import (
    AddUnit as AddUnit,
    Answer as Answer,
    AskModule as AskModule,
    CheckMemory as CheckMemory,
    Clear as Clear,
    Connect as Connect,
    Disconnect as Disconnect,
    FindRoom as FindRoom,
    KeepAlive as KeepAlive,
    LetGo as LetGo,
    LogReadings as LogReadings,
    Meshes as Meshes,
    Push as Push,
    RecordByHand as RecordByHand,
    Reinit as Reinit,
    Renew as Renew,
    Reset as Reset,
    SampleVariables as SampleVariables,
    Scene as Scene,
    Stop as Stop,
    SwitchTo as SwitchTo,
    TellModule as TellModule,
    Toggle as Toggle,
    Turn as Turn,
    Watch as Watch,
    WriteVariable as WriteVariable,
)
from onika.wire.act.station import (
    AddStation as AddStation,
    PlaceFlow as PlaceFlow,
    RemoveStation as RemoveStation,
)

AnyAct = (
    New
    | Open
    | OpenInPlace
    | Peek
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
    | Arrange
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
    | ListSets
    | KeepSet
    | SwitchSet
    | RemoveSet
    | SaveTask
    | ForgetTask
    | ReadText
    | WriteText
    | NewModule
    | ArrangeTask
    | ArrangeIcon
    | LoadModule
    | CompareWithShipped
    | GoBackToShipped
    | ListReplaced
    | ListPuzzles
    | BeginPuzzle
    | BringBack
    | ListRemoteLibraries
    | BrowseLibrary
    | TakeLibrary
    | DropLibrary
    | GiveLibraryRights
    | ListOwnChanges
    | SendBack
    | LookAtNetwork
    | AddPlace
    | DropPlace
    | TrustSite
    | Connect
    | AddStation
    | PlaceFlow
    | RemoveStation
    | Disconnect
    | KeepAlive
    | SwitchTo
    | LetGo
    | Turn
    | Toggle
    | Clear
    | Reinit
    | Renew
    | FindRoom
    | AskModule
    | TellModule
    | WriteVariable
    | CheckMemory
    | LogReadings
    | SampleVariables
    | Answer
    | Stop
    | Reset
    | AddUnit
    | RecordByHand
    | Take
    | Release
    | Hand
    | Decline
    | OnlyWatch
    | WatchNoMore
    | Company
    | LookAtBookings
    | BookRobot
    | ProlongBooking
    | TakeBackBooking
    | SteerTaken
    | Watch
    | Scene
    | Meshes
    | Draft
    | MakeJob
    | Prefer
    | Press
    | Halt
    | SetButton
    | Note
    | SteerReplay
    | NewApplication
    | InsertIcon
    | InsertBranch
    | SetConditions
    | ExchangeIcon
    | RemoveIcons
    | MoveIcons
    | CopyIcons
    | CutIcons
    | PasteIcons
    | EditIcon
    | SetBreakpoint
    | SetSynchTag
    | SetLoop
    | RepeatSteps
    | RemoveLoop
    | AddFlow
    | RemoveFlow
    | SetParallel
    | OpenDictionary
    | CloseDictionary
    | MakeTarget
    | EditOnikon
    | RemoveOnikon
    | Teach
    | Push
    | PointAt
    | FitTargets
    | Run
    | Redirect
    | Seats
    | FindWorlds
    | Steer
    | SkipTo
    | Dismiss
    | StartAnew
    | PutBack
    | Touch
    | Preflight
    | ForeseenInstant
    | WhatIf
    | OpenRecording
    | CloseRecording
    | Recordings
    | RecordedScene
    | Glance
    | Course
    | CompareWith
    | Continue
    | ShareRecording
    | KeepTest
)
