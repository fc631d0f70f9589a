// Drawn from src/onika/wire/{act,view,page,class_board}.py by tools/generate.py: change those.

import type { Reason } from './texts/say';

/** One more flow, of the application or of the branch that is this step. */
export interface AddFlow {
  t: 'AddFlow';
  doc: string;
  step?: number;
}

/** Take steps into the buffer; replied with their text, which may travel by mail. */
export interface CopyIcons {
  t: 'CopyIcons';
  doc: string;
  steps: (number)[];
}

/** Take steps into the buffer and delete them. */
export interface CutIcons {
  t: 'CutIcons';
  doc: string;
  steps: (number)[];
}

/** Change this one instance of an icon (D17); what is None stays as it is. `picture` is its digits. */
export interface EditIcon {
  t: 'EditIcon';
  doc: string;
  step: number;
  description?: string | null;
  values?: ((string)[])[] | null;
  picture?: string | null;
}

/** Put an icon of a dictionary where another stands, with its marks. */
export interface ExchangeIcon {
  t: 'ExchangeIcon';
  doc: string;
  step: number;
  onikon: string;
}

/** Insert a branch with so many empty flows behind a step; replied with its number (D13). */
export interface InsertBranch {
  t: 'InsertBranch';
  doc: string;
  flow?: string;
  after?: number;
  flows?: number;
  conditions?: (string)[];
}

/** Insert an icon of a dictionary behind a step, by Equation (7); replied with the step's number. */
export interface InsertIcon {
  t: 'InsertIcon';
  doc: string;
  onikon: string;
  flow?: string;
  after?: number;
  first?: string;
}

/** Take steps out and insert them behind another one, as one step. */
export interface MoveIcons {
  t: 'MoveIcons';
  doc: string;
  steps: (number)[];
  flow: string;
  after: number;
  replaces?: number;
}

/** Open a blank application of so many flows; with several, parallel or conditional. */
export interface NewApplication {
  t: 'NewApplication';
  flows?: number;
  is_parallel?: boolean;
}

/** Insert what is in the buffer, or in a text that was copied elsewhere, behind a step; replied with the numbers. */
export interface PasteIcons {
  t: 'PasteIcons';
  doc: string;
  flow?: string;
  after?: number;
  text?: string;
}

/** Take a flow away, with all that is in it; one stays. */
export interface RemoveFlow {
  t: 'RemoveFlow';
  doc: string;
  flow: string;
}

/** Delete steps; holes open or close by Equation (7). */
export interface RemoveIcons {
  t: 'RemoveIcons';
  doc: string;
  steps: (number)[];
}

/** Take the loop away that has a tag at this step. */
export interface RemoveLoop {
  t: 'RemoveLoop';
  doc: string;
  step: number;
}

/** Have steps of one flow done so many times: a job that counts comes behind them, and decides a loop over them. */
export interface RepeatSteps {
  t: 'RepeatSteps';
  doc: string;
  steps: (number)[];
  times: number;
  description?: string;
}

/** Pause after these actions, always or where a condition holds; in a run that goes on, too. */
export interface SetBreakpoint {
  t: 'SetBreakpoint';
  doc: string;
  steps: (number)[];
  is_set?: boolean;
  condition?: string;
}

/** Which flow of a branch runs: the first whose condition holds, else the last; without any, what was returned. */
export interface SetConditions {
  t: 'SetConditions';
  doc: string;
  step: number;
  conditions: (string)[];
}

/** Mark two actions of one flow as a loop: the test decides, and goes on at the anchor; replaces tags they had. */
export interface SetLoop {
  t: 'SetLoop';
  doc: string;
  test: number;
  anchor: number;
  tag?: string;
  condition?: string;
}

/** Whether the flows of an application run side by side, or one of them is chosen. */
export interface SetParallel {
  t: 'SetParallel';
  doc: string;
  is_parallel: boolean;
}

/** The tag at which an action waits for other flows; empty takes it away. */
export interface SetSynchTag {
  t: 'SetSynchTag';
  doc: string;
  step: number;
  tag?: string;
}

/** Book the robot for oneself. begin_s 0: from now on length_s rounded up to the next step at which a booking may end late what becomes of a run that is late: `stop`, or `finish` its actions and pause */
export interface BookRobot {
  t: 'BookRobot';
  length_s: number;
  begin_s?: number;
  late?: string;
  note?: string;
  station?: string;
}

/** Ask anew what is booked there; it is shown with the runtime. */
export interface LookAtBookings {
  t: 'LookAtBookings';
  station?: string;
}

/** Let a booking of one's own end at another time. */
export interface ProlongBooking {
  t: 'ProlongBooking';
  number: number;
  end_s: number;
  station?: string;
}

/** Give a time back; the owner may take back everybody's. */
export interface TakeBackBooking {
  t: 'TakeBackBooking';
  number: number;
  station?: string;
}

/** Bring tasks onto one line, or to equal distances. */
export interface Align {
  t: 'Align';
  doc: string;
  tasks: (string)[];
  edge: 'bottom' | 'columns' | 'left' | 'right' | 'rows' | 'top';
}

/** Lay out the tasks of a configuration, or these, in columns along the flow of data. */
export interface Arrange {
  t: 'Arrange';
  doc: string;
  tasks?: (string)[];
}

/** Check the configuration: all rules and warnings (C26); replied with the sentences. */
export interface Check {
  t: 'Check';
  doc: string;
}

/** Take tasks into the buffer; replied with their text, which may travel by mail. */
export interface Copy {
  t: 'Copy';
  doc: string;
  tasks: (string)[];
}

/** Take tasks into the buffer and remove them. */
export interface Cut {
  t: 'Cut';
  doc: string;
  tasks: (string)[];
}

/** Place a task where another stands, in its stead. */
export interface Exchange {
  t: 'Exchange';
  doc: string;
  old: string;
  new: string;
}

/** Turn the direction of data flow in the icons of tasks. */
export interface Flip {
  t: 'Flip';
  doc: string;
  tasks: (string)[];
}

/** Handle tasks as one from now on, under a name: a supermodule; in this order they come (C17). */
export interface Group {
  t: 'Group';
  doc: string;
  name: string;
  tasks: (string)[];
}

/** Place all tasks of a configuration as a supermodule of its name, with its upper left corner here; all or none. */
export interface Insert {
  t: 'Insert';
  doc: string;
  path: string;
  x: number;
  y: number;
}

/** Move tasks and loci to these corners, as one step. */
export interface Move {
  t: 'Move';
  doc: string;
  tasks?: Record<string, [number, number]>;
  loci?: Record<string, [number, number]>;
}

/** Place what is in the buffer, or in a text that was copied elsewhere, with its upper left corner here. */
export interface Paste {
  t: 'Paste';
  doc: string;
  x: number;
  y: number;
  text?: string;
}

/** Place a task; where the document is connected, it is spawned, OFF. */
export interface Place {
  t: 'Place';
  doc: string;
  task: string;
  x: number;
  y: number;
  rtpu?: string;
  in_left?: boolean;
}

/** The rate of a task in this configuration in Hz; 0: as its file says. */
export interface Rate {
  t: 'Rate';
  doc: string;
  task: string;
  hz: number;
}

/** Remove tasks, and kill them where they live. */
export interface Remove {
  t: 'Remove';
  doc: string;
  tasks: (string)[];
}

/** Save a supermodule as a configuration of its own, which Insert recalls; where no base is named, in its own. */
export interface SaveGroup {
  t: 'SaveGroup';
  doc: string;
  name: string;
  base?: string;
  overwrites?: boolean;
}

/** Show or hide the connections of variables. */
export interface Show {
  t: 'Show';
  doc: string;
  svars: (string)[];
  is_shown: boolean;
}

/** Turn a supermodule ON in its order, or OFF the other way round. */
export interface TurnGroup {
  t: 'TurnGroup';
  doc: string;
  name: string;
  is_on: boolean;
}

/** Expand a supermodule into its parts. */
export interface Ungroup {
  t: 'Ungroup';
  doc: string;
  name: string;
}

/** The processing unit that a task of this configuration lives on. */
export interface Unit {
  t: 'Unit';
  doc: string;
  task: string;
  rtpu: string;
}

/** Put an icon before another of its type in its dictionary (D24). */
export interface ArrangeIcon {
  t: 'ArrangeIcon';
  onikon: string;
  before?: string;
}

