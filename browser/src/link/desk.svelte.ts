// The copy of the environment's tree that this page draws from. Only what the environment sends changes it.
import type { Patch, RunView, Snapshot, TaskView, Tree } from '../api.gen'
import { workspace } from '../state/workspace.svelte'
import { modules, plain } from '../texts/say'
import { Exchange, withParts } from './treeParts'

/** A tree whose maps are all there. What is optional inside a document or a task stays optional. */
export type FullTree = Required<Tree>

/** How the tree is shown where something else than the present is looked at: a recorded run. */
export type TreeAt = (live: FullTree) => FullTree

export function fullTree(tree: Tree): FullTree {
  const empty: FullTree = {
    libraries: {},
    tasks: {},
    module_sentences: {},
    own_copies: {},
    touched: {},
    documents: {},
    files: {},
    loads: {},
    own_undo: plain(''),
    own_redo: plain(''),
    clipboard: '',
    runtime: {},
    stations: {},
    preferences: {},
    buttons: {},
    job_types: [],
    edges: {},
    people: 0,
    applications: {},
    application_files: {},
    dictionaries: {},
    onikons: {},
    types: {},
    pictures: {},
    icon_clipboard: plain(''),
    run: null,
    beside: {},
    review: null,
    keeping: null,
    replay: null,
    class_seat: null,
  }
  return withParts({ ...empty, ...tree })
}

/** Every run of this environment: the one that was begun last, then those beside it. */
export const runsIn = (tree: FullTree): RunView[] => [...(tree.run ? [tree.run] : []), ...Object.values(tree.beside)]

/** The run that this browser shows and steers: that of the application shown, else the one that was begun last. */
function shownRun(tree: FullTree): RunView | null {
  const own = runsIn(tree).filter((run) => run.doc === workspace.app)
  return own.find((run) => run.state !== 'over') ?? own[0] ?? tree.run
}

const withShownRun = new WeakMap<FullTree, FullTree>()

/** The tree as this browser shows it where several applications run: each browser looks at one of them. */
function asShown(tree: FullTree): FullTree {
  const before = withShownRun.get(tree)
  if (before) return before
  const shown = new Proxy(tree, {
    get: (original, name) => (name === 'run' ? shownRun(original) : Reflect.get(original, name)),
  })
  withShownRun.set(tree, shown)
  return shown
}

class Desk {
  /** What the environment has sent. */
  now: FullTree = $state(fullTree({}))
  /** Of the tree; -1 before the first snapshot. */
  rev = $state(-1)
  isLinked = $state(false)
  /** Whether the environment does not let this browser in any more. */
  isLocked = $state(false)
  /** The name of this browser. */
  you = $state('')
  /** Who has signed in here; empty: whoever sits at the machine. */
  user = $state('')
  /** What that one may do; empty: everything. */
  role = $state('')
  version = $state('')
  treeAt: TreeAt | undefined

  /** What is so now. Only who speaks of the present whatever is looked at reads it: Stop, the runtime, the tabs. */
  get live(): FullTree {
    return Object.keys(this.now.beside).length ? asShown(this.now) : this.now
  }

  /** What is shown: the present, or the instant of a recorded run that is looked at. */
  get tree(): FullTree {
    return this.live.review && this.treeAt ? this.treeAt(this.live) : this.live
  }

  /** A task as a configuration has it; of one that is not otherwise there, as its library has it. */
  task(name: string, doc = ''): TaskView | undefined {
    return this.tree.documents[doc]?.own?.[name] ?? this.tree.tasks[name]
  }

  set tree(tree: FullTree) {
    this.now = tree
  }
}

export const desk = new Desk()
modules.sentences = () => desk.live.module_sentences

export function applySnapshot(snapshot: Snapshot): void {
  desk.tree = fullTree(snapshot.tree)
  desk.rev = snapshot.rev
  desk.you = snapshot.you
  desk.user = snapshot.user ?? ''
  desk.role = snapshot.role ?? ''
  desk.version = snapshot.version
}

/** Take over a patch; false where it does not follow what is here, and a new snapshot is needed. */
export function applyPatch(patch: Patch): boolean {
  if (patch.rev !== desk.rev + 1) return false
  const exchange = new Exchange(desk.now)
  for (const [path, value] of patch.changes) if (!exchange.take(path, value)) change(path, value)
  exchange.finish()
  desk.rev = patch.rev
  return true
}

type Branch = Record<string, unknown>

/** Put a value at its place; null takes away. Branches on the way that were empty, and so not sent, grow. */
function change(path: readonly string[], value: unknown): void {
  let branch = desk.now as unknown as Branch
  for (const step of path.slice(0, -1)) {
    if (branch[step] === undefined || branch[step] === null) {
      if (value === null) return
      branch[step] = {}
    }
    branch = branch[step] as Branch
  }
  const last = path.at(-1)
  if (last === undefined) return
  if (value !== null) branch[last] = value
  else if (path.length === 1) branch[last] = (fullTree({}) as unknown as Branch)[last]
  else delete branch[last]
}
