"""What a page shows, as plain values: the tree that every browser holds a copy of; the desk alone makes it.

Maps are keyed and have no order of their own: where order counts, a value says its place. Absent is "nothing".
"""

from onika.wire.view.application import (
    AppFlowView as AppFlowView,
    ApplicationFile as ApplicationFile,
    ApplicationView as ApplicationView,
    FaultView as FaultView,
    ForecastView as ForecastView,
    RedirectView as RedirectView,
    StepView as StepView,
)
from onika.wire.view.asking import AskItem as AskItem, AskView as AskView, ErrorView as ErrorView
from onika.wire.view.booking import (
    BookingView as BookingView,
    BookView as BookView,
    SlotEndView as SlotEndView,
)
from onika.wire.view.class_seat import ClassSeatView as ClassSeatView, SeatState as SeatState
from onika.wire.view.dictionary import (
    DictionaryView as DictionaryView,
    ItemView as ItemView,
    OnikonView as OnikonView,
    Role as Role,
    TargetFitsView as TargetFitsView,
    TargetFitView as TargetFitView,
    TaughtView as TaughtView,
    TypeView as TypeView,
)
from onika.wire.view.document import (
    DocumentView as DocumentView,
    GroupView as GroupView,
    KeptView as KeptView,
    LocusView as LocusView,
    PlacedView as PlacedView,
    ProblemView as ProblemView,
    State as State,
)
from onika.wire.view.foresight import (
    EffectView as EffectView,
    ForeseenInstantView as ForeseenInstantView,
    ForesightsView as ForesightsView,
    ForesightView as ForesightView,
)
from onika.wire.view.library import (
    LibraryView as LibraryView,
    ParameterView as ParameterView,
    PinView as PinView,
    TaskView as TaskView,
)
from onika.wire.view.network import (
    NetworkPlaceView as NetworkPlaceView,
    NetworkRuntimeView as NetworkRuntimeView,
    NetworkSiteView as NetworkSiteView,
    NetworkView as NetworkView,
)
from onika.wire.view.puzzle import (
    BestView as BestView,
    GoalView as GoalView,
    GoalWordsView as GoalWordsView,
    PuzzleResultView as PuzzleResultView,
    PuzzlesView as PuzzlesView,
    PuzzleView as PuzzleView,
)
from onika.wire.view.remote_library import (
    HeldFileView as HeldFileView,
    OfferEntryView as OfferEntryView,
    OfferView as OfferView,
    OwnChangeView as OwnChangeView,
    SentBackView as SentBackView,
    UsedLibraryView as UsedLibraryView,
)
from onika.wire.view.replay import ReplayView as ReplayView
from onika.wire.view.reply import (
    CandidateView as CandidateView,
    DraftView as DraftView,
    LoadedView as LoadedView,
    ParameterSetsView as ParameterSetsView,
    ParameterSetView as ParameterSetView,
    PeekIcon as PeekIcon,
    PeekView as PeekView,
    ReplacedView as ReplacedView,
    SampledView as SampledView,
    SeatsView as SeatsView,
    SeatView as SeatView,
    TextView as TextView,
    TwoTextsView as TwoTextsView,
    WorldSeatView as WorldSeatView,
)
from onika.wire.view.review import (
    DifferenceView as DifferenceView,
    InstantView as InstantView,
    KeepingView as KeepingView,
    MarkView as MarkView,
    PassageView as PassageView,
    RecordedFlowView as RecordedFlowView,
    RecordedVariableView as RecordedVariableView,
    RecordingFile as RecordingFile,
    RecordingsView as RecordingsView,
    RecordingView as RecordingView,
    ReviewView as ReviewView,
    SharedFileView as SharedFileView,
    StretchView as StretchView,
)
from onika.wire.view.run import (
    CourseView as CourseView,
    FlowRunView as FlowRunView,
    JumpView as JumpView,
    MeetView as MeetView,
    RunView as RunView,
    StepRunView as StepRunView,
    StopView as StopView,
)
from onika.wire.view.runtime import (
    HoldView as HoldView,
    RuntimeView as RuntimeView,
    SessionView as SessionView,
    UnitView as UnitView,
)
from onika.wire.view.show import (
    AnyShow as AnyShow,
    Destination as Destination,
    ShowAnswer as ShowAnswer,
    ShowConfiguration as ShowConfiguration,
    ShowConnect as ShowConnect,
    ShowFits as ShowFits,
    ShowLibraries as ShowLibraries,
    ShowLibraryTask as ShowLibraryTask,
    ShowLocus as ShowLocus,
    ShowLoop as ShowLoop,
    ShowOnikon as ShowOnikon,
    ShowPin as ShowPin,
    ShowRecording as ShowRecording,
    ShowSaveAs as ShowSaveAs,
    ShowSource as ShowSource,
    ShowStep as ShowStep,
    ShowTarget as ShowTarget,
    ShowTask as ShowTask,
    ShowValues as ShowValues,
)
from onika.wire.view.subsystem import (
    LivingTaskView as LivingTaskView,
    SharedVariableView as SharedVariableView,
    SubsystemView as SubsystemView,
)
from onika.wire.view.tree import ButtonView as ButtonView, ConfigurationFile as ConfigurationFile, Tree as Tree
from onika.wire.view.view import ChoiceView as ChoiceView, Objection as Objection, Remedy as Remedy, View as View