/** Close a dictionary; what is placed stays. */
export interface CloseDictionary {
  t: 'CloseDictionary';
  dictionary: string;
}

/** Change an icon of a dictionary; icons already placed stay as they are (D05). What is None stays. */
export interface EditOnikon {
  t: 'EditOnikon';
  onikon: string;
  description?: string | null;
  values?: ((string)[])[] | null;
  picture?: string | null;
  base?: string;
  overwrites?: boolean;
}

/** Ask which targets a state variable makes as it is now (C30); replied by `view.TargetFitsView`. */
export interface FitTargets {
  t: 'FitTargets';
  variable: string;
  doc?: string;
  subsystem?: string;
}

/** Write a new target, or an icon that does nothing, into a dictionary (D08); `picture` is its digits. */
export interface MakeTarget {
  t: 'MakeTarget';
  name: string;
  type: string;
  values: ((string)[])[];
  picture: string;
  description?: string;
  base?: string;
  overwrites?: boolean;
  arm?: string;
}

/** Add the dictionary of a base directory to those that are open. */
export interface OpenDictionary {
  t: 'OpenDictionary';
  path: string;
}

/** Ask for a place of a workcell as the values of a type of target (D25); replied by `view.TaughtView`. */
export interface PointAt {
  t: 'PointAt';
  type: string;
  world: string;
  position: [number, number, number];
  approach: [number, number, number];
  normal?: [number, number, number];
  doc?: string;
  flow?: string;
  after?: number;
  arm?: string;
}

/** Delete the file of an icon; what is placed stays. */
export interface RemoveOnikon {
  t: 'RemoveOnikon';
  onikon: string;
  confirmed?: boolean;
}

/** Ask for what the robot measures now, as the values of a type of target (D13); replied by `view.TaughtView`. */
export interface Teach {
  t: 'Teach';
  type: string;
  subsystem?: string;
  doc?: string;
  flow?: string;
  after?: number;
  arm?: string;
  or_another?: boolean;
}

/** Close a document; one that is not saved is refused unless `discards`, one whose tasks are ON is asked about. alive what becomes of tasks that live: they end with it where none is ON; else `end` or `leave` says it */
export interface Close {
  t: 'Close';
  doc: string;
  discards?: boolean;
  alive?: 'ask' | 'end' | 'leave';
}

/** Go on with what is here although the file has changed; the next Save overwrites it. */
export interface Keep {
  t: 'Keep';
  doc: string;
}

/** Open a blank configuration. */
export interface New {
  t: 'New';
}

/** Open a configuration, by its file or by its name on the search path, beside the others (reading 15). */
export interface Open {
  t: 'Open';
  path: string;
}

/** Open a configuration in place of one, which reconfigures what lives there (C15); told before it happens. */
export interface OpenInPlace {
  t: 'OpenInPlace';
  doc: string;
  path: string;
  confirmed?: boolean;
}

/** Ask what is in a configuration or an application, by its file, to draw it in small; `view.PeekView`. */
export interface Peek {
  t: 'Peek';
  path: string;
}

/** Do the step again that was taken back last; replied with its name. */
export interface Redo {
  t: 'Redo';
  doc: string;
  confirmed?: boolean;
}

/** Take over what stands in the file now; what was changed here can be had back by Undo. */
export interface Reload {
  t: 'Reload';
  doc: string;
}

/** Save a document where it was opened, or under a name (in a base directory, else its own). */
export interface Save {
  t: 'Save';
  doc: string;
  name?: string;
  base?: string;
  overwrites?: boolean;
}

/** Take the last step back, in the running system too (law 22): of a document, or of what belongs to none (X10). Without a document only the latter. What was done later goes first. Replied with the name of the step. */
export interface Undo {
  t: 'Undo';
  doc: string;
  confirmed?: boolean;
}

/** Ask the runtime anew who is there, who holds what, and where the flows of applications are. */
export interface Company {
  t: 'Company';
  station?: string;
}

/** Say no to what is offered; a yes is Take. */
export interface Decline {
  t: 'Decline';
  doc?: string;
  subsystem?: string;
  station?: string;
}

/** Offer a subsystem to another session, which takes it or not; to nobody: offer it no more. */
export interface Hand {
  t: 'Hand';
  doc?: string;
  to?: string;
  subsystem?: string;
  station?: string;
}

/** From now on this environment changes nothing in the runtime that it is connected with; stopping stays. */
export interface OnlyWatch {
  t: 'OnlyWatch';
  station?: string;
}

/** Let another become the holder. */
export interface Release {
  t: 'Release';
  doc?: string;
  subsystem?: string;
  station?: string;
}

/** Steer the run of an application that another began and that is held here now; what moves is asked back first. */
export interface SteerTaken {
  t: 'SteerTaken';
  subsystem: string;
  wish: 'abort' | 'clear' | 'pause' | 'resume';
  confirmed?: boolean;
  station?: string;
}

/** Become the holder of a subsystem: of one that nobody holds, or that is offered here. Of a run that is nobody's all flows are taken, which is asked back first: it was begun by somebody else. */
export interface Take {
  t: 'Take';
  doc?: string;
  subsystem?: string;
  station?: string;
  confirmed?: boolean;
}

/** Come anew, as somebody who may change something: the promise only to watch lasts as long as the session. */
export interface WatchNoMore {
  t: 'WatchNoMore';
  station?: string;
}

/** Ask what job a configuration would make; replied by `view.DraftView` (C16). */
export interface Draft {
  t: 'Draft';
  doc: string;
}

/** Save the configuration and its onikon, with a picture as digits (C16, D07). */
export interface MakeJob {
  t: 'MakeJob';
  doc: string;
  picture: string;
  description?: string;
  overwrites?: boolean;
}

/** Give the state variable behind a coded name; an empty one means the coded name (C04, C23). */
export interface Alias {
  t: 'Alias';
  task: string;
  pin: string;
  svar: string;
  doc?: string;
}

/** Put a task before another of its library (D24). */
export interface ArrangeTask {
  t: 'ArrangeTask';
  task: string;
  before?: string;
}

/** Close a library; what is placed stays. */
export interface CloseLibrary {
  t: 'CloseLibrary';
  library: string;
}

/** Take a task as its file says again. */
export interface ForgetTask {
  t: 'ForgetTask';
  task: string;
  doc?: string;
}

/** A task's rate in Hz for later placements of this session (reading 10). */
export interface LibraryRate {
  t: 'LibraryRate';
  task: string;
  hz: number;
}

/** Have the runtime load a task's module as its file is now; replied by `view.LoadedView`. */
export interface LoadModule {
  t: 'LoadModule';
  task: string;
}

/** The LOCAL lines of a task, each a key and its words. */
export interface Local {
  t: 'Local';
  task: string;
  lines: ([string, (string)[]])[];
  doc?: string;
}

/** Write a new module with its `.rmod` and its test from a template (C31); replied with the name of the task. */
export interface NewModule {
  t: 'NewModule';
  name: string;
  base?: string;
}

/** Add a base directory to the libraries that are open. */
export interface OpenLibrary {
  t: 'OpenLibrary';
  path: string;
}

/** Ask for the text of a task's `.rmod`, of its module's code or of its test; replied by `view.TextView`. */
export interface ReadText {
  t: 'ReadText';
  task: string;
  kind: 'code' | 'rmod' | 'test';
}

/** Write what was changed of a task to its `.rmod`. */
export interface SaveTask {
  t: 'SaveTask';
  task: string;
  overwrites?: boolean;
  doc?: string;
}

/** Save such a text where the file is still what was read (`stamp`), and tell its faults. */
export interface WriteText {
  t: 'WriteText';
  task: string;
  kind: 'code' | 'rmod' | 'test';
  text: string;
  stamp: string;
  overwrites?: boolean;
}

/** Look for cards there too: `https://…`, a folder, `tcp/HOST:PORT` of a router, or `lan`. */
export interface AddPlace {
  t: 'AddPlace';
  place: string;
}

/** Look there no more. */
export interface DropPlace {
  t: 'DropPlace';
  place: string;
}

/** Look at all places; the value is a `view.NetworkView`. Nothing that is found is connected with, or kept. */
export interface LookAtNetwork {
  t: 'LookAtNetwork';
}

/** Take a key for that of the site of a name from now on, whatever was before. */
export interface TrustSite {
  t: 'TrustSite';
  name: string;
  signer: string;
}

/** End the command of a user's button. */
export interface Halt {
  t: 'Halt';
  name: string;
}

