// Drawn from src/onika/wire/{act,view,page}.py by tools/generate.py: change those.

/** Open a blank configuration. */
export interface New {
  t: 'New';
}

/** Open a configuration, by its file or by its name on the search path, beside the others (decision 15). */
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

/** Close a document; one that is not saved is refused unless `discards`, one whose tasks are ON is asked about. alive what becomes of tasks that live: they end with it where none is ON; else `end` or `leave` says it */
export interface Close {
  t: 'Close';
  doc: string;
  discards?: boolean;
  alive?: 'ask' | 'end' | 'leave';
}

/** Save a document where it was opened, or under a name (in a base directory, else its own). */
export interface Save {
  t: 'Save';
  doc: string;
  name?: string;
  base?: string;
  overwrites?: boolean;
}

/** Take over what stands in the file now; what was changed here can be had back by Undo. */
export interface Reload {
  t: 'Reload';
  doc: string;
}

/** Go on with what is here although the file has changed; the next Save overwrites it. */
export interface Keep {
  t: 'Keep';
  doc: string;
}

/** Take the last step of a document back, in the running system too (law 22). */
export interface Undo {
  t: 'Undo';
  doc: string;
  confirmed?: boolean;
}

/** Do the step again that was taken back last. */
export interface Redo {
  t: 'Redo';
  doc: string;
  confirmed?: boolean;
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

/** Place a task where another stands, in its stead. */
export interface Exchange {
  t: 'Exchange';
  doc: string;
  old: string;
  new: string;
}

/** Remove tasks, and kill them where they live. */
export interface Remove {
  t: 'Remove';
  doc: string;
  tasks: (string)[];
}

/** Move tasks and loci to these corners, as one step. */
export interface Move {
  t: 'Move';
  doc: string;
  tasks?: Record<string, [number, number]>;
  loci?: Record<string, [number, number]>;
}

/** Turn the direction of data flow in the icons of tasks. */
export interface Flip {
  t: 'Flip';
  doc: string;
  tasks: (string)[];
}

/** Bring tasks onto one line, or to equal distances. */
export interface Align {
  t: 'Align';
  doc: string;
  tasks: (string)[];
  edge: 'bottom' | 'columns' | 'left' | 'right' | 'rows' | 'top';
}

/** Show or hide the connections of variables. */
export interface Show {
  t: 'Show';
  doc: string;
  svars: (string)[];
  is_shown: boolean;
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

/** Place what is in the buffer, or in a text that was copied elsewhere, with its upper left corner here. */
export interface Paste {
  t: 'Paste';
  doc: string;
  x: number;
  y: number;
  text?: string;
}

/** Handle tasks as one from now on, under a name: a supermodule; in this order they come (C17). */
export interface Group {
  t: 'Group';
  doc: string;
  name: string;
  tasks: (string)[];
}

/** Expand a supermodule into its parts. */
export interface Ungroup {
  t: 'Ungroup';
  doc: string;
  name: string;
}

/** Save a supermodule as a configuration of its own, which Insert recalls; where no base is named, in its own. */
export interface SaveGroup {
  t: 'SaveGroup';
  doc: string;
  name: string;
  base?: string;
  overwrites?: boolean;
}

/** Place all tasks of a configuration as a supermodule of its name, with its upper left corner here; all or none. */
export interface Insert {
  t: 'Insert';
  doc: string;
  path: string;
  x: number;
  y: number;
}

/** Turn a supermodule ON in its order, or OFF the other way round. */
export interface TurnGroup {
  t: 'TurnGroup';
  doc: string;
  name: string;
  is_on: boolean;
}

/** The rate of a task in this configuration in Hz; 0: as its file says. */
export interface Rate {
  t: 'Rate';
  doc: string;
  task: string;
  hz: number;
}

/** The processing unit that a task of this configuration lives on. */
export interface Unit {
  t: 'Unit';
  doc: string;
  task: string;
  rtpu: string;
}

/** Check the configuration: all rules and warnings (C26); replied with the sentences. */
export interface Check {
  t: 'Check';
  doc: string;
}

/** Add a base directory to the libraries that are open. */
export interface OpenLibrary {
  t: 'OpenLibrary';
  path: string;
}

/** Close a library; what is placed stays. */
export interface CloseLibrary {
  t: 'CloseLibrary';
  library: string;
}

/** Give the state variable behind a coded name; an empty one means the coded name (C04, C23). */
export interface Alias {
  t: 'Alias';
  task: string;
  pin: string;
  svar: string;
  doc?: string;
}

/** A task's rate in Hz for later placements of this session (decision 10). */
export interface LibraryRate {
  t: 'LibraryRate';
  task: string;
  hz: number;
}

/** The LOCAL lines of a task, each a key and its words. */
export interface Local {
  t: 'Local';
  task: string;
  lines: ([string, (string)[]])[];
  doc?: string;
}

/** Write what was changed of a task to its `.rmod`. */
export interface SaveTask {
  t: 'SaveTask';
  task: string;
  overwrites?: boolean;
}

/** Take a task as its file says again. */
export interface ForgetTask {
  t: 'ForgetTask';
  task: string;
}

/** Ask for the text of a task's `.rmod` or of its module's code; replied by `view.TextView`. */
export interface ReadText {
  t: 'ReadText';
  task: string;
  kind: 'code' | 'rmod';
}

/** Save such a text where the file is still what was read (`stamp`), and tell its faults. */
export interface WriteText {
  t: 'WriteText';
  task: string;
  kind: 'code' | 'rmod';
  text: string;
  stamp: string;
  overwrites?: boolean;
}

/** Connect a configuration with a runtime: merge it with what runs there (C12, C18). url empty: the runtime of this environment */
export interface Connect {
  t: 'Connect';
  doc: string;
  url?: string;
  token?: string;
  subsystem?: string;
  confirmed?: boolean;
}

/** Leave what runs as it is, and go on unconnected. */
export interface Disconnect {
  t: 'Disconnect';
  doc: string;
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

/** ON to OFF and back; a task in ERROR is cleared (C11). */
export interface Toggle {
  t: 'Toggle';
  doc: string;
  task: string;
}

/** Bring a task out of ERROR, and on again where that is wanted. */
export interface Clear {
  t: 'Clear';
  doc: string;
  task: string;
  turns_on?: boolean;
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
}

/** Answer what a task asks, in the words of an argument line (C13). */
export interface Answer {
  t: 'Answer';
  doc: string;
  task: string;
  line: string;
}

/** Stop everything: every drive holds (law 27). Always carried out first, never refused. */
export interface Stop {
  t: 'Stop';
}

/** After a Stop: allow motion again. */
export interface Reset {
  t: 'Reset';
}

/** Become the holder of a document's subsystem. */
export interface Take {
  t: 'Take';
  doc: string;
}

/** Let another become the holder. */
export interface Release {
  t: 'Release';
  doc: string;
}

/** What this browser wants to see from now on: variables as `DOC/NAME`, worlds by name, figures of tasks. */
export interface Watch {
  t: 'Watch';
  variables?: (string)[];
  worlds?: (string)[];
  figures?: boolean;
  hz?: number;
}

/** Ask for what a world consists of; replied with it. */
export interface Scene {
  t: 'Scene';
  world: string;
}

/** Ask what job a configuration would make; replied by `view.DraftView` (C16). */
export interface Draft {
  t: 'Draft';
  doc: string;
}

/** Save the configuration and its onikon, with a picture of 1024 digits (C16, D07). */
export interface MakeJob {
  t: 'MakeJob';
  doc: string;
  picture: string;
  description?: string;
  overwrites?: boolean;
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

/** End the command of a user's button. */
export interface Halt {
  t: 'Halt';
  name: string;
}

/** Add a button or change it; an empty command removes it. */
export interface SetButton {
  t: 'SetButton';
  name: string;
  command: string;
  spawns_terminal?: boolean;
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

/** A button beside a refusal: it sends `act`, or goes to what `show` names. show `task:NAME`, `library:NAME`, `pin:TASK/PIN`, `locus:NAME`, `source:TASK`, `connect`, `problems` */
export interface Remedy {
  label: string;
  act?: AnyAct | null;
  show?: string;
}

/** Why something is refused or worth a warning, in words, with what could be done, likeliest first (X01). */
export interface Reason {
  text: string;
  remedies?: (Remedy)[];
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
  is_changed?: boolean;
  path?: string;
  code?: string;
}

/** An open library. */
export interface LibraryView {
  name: string;
  path: string;
  order: number;
  tasks: number;
  faults?: (string)[];
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
  reason?: string;
  present?: Record<string, (number)[]>;
}

/** Why a task is in ERROR, and the ways out. */
export interface ErrorView {
  text: string;
  entry?: string;
  path?: string;
  line?: number;
  traceback?: string;
  at_s?: number;
  values?: Record<string, unknown>;
  remedies?: (Remedy)[];
}

/** A task on a canvas. */
export interface PlacedView {
  x: number;
  y: number;
  in_left?: boolean;
  hz?: number;
  rtpu?: string;
  state?: '' | 'ASKING' | 'ERROR' | 'KILLING' | 'OFF' | 'ON' | 'SPAWNING' | 'WAITING';
  note?: string;
  is_missing?: boolean;
  ask?: AskView | null;
  error?: ErrorView | null;
  warnings?: number;
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

/** Something wrong with a document, or worth knowing; `show` as in `Remedy`. */
export interface ProblemView {
  text: string;
  level: 'fault' | 'note' | 'warning';
  show?: string;
  remedies?: (Remedy)[];
}

/** A supermodule: tasks that are handled as one, in their order of spawning and turning ON. */
export interface GroupView {
  tasks: (string)[];
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
  undo?: string;
  redo?: string;
  tasks?: Record<string, PlacedView>;
  loci?: Record<string, LocusView>;
  groups?: Record<string, GroupView>;
  greyed?: Record<string, (Reason)[]>;
  objections?: Record<string, (Reason)[]>;
  problems?: Record<string, ProblemView>;
  connection?: 'connecting' | 'live' | 'lost' | 'none';
  subsystem?: string;
  holder?: string;
  is_held_here?: boolean;
}

/** A processing unit. */
export interface UnitView {
  load?: number;
  is_lost?: boolean;
}

/** The runtime of this environment. */
export interface RuntimeView {
  state?: 'linked' | 'lost' | 'none' | 'starting';
  address?: string;
  text?: string;
  is_virtual?: boolean;
  is_stopped?: boolean;
  stop_text?: string;
  units?: Record<string, UnitView>;
  worlds?: Record<string, boolean>;
  subsystems?: Record<string, string>;
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
  documents?: Record<string, DocumentView>;
  files?: Record<string, ConfigurationFile>;
  clipboard?: string;
  runtime?: RuntimeView;
  preferences?: Record<string, unknown>;
  buttons?: Record<string, ButtonView>;
  job_types?: (string)[];
  edges?: Record<string, [string, ([number, number])[]]>;
  people?: number;
}

/** A text that can be edited, with its faults beside their lines. */
export interface TextView {
  path: string;
  text: string;
  stamp: string;
  faults?: ([number, string])[];
  is_read_only?: boolean;
}

/** The job that a configuration would make. */
export interface DraftView {
  name: string;
  type: string;
  left_edge: string;
  right_edge: string;
  warnings?: (string)[];
  picture?: string;
  description?: string;
  path?: string;
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
  reason: string;
  remedies?: (Remedy)[];
  fields?: Record<string, string>;
}

/** The newest values of what this browser watches; late ones are dropped. */
export interface Frame {
  t: 'Frame';
  at_s: number;
  values?: Record<string, unknown>;
  figures?: Record<string, Record<string, unknown>>;
  poses?: Record<string, unknown>;
}

/** A line of the log, or a word beside something; `where` as in `Remedy.show`, with its document. */
export interface Say {
  t: 'Say';
  level: 'end' | 'error' | 'info' | 'success' | 'warning';
  text: string;
  doc?: string;
  where?: string;
  at_s?: number;
}

export type AnyAct = New | Open | OpenInPlace | Close | Save | Reload | Keep | Undo | Redo | Place | Exchange | Remove | Move | Flip | Align | Show | Copy | Cut | Paste | Group | Ungroup | SaveGroup | Insert | TurnGroup | Rate | Unit | Check | OpenLibrary | CloseLibrary | Alias | LibraryRate | Local | SaveTask | ForgetTask | ReadText | WriteText | Connect | Disconnect | Turn | Toggle | Clear | Reinit | Renew | Answer | Stop | Reset | Take | Release | Watch | Scene | Draft | MakeJob | Prefer | Press | Halt | SetButton | Note;
export type AnyMessage = Snapshot | Patch | Ok | Refused | Frame | Say;