/** What the page alone knows of: a selection, a view opened (H01); into the diary, no step. */
export interface Note {
  t: 'Note';
  event: string;
  object?: string;
  id?: string;
  associated?: string;
  associated_id?: string;
  window?: string;
}

/** Change preferences, by their names (§A.5); replied with those refused. */
export interface Prefer {
  t: 'Prefer';
  values: Record<string, unknown>;
}

/** Run the command of a user's button. */
export interface Press {
  t: 'Press';
  name: string;
}

/** Add a button or change it; an empty command removes it. */
export interface SetButton {
  t: 'SetButton';
  name: string;
  command: string;
  spawns_terminal?: boolean;
}

/** Play, pause or step the session that is replayed, or go to its end (H08); where none is, it is refused. */
export interface SteerReplay {
  t: 'SteerReplay';
  wish: 'end' | 'pause' | 'play' | 'step';
  speed?: number;
}

/** Put a replaced text where it was; what stands there now is kept in its place. The value is the path. */
export interface BringBack {
  t: 'BringBack';
  number: number;
}

/** Ask for a file of one's own and the shipped one before which it stands; `view.TwoTextsView`. */
export interface CompareWithShipped {
  t: 'CompareWithShipped';
  path: string;
}

/** Go back to the shipped file: the copy goes where `BringBack` finds it. The value is the shipped one's path. */
export interface GoBackToShipped {
  t: 'GoBackToShipped';
  path: string;
}

/** Ask for the texts that can be brought back, the newest first; a tuple of `view.ReplacedView`. */
export interface ListReplaced {
  t: 'ListReplaced';
}

/** Keep the parameters of the tasks of a configuration as they are now, under a name. */
export interface KeepSet {
  t: 'KeepSet';
  doc: string;
  name: string;
  overwrites?: boolean;
}

/** Ask for the parameter sets of a configuration, and for its parameters as they are now. */
export interface ListSets {
  t: 'ListSets';
  doc: string;
}

/** Keep a set no longer. */
export interface RemoveSet {
  t: 'RemoveSet';
  doc: string;
  name: string;
}

/** Take all values of a set over, or none: where one is refused nothing changes. */
export interface SwitchSet {
  t: 'SwitchSet';
  doc: string;
  name: string;
}

/** Open what a puzzle begins with as a new application, whose runs are judged by it; the value is its id. */
export interface BeginPuzzle {
  t: 'BeginPuzzle';
  puzzle: string;
  doc?: string;
}

/** Which puzzles there are, and how far one is; the value is a `view.PuzzlesView`. */
export interface ListPuzzles {
  t: 'ListPuzzles';
}

/** Look at a library at an address, whether it is used or not; the value is a `view.OfferView`. Nothing is kept. */
export interface BrowseLibrary {
  t: 'BrowseLibrary';
  address: string;
  user?: string;
  secret?: string;
}

/** Use a library of others no longer; what was placed of it stays. */
export interface DropLibrary {
  t: 'DropLibrary';
  library: string;
}

/** Let the code of a library do all that its user may, or compute and nothing else, from its next start on. */
export interface GiveLibraryRights {
  t: 'GiveLibraryRights';
  library: string;
  all_rights: boolean;
}

/** Ask what the user's own copies change in a library of others; a tuple of `view.OwnChangeView`. */
export interface ListOwnChanges {
  t: 'ListOwnChanges';
  library: string;
}

/** Ask which libraries of others are used; a tuple of `view.UsedLibraryView`. */
export interface ListRemoteLibraries {
  t: 'ListRemoteLibraries';
}

/** Send own changes back to the site of a library; the value is a `view.SentBackView`. Where others have changed the same meanwhile nothing is sent until the user has seen both. */
export interface SendBack {
  t: 'SendBack';
  library: string;
  paths: (string)[];
  note?: string;
  agreed?: string;
  is_mine?: boolean;
  user?: string;
  secret?: string;
}

/** Use what was looked at: its signer is trusted, and what its tasks write and touch is agreed to. Where it is used already the newer version takes its place. What is fetched is run by nobody. */
export interface TakeLibrary {
  t: 'TakeLibrary';
  address: string;
  digest: string;
}

/** Put the recording away; what runs now is shown again. */
export interface CloseRecording {
  t: 'CloseRecording';
}

/** Show another recorded run beside the one that is looked at, with their first difference; empty: no more. */
export interface CompareWith {
  t: 'CompareWith';
  path: string;
  tolerance?: number | null;
  part?: number | null;
  time_s?: number | null;
}

/** Go on from an instant of the recorded run in the simulator: the same run up to there, then as it is steered. */
export interface Continue {
  t: 'Continue';
  at_s: number;
  confirmed?: boolean;
}

/** A variable `SUBSYSTEM/NAME` over a stretch of the recorded run; the value is a tuple of `view.StretchView`. */
export interface Course {
  t: 'Course';
  variable: string;
  begin_s: number;
  end_s: number;
  points?: number;
  of_other?: boolean;
}

/** What the recorded run was like at an instant; the value is a `view.InstantView`. */
export interface Glance {
  t: 'Glance';
  at_s: number;
  of_other?: boolean;
}

/** Keep a run of an application as a test (X07): it is carried out in simulators aside, five times. */
export interface KeepTest {
  t: 'KeepTest';
  doc: string;
  path?: string;
  expects?: (string)[];
  confirmed?: boolean;
  saves_unsaved?: boolean;
}

/** Look at a recorded run (X05); another one that was looked at is put away. */
export interface OpenRecording {
  t: 'OpenRecording';
  path: string;
}

/** What a world of the recorded run consisted of; replied with it as `Scene` is. */
export interface RecordedScene {
  t: 'RecordedScene';
  world: string;
  at_s?: number;
  of_other?: boolean;
}

/** Which recordings there are; the value is a `view.RecordingsView`. */
export interface Recordings {
  t: 'Recordings';
}

/** Make a file of the recorded run that is looked at, which plays by itself (X21); gives a `view.SharedFileView`. */
export interface ShareRecording {
  t: 'ShareRecording';
}

/** Put away what is shown of a run that is over. */
export interface Dismiss {
  t: 'Dismiss';
  doc?: string;
}

/** Ask the runtime which worlds it has, and which of them are simulated; it is started where there is none (E09). */
export interface FindWorlds {
  t: 'FindWorlds';
  station?: string;
}

/** How a workcell stands when something happens that is foreseen; the value is a `view.ForeseenInstantView`. */
export interface ForeseenInstant {
  t: 'ForeseenInstant';
  doc: string;
  number: number;
}

/** Look at everything that could keep an application from running, the modules' reach too; nothing moves (X02). The faults are then those of the application, each at its step; replied with how many there are. */
export interface Preflight {
  t: 'Preflight';
  doc: string;
}

/** Everything in the open workcells to where it stood at the start, in the same runtime (law 18). Of a workcell that nobody here can move it is told what a person has to put where. */
export interface PutBack {
  t: 'PutBack';
  station?: string;
}

/** Let another task or world stand for one while this application is open; its file stays as it is (E09). A world is named with its colon, as in `boxes:`. */
export interface Redirect {
  t: 'Redirect';
  doc: string;
  flow: string;
  old: string;
  new: string;
}

/** Run an application as it is here, on the runtime of this environment, beside others that need other devices. Refused with all its faults at once. What must end first, and what has changed and is not saved, is told before. */
export interface Run {
  t: 'Run';
  doc: string;
  confirmed?: boolean;
  ignores_unsaved?: boolean;
  passes_breakpoints?: boolean;
  saves_unsaved?: boolean;
  is_recorded?: boolean;
  on_loss?: 'finish' | 'run' | 'stop';
  units?: ([string, string])[];
  puts_back?: boolean;
  ends_former?: boolean;
  goes_on?: boolean;
}

/** Which tasks the flows of an application use, and who could stand for each; the value is a `view.SeatsView`. */
export interface Seats {
  t: 'Seats';
  doc: string;
}

/** Send the flow of a step to it at once; nothing between is carried out (E13). */
export interface SkipTo {
  t: 'SkipTo';
  step: number;
  doc?: string;
}

/** End the runtime of this environment with all that lives there, and start it again: the workcell as it was. */
export interface StartAnew {
  t: 'StartAnew';
  confirmed?: boolean;
}

/** A line of steering, in the words of `desk.run.steering`: `pause 0`, `skip 1 3`, `abort`. */
export interface Steer {
  t: 'Steer';
  line: string;
  doc?: string;
}

/** A hand presses a part of a simulated workcell, such as a panic button, or lets it go. */
export interface Touch {
  t: 'Touch';
  world: string;
  part: string;
  is_pressed: boolean;
}

/** What would follow from a fault; nothing is touched (X24). Replied with a `view.ForesightsView`. */
export interface WhatIf {
  t: 'WhatIf';
  fault?: string;
  subject?: string;
  doc?: string;
  on_loss?: 'finish' | 'run' | 'stop';
}

/** Have one more processing unit in the runtime, or a lost one anew; what was on it stays gone. */
export interface AddUnit {
  t: 'AddUnit';
  name: string;
  station?: string;
}

/** Answer what a task asks, in the words of an argument line (C13). */
export interface Answer {
  t: 'Answer';
  doc: string;
  task: string;
  line: string;
  station?: string;
}

/** Ask a module for something by name, as its code offers it (A05); replied with the value as text. */
export interface AskModule {
  t: 'AskModule';
  doc: string;
  task: string;
  name: string;
}

/** Check the memory of a running subsystem's variables (A12); replied with what is unsound, as sentences. */
export interface CheckMemory {
  t: 'CheckMemory';
  doc: string;
}

/** Bring a task out of ERROR, and on again where that is wanted. */
export interface Clear {
  t: 'Clear';
  doc: string;
  task: string;
  turns_on?: boolean;
}

/** Connect a configuration with the runtime of a station: merge it with what runs there (C12, C18, F02). url of a runtime that has no station yet, and gets one; empty: that of `station` station empty: the first one; None: the one to which the configuration is assigned */
export interface Connect {
  t: 'Connect';
  doc: string;
  url?: string;
  token?: string;
  subsystem?: string;
  station?: string | null;
}

/** Leave what runs as it is, and go on unconnected. */
export interface Disconnect {
  t: 'Disconnect';
  doc: string;
}

/** Do once more what found no gap between the cycles of a unit last, and was taken back (law 21). */
export interface FindRoom {
  t: 'FindRoom';
  doc: string;
  unit?: string;
}

/** Bring the tasks of one more configuration to life, OFF, beside those of a connected one (C32). */
export interface KeepAlive {
  t: 'KeepAlive';
  doc: string;
  path: string;
}

/** Keep a configuration alive no more: tasks that no other one has are ended. */
export interface LetGo {
  t: 'LetGo';
  doc: string;
  name: string;
  discards?: boolean;
}

/** Ask for the present readings of a running subsystem as lines of a log (A12); replied with its text. */
export interface LogReadings {
  t: 'LogReadings';
  doc: string;
}

/** Have meshes of a world made that a scene names; replied, when that is done, with the names of those there are. */
export interface Meshes {
  t: 'Meshes';
  world: string;
  meshes?: (string)[];
}

/** Lead a tool by a pad, as it is pushed now; believed for a moment only, so it is sent anew all the time (K07). */
export interface Push {
  t: 'Push';
  axes: [number, number, number, number, number, number];
  is_held: boolean;
  button?: boolean;
  scale?: number;
  frame?: 'base' | 'tool' | 'world';
  subsystem?: string;
  source?: string;
}

/** Record a configuration that lives into a file from now on, or end that; the value is the file (X05). */
export interface RecordByHand {
  t: 'RecordByHand';
  doc: string;
  is_on?: boolean;
}

/** Initialise a task anew, and all that need its constants. */
export interface Reinit {
  t: 'Reinit';
  doc: string;
  task: string;
}

/** Exchange the code of a living task for what its file says now; on failure the old one stays (law 21). */
export interface Renew {
  t: 'Renew';
  doc: string;
  task: string;
  holds?: boolean;
}

/** After a Stop: allow motion again, at one station or wherever all is stopped. */
export interface Reset {
  t: 'Reset';
  station?: string;
  is_everywhere?: boolean;
}

/** Ask for values of variables at every cycle, as a scope shows them (C14); the value is a tuple of `view.SampledView`. */
export interface SampleVariables {
  t: 'SampleVariables';
  variables: (string)[];
  after?: (number)[];
}

/** Ask for what a world consists of; replied with it. */
export interface Scene {
  t: 'Scene';
  world: string;
}

/** Stop everything at every station: every drive holds (law 27). Always carried out first, never refused. */
export interface Stop {
  t: 'Stop';
}

/** Have the tasks of a configuration that is kept alive ON, and all others OFF, as one change. */
export interface SwitchTo {
  t: 'SwitchTo';
  doc: string;
  name: string;
}

/** Tell a module a new value of something by name (A05); replied with the value it has then, where it says so. */
export interface TellModule {
  t: 'TellModule';
  doc: string;
  task: string;
  name: string;
  value: string;
}

/** ON to OFF and back; a task in ERROR is cleared (C11). */
export interface Toggle {
  t: 'Toggle';
  doc: string;
  task: string;
}

/** Turn tasks ON or OFF. */
export interface Turn {
  t: 'Turn';
  doc: string;
  tasks: (string)[];
  is_on: boolean;
  arguments?: string;
  confirmed?: boolean;
}

/** What this browser wants to see from now on: variables as `DOC/NAME`, worlds by name, figures of tasks. A camera stands among the worlds, as `WORLD:CAMERA`. What is of another station than the first one names it: `@SUBSYSTEM@STATION/NAME`, `STATION/WORLD`, `STATION/WORLD:CAMERA`. Of a run, variables are `DOC/SUBSYSTEM/NAME`, or `DOC/NAME` for the first flow that has it. */
export interface Watch {
  t: 'Watch';
  variables?: (string)[];
  worlds?: (string)[];
  figures?: boolean;
  hz?: number;
}

/** Write a variable of a running subsystem that no task writes, in SI units, row by row. */
export interface WriteVariable {
  t: 'WriteVariable';
  doc: string;
  variable: string;
  values: (number)[];
}

/** Connect the environment with one more runtime, or with that of a station once more; the value is its name (F02). keeps whether the station stays where its runtime cannot be reached, to be tried again */
export interface AddStation {
  t: 'AddStation';
  url?: string;
  token?: string;
  name?: string;
  keeps?: boolean;
}

/** Have a flow of an application carried out at a station while it is open; its file stays as it is (E12, F02). */
export interface PlaceFlow {
  t: 'PlaceFlow';
  doc: string;
  flow: string;
  station?: string;
}

/** Leave the runtime of a station; what runs there goes on as its holder's loss would have it. */
export interface RemoveStation {
  t: 'RemoveStation';
  name: string;
  confirmed?: boolean;
}

/** A flow: the numbers of its steps in order, without start and end. */
export interface AppFlowView {
  steps?: (number)[];
  end?: string;
  start?: string;
}

/** An application that could be opened. */
export interface ApplicationFile {
  name: string;
  base: string;
  path: string;
  flows?: number;
  icons?: number;
}

/** An open application. */
export interface ApplicationView {
  name: string;
  order: number;
  path?: string;
  base?: string;
  is_dirty?: boolean;
  has_changed_on_disk?: boolean;
  undo?: Reason;
  redo?: Reason;
  is_parallel?: boolean;
  flows?: Record<string, AppFlowView>;
  steps?: Record<string, StepView>;
  holes?: number;
  faults?: Record<string, FaultView>;
  is_judged?: boolean;
  is_checked?: boolean;
  is_running?: boolean;
  redirects?: (RedirectView)[];
  forecast?: ForecastView;
  worlds?: Record<string, (string)[]>;
  guests?: Record<string, string>;
  stations?: Record<string, string>;
  puzzle?: string;
}

/** Something that keeps an application from running, or is worth knowing; `step` is where, 0: nowhere in it. */
export interface FaultView {
  text: Reason;
  level?: 'fault' | 'warning';
  step?: number;
  remedies?: (Remedy)[];
  is_of_runtime?: boolean;
  follows?: (Reason)[];
  instant?: number;
}

/** What an application would come to, in a workcell as at its start (E16). */
export interface ForecastView {
  state?: 'going' | 'none' | 'part' | 'whole';
  lasts_s?: number;
  cause?: Reason;
  mishaps?: number;
  standing?: (Reason)[];
  worlds?: (string)[];
  unwatched?: (string)[];
}

/** A task that stands for another one in a flow, by its subsystem, or in all of them; or a world, with its colon. */
export interface RedirectView {
  old: string;
  new: string;
  flow?: string;
  homes?: (string)[];
}

/** An icon, hole or branch in a flow, with its marks. */
export interface StepView {
  kind?: 'branch' | 'hole' | 'icon';
  left?: string;
  right?: string;
  name?: string;
  type?: string;
  role?: '' | 'application' | 'end' | 'job' | 'nop' | 'start' | 'target';
  picture?: string;
  description?: string;
  words?: Record<string, string>;
  values?: ((string)[])[];
  is_joined?: boolean;
  wants?: (string)[];
  breaks?: boolean;
  break_if?: string;
  synch_tag?: string;
  loop?: string;
  is_test?: boolean;
  loop_if?: string;
  conditions?: (string)[];
  flows?: (string)[];
  note?: Reason;
}

/** One value or vector that a task asks for. */
export interface AskItem {
  name: string;
  type: string;
  count: number;
  unit: string;
  meaning: string;
  default?: (unknown)[] | null;
  low?: (number)[] | null;
  high?: (number)[] | null;
}

/** What a task waits to be told before it comes on. */
export interface AskView {
  items: (AskItem)[];
  reason?: Reason;
  present?: Record<string, (number)[]>;
}

/** Why a task is in ERROR, and the ways out. */
export interface ErrorView {
  text: Reason;
  entry?: string;
  path?: string;
  line?: number;
  traceback?: string;
  at_s?: number;
  values?: Record<string, unknown>;
  remedies?: (Remedy)[];
}

/** A robot belongs to a user from a begin up to, not including, an end. */
export interface BookingView {
  number: number;
  user: string;
  begin_s: number;
  end_s: number;
  late?: string;
  note?: string;
}

/** What is booked of a robot, earliest first; whose clock counts is that of the robot's own site. */
export interface BookView {
  robot: string;
  you: string;
  now_s: number;
  asked_s: number;
  is_needed?: boolean;
  bookings?: (BookingView)[];
}

/** A user's time ends, and another one follows. */
export interface SlotEndView {
  user: string;
  follower: string;
  at_s: number;
}

/** A seat, and whose it is. */
export interface ClassSeatView {
  number: number;
  learner: string;
  state?: 'frozen' | 'taken' | 'works';
  note?: string;
  note_number?: number;
  handed_in?: number;
  grade?: [number, number] | null;
  began_anew?: Reason;
}

/** An open dictionary. */
export interface DictionaryView {
  name: string;
  path: string;
  order: number;
  onikons: number;
  faults?: (Reason)[];
  arranged?: (string)[];
  is_shipped?: boolean;
}

/** A datum of a target; unit and bounds are those of the task that takes it, where one is known. */
export interface ItemView {
  name: string;
  type: string;
  count: number;
  unit?: string;
  meaning?: string;
  low?: (number)[] | null;
  high?: (number)[] | null;
  default?: (unknown)[] | null;
  dimension?: string;
  each?: number;
  place?: '' | 'joints' | 'pose';
}

/** An icon of a dictionary. */
export interface OnikonView {
  type: string;
  role: '' | 'application' | 'end' | 'job' | 'nop' | 'start' | 'target';
  order: number;
  dictionary: string;
  left: string;
  right: string;
  picture: string;
  description?: string;
  words?: Record<string, string>;
  values?: ((string)[])[];
  takes?: (string)[];
  path?: string;
  source?: string;
  trouble?: Reason;
  hardware?: (string)[];
  arm?: string;
}

/** The targets that a state variable makes as it is now. */
export interface TargetFitsView {
  variable: string;
  shape: string;
  source: Reason;
  fits: (TargetFitView)[];
}

/** A datum of a type of target that a state variable gives, with its values as words. */
export interface TargetFitView {
  type: string;
  item: string;
  values: (string)[];
}

/** What is measured now, as the values of a target. */
export interface TaughtView {
  values: Record<string, (number)[]>;
  source?: Reason;
  subsystem?: string;
  others?: (string)[];
  type?: string;
  arm?: string;
  device?: string;
  arms?: (string)[];
  made_for?: string;
  joints?: (number)[];
}

/** A type of icon of the syntax definition. */
export interface TypeView {
  order: number;
  role: '' | 'application' | 'end' | 'job' | 'nop' | 'start' | 'target';
  left: string;
  right: string;
  items?: (ItemView)[];
  takes?: string;
}

/** An open configuration. */
export interface DocumentView {
  name: string;
  order: number;
  path?: string;
  base?: string;
  is_dirty?: boolean;
  is_moved?: boolean;
  has_changed_on_disk?: boolean;
  undo?: Reason;
  redo?: Reason;
  tasks?: Record<string, PlacedView>;
  loci?: Record<string, LocusView>;
  groups?: Record<string, GroupView>;
  kept?: Record<string, KeptView>;
  own?: Record<string, TaskView>;
  greyed?: Record<string, (Objection)[]>;
  objections?: Record<string, (Objection)[]>;
  problems?: Record<string, ProblemView>;
  connection?: 'connecting' | 'live' | 'lost' | 'none';
  subsystem?: string;
  station?: string;
  application?: string;
  has_ended?: boolean;
  black_box?: string;
  recording?: string;
  taken_by?: string;
  holder?: string;
  is_held_here?: boolean;
  offered_by?: string;
  offered_to?: string;
  is_offered_here?: boolean;
}

/** A supermodule: tasks that are handled as one, in their order of spawning and turning ON. */
export interface GroupView {
  tasks: (string)[];
}

/** A configuration that is kept alive beside the one that is shown (C32). */
export interface KeptView {
  order: number;
  tasks?: Record<string, '' | 'ASKING' | 'ERROR' | 'KILLING' | 'OFF' | 'ON' | 'SPAWNING' | 'WAITING'>;
  path?: string;
  is_dirty?: boolean;
}

/** Where the lines of a variable meet. */
export interface LocusView {
  x: number;
  y: number;
  is_shown?: boolean;
  line?: 'idle' | 'live' | 'stale';
  is_constant?: boolean;
  writers?: (string)[];
  readers?: (string)[];
}

/** A task on a canvas. */
export interface PlacedView {
  x: number;
  y: number;
  in_left?: boolean;
  hz?: number;
  rtpu?: string;
  state?: '' | 'ASKING' | 'ERROR' | 'KILLING' | 'OFF' | 'ON' | 'SPAWNING' | 'WAITING';
  note?: Reason;
  is_missing?: boolean;
  ask?: AskView | null;
  error?: ErrorView | null;
  warnings?: number;
}

/** Something wrong with a document, or worth knowing; `show` is where it is. */
export interface ProblemView {
  text: Reason;
  level: 'fault' | 'note' | 'warning';
  show?: AnyShow | null;
  remedies?: (Remedy)[];
}

/** One thing that changes, at the latest so long after the fault. */
export interface EffectView {
  within_ms: number;
  kind: string;
  subject: string;
  before: string;
  after: string;
  text: Reason;
  is_told?: boolean;
}

/** How a workcell stands when something happens that is foreseen (E16). */
export interface ForeseenInstantView {
  world: string;
  at_s: number;
  text: Reason;
  scene: Record<string, unknown>;
  poses: string;
  lit?: (string)[];
}

/** The faults that can be asked about, or the one that was asked. */
export interface ForesightsView {
  foresights?: (ForesightView)[];
}

/** A fault that could come; what follows, where that was asked. */
export interface ForesightView {
  fault: string;
  subject: string;
  question: Reason;
  answer?: Reason | null;
  effects?: (EffectView)[];
  to_do?: (Reason)[];
  notes?: (Reason)[];
}

/** An open library. */
export interface LibraryView {
  name: string;
  path: string;
  order: number;
  tasks: number;
  faults?: (Reason)[];
  arranged?: (string)[];
  is_shipped?: boolean;
}

/** A parameter of a task's module: what the module declares of it, and its words here. */
export interface ParameterView {
  name: string;
  words?: (string)[];
  shape?: string;
  unit?: string;
  meaning?: string;
  low?: number | null;
  high?: number | null;
  default?: (string)[];
}

/** A pin of a task icon; `y` lies below the icon's upper edge. */
export interface PinView {
  name: string;
  svar: string;
  kind: 'INBOTH' | 'INCONST' | 'INVAR' | 'OUTBOTH' | 'OUTCONST' | 'OUTVAR';
  y: number;
  shape?: string;
  unit?: string;
  meaning?: string;
}

/** A task of a library, with what was changed of it in this session. */
export interface TaskView {
  name: string;
  module: string;
  library: string;
  order: number;
  description: string;
  width: number;
  height: number;
  pins: (PinView)[];
  type?: string;
  hz?: number | null;
  file_hz?: number | null;
  object_type?: string;
  is_trigger?: boolean;
  local?: ([string, (string)[]])[];
  parameters?: (ParameterView)[];
  is_changed?: boolean;
  path?: string;
  code?: string;
  file?: string;
}

/** Where cards are looked for. */
export interface NetworkPlaceView {
  address: string;
  why?: Reason | null;
}

/** A runtime that a site offers, with the robots that it drives. */
export interface NetworkRuntimeView {
  address: string;
  robots?: (string)[];
}

/** A site by its card. */
export interface NetworkSiteView {
  name: string;
  signer: string;
  standing: 'known' | 'namesake' | 'new' | 'older' | 'other_key' | 'overdue';
  until: string;
  description?: string;
  runtimes?: (NetworkRuntimeView)[];
  libraries?: (string)[];
}

/** What one look has found. */
export interface NetworkView {
  places?: (NetworkPlaceView)[];
  sites?: (NetworkSiteView)[];
  left_out?: number;
  bad?: number;
  unjudged?: number;
}

/** The best result of a puzzle on this machine. */
export interface BestView {
  stars: number;
  actions: number;
  took_s: number;
}

/** A condition, and whether it held at the end of a run. */
export interface GoalView {
  text: string;
  is_met?: boolean;
  found?: string;
}

/** What so many conditions, one after the other, mean for people. */
export interface GoalWordsView {
  conditions: number;
  words?: Record<string, string>;
}

/** What came of a run of an application that was begun for a puzzle. */
export interface PuzzleResultView {
  puzzle: string;
  goals?: (GoalView)[];
  is_solved?: boolean;
  uncounted?: Reason;
  stars?: number;
  actions?: number;
  took_s?: number;
}

/** All puzzles, easiest first. */
export interface PuzzlesView {
  puzzles?: (PuzzleView)[];
}

/** A puzzle of the search path. */
export interface PuzzleView {
  name: string;
  level: number;
  titles?: Record<string, string>;
  tasks?: Record<string, string>;
  goals?: (string)[];
  goal_words?: (GoalWordsView)[];
  is_fault?: boolean;
  actions?: number;
  seconds?: number;
  hints?: (Record<string, string>)[];
  tries?: number;
  best?: BestView | null;
}

/** A file that was not sent, because others have changed it meanwhile. */
export interface HeldFileView {
  path: string;
  mine?: string;
  other?: string;
  contradicts?: boolean;
  is_text?: boolean;
}

/** One thing that a library offers: a task, configuration, icon, application or world. */
export interface OfferEntryView {
  kind: string;
  name: string;
  description?: string;
  rows?: (string)[];
  writes?: (string)[];
  touches?: (string)[];
  is_new?: boolean;
}

/** A library as its place has it now. */
export interface OfferView {
  address: string;
  name: string;
  version: number;
  until: string;
  signer: string;
  digest: string;
  description?: string;
  entries?: (OfferEntryView)[];
  used?: number;
  further?: ([string, (string)[]])[];
  refusal?: Reason | null;
}

/** A file of a library before which a copy of the user's own stands that says something else. */
export interface OwnChangeView {
  path: string;
  before?: string;
  mine?: string;
  is_text?: boolean;
}

/** What has become of own changes. */
export interface SentBackView {
  library: string;
  version?: number;
  paths?: (string)[];
  merged?: (string)[];
  is_behind?: boolean;
  held?: (HeldFileView)[];
  agreement?: string;
  folder?: string;
}

/** A library of others that is used. */
export interface UsedLibraryView {
  name: string;
  address: string;
  signer: string;
  trusted: string;
  version: number;
  until: string;
  folder: string;
  lacking?: number;
  changed?: number;
  has_all_rights?: boolean;
}

/** How far the replay of a session is, and the line that was carried out last, in the columns of the log. */
export interface ReplayView {
  file: string;
  position: number;
  count: number;
  at_s?: number;
  length_s?: number;
  speed?: number;
  is_playing?: boolean;
  event?: string;
  object?: string;
  id?: string;
  associated?: string;
  associated_id?: string;
  window?: string;
  faults?: (Reason)[];
  faults_in_all?: number;
}

/** A task that could stand for another one; with `reasons` it cannot. */
export interface CandidateView {
  name: string;
  description?: string;
  more?: (string)[];
  reasons?: (Reason)[];
}

/** The job that a configuration would make. */
export interface DraftView {
  name: string;
  type: string;
  left_edge: string;
  right_edge: string;
  warnings?: (Reason)[];
  picture?: string;
  description?: string;
  path?: string;
}

/** What a runtime says of a module's code that it has loaded; no faults: it is ready. */
export interface LoadedView {
  faults?: ([number, Reason])[];
}

/** The parameter sets of a configuration, where they are kept, and its parameters as they are now. */
export interface ParameterSetsView {
  path: string;
  sets?: (ParameterSetView)[];
  present?: ([string, string, (string)[]])[];
}

/** A parameter set: tasks, each with the name of a parameter and its words. */
export interface ParameterSetView {
  name: string;
  values?: ([string, string, (string)[]])[];
}

/** An icon in small: the digits of its picture, and the keys of its edges. */
export interface PeekIcon {
  picture: string;
  left?: string;
  right?: string;
}

/** What is in a file that could be opened, as much as a small drawing shows. */
export interface PeekView {
  name: string;
  tasks?: Record<string, [number, number, number, number]>;
  wires?: ([string, string])[];
  flows?: ((PeekIcon)[])[];
}

/** A text that can be brought back: where it was, and until when, in s since 1970. */
export interface ReplacedView {
  number: number;
  path: string;
  moment_s: number;
  lines: number;
  is_there?: boolean;
}

/** Values of a variable that came, each at a time, at every cycle of the task that writes it. */
export interface SampledView {
  variable: string;
  last: number;
  missed?: number;
  labels?: (string)[];
  at_s?: (number)[];
  rows?: ((number)[])[];
  reason?: Reason | null;
}

/** The tasks of every flow that is not nested, by its subsystem; where there are several, those of all by "". */
export interface SeatsView {
  flows?: Record<string, (SeatView)[]>;
  worlds?: Record<string, (WorldSeatView)[]>;
}

/** A task that a flow uses, who stands for it now, and who else could: those that can come first. */
export interface SeatView {
  task: string;
  taken_by: string;
  candidates?: (CandidateView)[];
  description?: string;
  is_hardware?: boolean;
}

/** A text that can be edited, with its faults beside their lines. */
export interface TextView {
  path: string;
  text: string;
  stamp: string;
  faults?: ([number, Reason])[];
  is_read_only?: boolean;
}

/** A file of the user's own and the shipped one before which it stands. */
export interface TwoTextsView {
  path: string;
  text: string;
  shipped_path: string;
  shipped_text: string;
}

/** A world that the files of a flow's tasks name, and who stands for it now. */
export interface WorldSeatView {
  world: string;
  taken_by: string;
}

/** The first difference of two recorded runs, or why they cannot be compared; without a text there is none. */
export interface DifferenceView {
  text?: Reason;
  at_s?: number;
  variable?: string;
  tolerance?: number;
  part?: number;
  time_s?: number;
  is_of_places?: boolean;
}

/** What a recorded run was like at an instant. */
export interface InstantView {
  at_s: number;
  run: RunView;
  tasks?: Record<string, string>;
  values?: Record<string, unknown>;
  poses?: Record<string, unknown>;
  homes?: Record<string, string>;
}

/** A test that is being kept, or was last. */
export interface KeepingView {
  doc: string;
  path: string;
  state?: 'failed' | 'kept' | 'running';
  text?: Reason;
  run?: number;
  of?: number;
}

/** Something that happened, worth a mark at the time line: an error, a stop, a meeting, a command. */
export interface MarkView {
  at_s: number;
  kind: 'command' | 'error' | 'meet' | 'stop';
  text: Reason;
}

/** An action that was carried out; the last one of a run cut short has no end. */
export interface PassageView {
  action: number;
  name: string;
  begin_s: number;
  end_s?: number | null;
  step?: number;
}

/** A flow of a recorded run. */
export interface RecordedFlowView {
  order: number;
  passages?: (PassageView)[];
}

/** A variable that was recorded, by `SUBSYSTEM/NAME`. */
export interface RecordedVariableView {
  unit?: string;
  labels?: (string)[];
}

/** A recording that could be looked at. */
export interface RecordingFile {
  path: string;
  name: string;
  began_at_s?: number;
  took_s?: number;
  bytes?: number;
  is_whole?: boolean;
  is_black_box?: boolean;
}

/** The recordings of this environment, newest first, and where they lie. */
export interface RecordingsView {
  folder: string;
  files?: (RecordingFile)[];
}

/** A recorded run. */
export interface RecordingView {
  path: string;
  name: string;
  is_virtual?: boolean;
  is_whole?: boolean;
  is_completed?: boolean;
  cause?: Reason;
  begin_s?: number;
  end_s?: number;
  flows?: Record<string, RecordedFlowView>;
  variables?: Record<string, RecordedVariableView>;
  worlds?: (string)[];
  marks?: (MarkView)[];
  notes?: (Reason)[];
  cannot_continue?: Reason;
  doc?: string;
  began_at_s?: number;
  redirects?: (RedirectView)[];
  inside?: Record<string, SubsystemView>;
  steps_by_task?: Record<string, (number)[]>;
}

/** What is looked at. */
export interface ReviewView {
  recording: RecordingView;
  other?: RecordingView | null;
  difference?: DifferenceView | null;
}

/** A recorded run as one HTML file (X21). */
export interface SharedFileView {
  name: string;
  text: string;
  every_s?: number;
}

/** One element of a variable: in each of equal parts of a time the least and the greatest value. */
export interface StretchView {
  label: string;
  unit: string;
  at_s: (number)[];
  least: (number)[];
  most: (number)[];
}

/** The last seconds of a variable. */
export interface CourseView {
  variable: string;
  unit: string;
  at_s: (number)[];
  values: (unknown)[];
}

/** Where a flow is; `state` is a word of `engine.flow.FlowState`. */
export interface FlowRunView {
  order: number;
  state?: string;
  step?: number;
  action?: string;
  within?: (string)[];
  index?: number;
  of?: number;
  done?: number;
  began_s?: number;
  should_take_s?: number;
  is_pausing?: boolean;
  tag?: string;
  waits_for?: (string)[];
  waits_since_s?: number;
  loops?: (string)[];
  is_nested?: boolean;
  text?: Reason;
  worlds?: (string)[];
  guest?: string;
  station?: string;
}

/** The largest step of an input of a hardware task where what drives it was exchanged, and what became of them. */
export interface JumpView {
  subsystem: string;
  task: string;
  variable: string;
  unit: string;
  jump: number;
  limit: number;
  at_s: number;
  count: number;
  blended?: number;
  cycles?: number;
  refused?: number;
}

/** Flows have begun together at a tag. */
export interface MeetView {
  tag: string;
  flows: (string)[];
  skew_us: number;
  at_s: number;
}

/** A run of an application that goes on now, or is over. */
export interface RunView {
  doc: string;
  name: string;
  number: number;
  state?: 'beginning' | 'over' | 'running';
  began_at_s?: number;
  flows?: Record<string, FlowRunView>;
  steps?: Record<string, StepRunView>;
  asks?: Record<string, AskView>;
  stops?: Record<string, StopView>;
  meets?: (MeetView)[];
  notes?: (Reason)[];
  is_completed?: boolean;
  cause?: Reason;
  can_go_on?: boolean;
  done?: number;
  of?: number;
  took_s?: number;
  jumps?: (JumpView)[];
  recording?: string;
  recorded_bytes?: number;
  black_box?: string;
  repeats_until_s?: number;
  steps_by_task?: Record<string, (number)[]>;
  station?: string;
  puzzle?: PuzzleResultView | null;
}

/** What has become of a step of the application in this run. */
export interface StepRunView {
  state?: 'done' | 'left' | 'running';
  began_s?: number;
  took_s?: number;
  times?: number;
}

/** Why a flow stands still or the run has ended, and what can be done (X06). */
export interface StopView {
  text: Reason;
  kind: string;
  at_s: number;
  subsystem?: string;
  task?: string;
  step?: number;
  action?: string;
  index?: number;
  suspect?: string;
  path?: string;
  line?: number;
  traceback?: string;
  waiting?: ([string, string])[];
  courses?: (CourseView)[];
  choices?: (ChoiceView)[];
  short?: Reason;
  black_box?: string;
  stands?: (Reason)[];
  touches?: (Reason)[];
}

/** Who may change a subsystem that lives (law 27, X12). */
export interface HoldView {
  holder?: string;
  application?: string;
  state?: string;
  since_at_s?: number;
  cause?: Reason;
  former?: string;
  was_here?: boolean;
  offered_to?: string;
  offered_until_s?: number;
  asks?: Record<string, AskView>;
  on_loss?: string;
}

/** The runtime of a station. */
export interface RuntimeView {
  state?: 'linked' | 'lost' | 'none' | 'starting';
  address?: string;
  text?: Reason;
  is_virtual?: boolean;
  is_stopped?: boolean;
  stop_text?: Reason;
  units?: Record<string, UnitView>;
  worlds?: Record<string, boolean>;
  outdated?: Record<string, Reason>;
  subsystems?: Record<string, string>;
  holds?: Record<string, HoldView>;
  sessions?: Record<string, SessionView>;
  inside?: Record<string, SubsystemView>;
  world_kinds?: Record<string, 'real' | 'simulated'>;
  displaced?: Record<string, (Reason)[]>;
  moved?: Record<string, (Reason)[]>;
  pressed?: Record<string, (string)[]>;
  is_cut?: boolean;
  round_trip_ms?: number;
  book?: BookView | null;
  libraries?: (string)[];
  slot_ends?: SlotEndView | null;
  clock_set_s?: number;
}

/** Somebody who is connected with the runtime; a user may be there several times. */
export interface SessionView {
  role: string;
  is_here?: boolean;
  only_watches?: boolean;
  is_you?: boolean;
  lease_s?: number;
}

/** A processing unit. */
export interface UnitView {
  load?: number;
  is_lost?: boolean;
}

/** The form in which a task is given what it asks for. */
export interface ShowAnswer {
  t: 'ShowAnswer';
  task: string;
}

/** The configuration behind a job. */
export interface ShowConfiguration {
  t: 'ShowConfiguration';
  name: string;
}

/** The panel in which a configuration is connected with a runtime. */
export interface ShowConnect {
  t: 'ShowConnect';
}

/** What in the dictionary fits behind a step of a flow; 0 is the start icon. */
export interface ShowFits {
  t: 'ShowFits';
  flow: string;
  after: number;
}

/** The panel in which a library is opened. */
export interface ShowLibraries {
  t: 'ShowLibraries';
}

/** A task in its library. */
export interface ShowLibraryTask {
  t: 'ShowLibraryTask';
  task: string;
}

/** The dot of a state variable on the canvas. */
export interface ShowLocus {
  t: 'ShowLocus';
  svar: string;
}

/** The loop at a step, to be marked anew. */
export interface ShowLoop {
  t: 'ShowLoop';
  step: number;
}

/** An icon in its dictionary. */
export interface ShowOnikon {
  t: 'ShowOnikon';
  onikon: string;
}

/** A pin of a task, where its variable is given another name; the task stands on the canvas or in a library. */
export interface ShowPin {
  t: 'ShowPin';
  task: string;
  pin: string;
}

/** A recorded run, or the last seconds of something; it is opened. */
export interface ShowRecording {
  t: 'ShowRecording';
  path: string;
}

/** The panel in which a name and a base directory are chosen. */
export interface ShowSaveAs {
  t: 'ShowSaveAs';
}

/** The source text of a task's module, at a line of it; 0: at its beginning. */
export interface ShowSource {
  t: 'ShowSource';
  task: string;
  line: number;
}

/** A step of an application. */
export interface ShowStep {
  t: 'ShowStep';
  step: number;
}

/** The panel in which a target of a type is made. */
export interface ShowTarget {
  t: 'ShowTarget';
  type: string;
}

/** A task on the canvas. */
export interface ShowTask {
  t: 'ShowTask';
  task: string;
}

/** The values of the target at a step. */
export interface ShowValues {
  t: 'ShowValues';
  step: number;
}

/** A task of a running application. */
export interface LivingTaskView {
  state: '' | 'ASKING' | 'ERROR' | 'KILLING' | 'OFF' | 'ON' | 'SPAWNING' | 'WAITING';
  note?: Reason;
  rtpu?: string;
  hz?: number;
}

/** A state variable, and the tasks that share it. */
export interface SharedVariableView {
  is_constant?: boolean;
  writers?: (string)[];
  readers?: (string)[];
}

/** What lives in a subsystem for an application. */
export interface SubsystemView {
  application: string;
  tasks?: Record<string, LivingTaskView>;
  variables?: Record<string, SharedVariableView>;
}

/** A button of the user's own, and the command behind it. */
export interface ButtonView {
  command: string;
  order: number;
  spawns_terminal?: boolean;
  is_running?: boolean;
  output?: string;
  code?: number | null;
}

/** A configuration that could be opened. */
export interface ConfigurationFile {
  name: string;
  base: string;
  path: string;
  tasks?: number;
}

/** Everything. */
export interface Tree {
  libraries?: Record<string, LibraryView>;
  tasks?: Record<string, TaskView>;
  own_copies?: Record<string, string>;
  module_sentences?: Record<string, Record<string, Record<string, string>>>;
  touched?: Record<string, number>;
  documents?: Record<string, DocumentView>;
  files?: Record<string, ConfigurationFile>;
  loads?: Record<string, number>;
  clipboard?: string;
  runtime?: RuntimeView;
  stations?: Record<string, RuntimeView>;
  preferences?: Record<string, unknown>;
  buttons?: Record<string, ButtonView>;
  job_types?: (string)[];
  edges?: Record<string, [string, ([number, number])[]]>;
  applications?: Record<string, ApplicationView>;
  application_files?: Record<string, ApplicationFile>;
  dictionaries?: Record<string, DictionaryView>;
  onikons?: Record<string, OnikonView>;
  types?: Record<string, TypeView>;
  pictures?: Record<string, string>;
  icon_clipboard?: Reason;
  own_undo?: Reason;
  own_redo?: Reason;
  run?: RunView | null;
  beside?: Record<string, RunView>;
  review?: ReviewView | null;
  keeping?: KeepingView | null;
  replay?: ReplayView | null;
  people?: number;
  class_seat?: ClassSeatView | null;
}

/** What can be done with a run that stands still. */
export interface ChoiceView {
  verb: string;
  meaning: Reason;
  subsystem?: string;
  act?: AnyAct | null;
}

/** Why something is refused or worth a warning, in words, with what could be done, likeliest first (X01). */
export interface Objection {
  text: Reason;
  remedies?: (Remedy)[];
}

/** A button beside a refusal: it sends `act`, or goes to what `show` names. */
export interface Remedy {
  label: Reason;
  act?: AnyAct | null;
  show?: AnyShow | null;
}

/** An act with the number by which it is answered. */
export interface Ordered {
  cid: number;
  act: AnyAct;
}

/** Everything, at a revision; first of all, and whenever a browser was too slow for patches. */
export interface Snapshot {
  t: 'Snapshot';
  rev: number;
  tree: Tree;
  version: string;
  you: string;
  user?: string;
  role?: string;
}

/** What has changed from one revision to the next, and who did it. */
export interface Patch {
  t: 'Patch';
  rev: number;
  changes: ([(string)[], unknown])[];
  by?: string;
}

/** An act is done, or accepted where its outcome is a fact that comes later. */
export interface Ok {
  t: 'Ok';
  cid: number;
  rev: number;
  value?: unknown;
}

/** An act changed nothing, and why. */
export interface Refused {
  t: 'Refused';
  cid: number;
  reason: Reason;
  remedies?: (Remedy)[];
  fields?: Record<string, Reason>;
}

/** The newest values of what this browser watches; late ones are dropped. */
export interface Frame {
  t: 'Frame';
  at_s: number;
  values?: Record<string, unknown>;
  figures?: Record<string, Record<string, unknown>>;
  poses?: Record<string, unknown>;
}

/** A line of the log, or a word beside something; `where` it is about, with its document. */
export interface Say {
  t: 'Say';
  level: 'end' | 'error' | 'info' | 'success' | 'warning';
  text: Reason;
  doc?: string;
  where?: AnyShow | null;
  at_s?: number;
  is_quiet?: boolean;
  remedies?: (Remedy)[];
}

/** What is left of an act that cannot be read: the number by which it is answered. */
export interface Numbered {
  cid: number;
}

/** Something that was expected of a hand-in, whether it holds, and why not. */
export interface ExpectationRow {
  text: string;
  holds: boolean;
  why: Reason;
}

/** A seat; ages in seconds, memory in bytes. */
export interface SeatRow {
  seat: number;
  learner: string;
  state: 'frozen' | 'taken' | 'works';
  process: 'off' | 'silent' | 'starting' | 'there';
  pages: number;
  program: string;
  icons: number;
  steps: number;
  idle_s: number;
  is_stuck: boolean;
  run: string;
  done: number;
  of: number;
  why: Reason;
  refusal: Reason;
  refusal_s: number;
  ended: Reason;
  note: string;
  handed_in: number;
  expectations: (ExpectationRow)[];
  grade_why: Reason;
  may_return: boolean;
  bytes: number;
  processes: number;
  course: string;
  lessons: number;
  lessons_of: number;
}

/** The whole class. */
export interface ClassBoard {
  code: string;
  address: string;
  seats: number;
  rows: (SeatRow)[];
  trouble: Reason;
}

/** What the board asks for: of which seats, and with which words. */
export interface TeacherAct {
  act: 'collect' | 'freeze' | 'release' | 'restart' | 'return' | 'take' | 'tell';
  seats: (number)[];
  text: string;
}

export type AnyAct = New | Open | OpenInPlace | Peek | Close | Save | Reload | Keep | Undo | Redo | Place | Exchange | Remove | Move | Flip | Align | Arrange | Show | Copy | Cut | Paste | Group | Ungroup | SaveGroup | Insert | TurnGroup | Rate | Unit | Check | OpenLibrary | CloseLibrary | Alias | LibraryRate | Local | ListSets | KeepSet | SwitchSet | RemoveSet | SaveTask | ForgetTask | ReadText | WriteText | NewModule | ArrangeTask | ArrangeIcon | LoadModule | CompareWithShipped | GoBackToShipped | ListReplaced | ListPuzzles | BeginPuzzle | BringBack | ListRemoteLibraries | BrowseLibrary | TakeLibrary | DropLibrary | GiveLibraryRights | ListOwnChanges | SendBack | LookAtNetwork | AddPlace | DropPlace | TrustSite | Connect | AddStation | PlaceFlow | RemoveStation | Disconnect | KeepAlive | SwitchTo | LetGo | Turn | Toggle | Clear | Reinit | Renew | FindRoom | AskModule | TellModule | WriteVariable | CheckMemory | LogReadings | SampleVariables | Answer | Stop | Reset | AddUnit | RecordByHand | Take | Release | Hand | Decline | OnlyWatch | WatchNoMore | Company | LookAtBookings | BookRobot | ProlongBooking | TakeBackBooking | SteerTaken | Watch | Scene | Meshes | Draft | MakeJob | Prefer | Press | Halt | SetButton | Note | SteerReplay | NewApplication | InsertIcon | InsertBranch | SetConditions | ExchangeIcon | RemoveIcons | MoveIcons | CopyIcons | CutIcons | PasteIcons | EditIcon | SetBreakpoint | SetSynchTag | SetLoop | RepeatSteps | RemoveLoop | AddFlow | RemoveFlow | SetParallel | OpenDictionary | CloseDictionary | MakeTarget | EditOnikon | RemoveOnikon | Teach | Push | PointAt | FitTargets | Run | Redirect | Seats | FindWorlds | Steer | SkipTo | Dismiss | StartAnew | PutBack | Touch | Preflight | ForeseenInstant | WhatIf | OpenRecording | CloseRecording | Recordings | RecordedScene | Glance | Course | CompareWith | Continue | ShareRecording | KeepTest;
export type AnyMessage = Snapshot | Patch | Ok | Refused | Frame | Say;
export type AnyShow = ShowTask | ShowPin | ShowLocus | ShowSource | ShowAnswer | ShowLibraryTask | ShowLibraries | ShowConnect | ShowSaveAs | ShowStep | ShowFits | ShowValues | ShowLoop | ShowConfiguration | ShowOnikon | ShowTarget | ShowRecording;
