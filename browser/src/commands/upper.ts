// The commands of the workspace. Where the insertion cursor stands is where they mean.
import { act } from '../act/act'
import { command, type Command } from '../state/commands'
import { closesFirst } from '../state/layers'
import { workspace } from '../state/workspace.svelte'
import { topsOf } from '../application/actions'
import { isHeldToWords } from '../onikon/presentation'
import { workspaceState, SIZES } from '../workspace/workspaceState.svelte'
import {
  addFlow,
  askForLoop,
  askForOther,
  askHowOften,
  copy,
  cut,
  deselect,
  edit,
  editPicture,
  expand,
  insert,
  meant,
  meantHeads,
  paste,
  remove,
  removeFlow,
  replaceable,
  selectAll,
  setParallel,
  turnBreakpoint,
  whyNotExpand,
} from '../workspace/acts'
import { t, type TextKey } from '../texts/index.svelte'

function add(
  id: string,
  title: TextKey,
  rest: Omit<Command, 'id' | 'title' | 'group' | 'level'> & { group?: Command['group'] },
): void {
  command({ group: 'application', level: 'applications', ...rest, id: `upper.${id}`, title: () => t(title) })
}

const isOpen = (): boolean => workspaceState.app !== undefined
const isHere = (): boolean => workspaceState.hasKeyboard
const isFree = (): boolean => isHere() && !workspaceState.isRunning
const isPicked = (): boolean => workspace.steps.size > 0
/** What is picked, or the icon that the cursor stands behind. */
const isMeant = (): boolean => isHere() && meant().length > 0
const hasAction = (): boolean => isHere() && meantHeads().length > 0
/** A letter alone means what is picked; with nothing picked it begins a search. */
const isLetterFree = (): boolean => isPicked() || workspaceState.isRunning
const isNoText = (): boolean => window.getSelection()?.isCollapsed ?? true
const head = (): number => meantHeads()[0] ?? 0
const firstMeant = (): number => meant()[0] ?? 0

function nextSize(by: 1 | -1): void {
  const at = SIZES.findIndex((size) => size === workspaceState.size) + by
  workspaceState.resize(SIZES[Math.max(0, Math.min(SIZES.length - 1, at))]!)
}

function registerUpper(): void {
  add('add', 'upper.add', {
    keys: ['/', 'Enter'],
    when: isFree,
    run: () => (workspaceState.opened = { kind: 'quick', words: '' }),
  })
  add('insertSelected', 'upper.insertSelected', {
    when: () => isOpen() && workspace.onikon !== '',
    run: () => insert(workspace.onikon),
  })
  add('replaceBy', 'upper.replaceBy', {
    keys: ['R'],
    when: () => isFree() && isLetterFree() && replaceable() > 0,
    run: () => askForOther(),
  })
  add('insertBranch', 'upper.insertBranch', {
    keys: ['B'],
    when: () => isFree() && isLetterFree(),
    run: () => (workspaceState.opened = { kind: 'branch', step: 0 }),
  })
  add('edit', 'upper.edit', { keys: ['F2'], when: isMeant, run: () => edit(firstMeant()) })
  add('picture', 'upper.picture', {
    keys: ['Shift+F2'],
    when: () => isMeant() && !isHeldToWords(),
    run: () => editPicture(firstMeant()),
  })
  add('expand', 'upper.expand', {
    keys: ['Shift+Enter'],
    when: () => isMeant() && !whyNotExpand(firstMeant()),
    run: () => expand(firstMeant()),
  })
  add('cut', 'upper.cutPicked', {
    group: 'edit',
    keys: ['Delete', 'Backspace', 'Ctrl+X'],
    when: () => isFree() && isMeant() && isNoText(),
    run: () => cut(),
  })
  add('cutLetter', 'upper.cut', { group: 'edit', keys: ['X'], when: () => isFree() && isPicked(), run: () => cut() })
  add('copy', 'upper.copy', { group: 'edit', keys: ['Ctrl+C'], when: () => isMeant() && isNoText(), run: () => copy() })
  add('copyLetter', 'upper.copyPicked', {
    group: 'edit',
    keys: ['C'],
    when: () => isHere() && isPicked(),
    run: () => copy(),
  })
  add('paste', 'upper.paste', { group: 'edit', keys: ['V'], when: isFree, run: () => paste() }) // Ctrl+V comes as an event of its own
  add('remove', 'upper.delete', { group: 'edit', when: () => isOpen() && isPicked(), run: () => remove() })
  add('selectAll', 'upper.selectAll', { group: 'edit', keys: ['Ctrl+A'], when: isHere, run: selectAll })
  add('deselect', 'upper.deselect', {
    group: 'edit',
    keys: ['Escape'],
    when: () => isHere() && !closesFirst() && (isPicked() || workspace.onikon !== ''),
    run: leave,
  })
  add('break', 'upper.breakTurn', {
    keys: ['M'],
    when: () => hasAction() && isLetterFree(),
    run: () => turnBreakpoint(),
  })
  add('breakIf', 'upper.breakIf', {
    when: hasAction,
    run: () => (workspaceState.opened = { kind: 'condition', step: head() }),
  })
  add('tag', 'upper.tag', {
    keys: ['S'],
    when: () => isFree() && hasAction() && isLetterFree(),
    run: () => (workspaceState.opened = { kind: 'tag', step: head() }),
  })
  add('loop', 'upper.loop', {
    keys: ['W'],
    when: () => isFree() && hasAction() && isLetterFree(),
    run: () => askForLoop(),
  })
  add('repeat', 'upper.repeat', { when: () => isFree() && hasAction(), run: () => askHowOften() })
  add('menu', 'upper.openMenu', { keys: ['Shift+F10', 'ContextMenu'], when: isHere, run: openMenu })
  add('skipTo', 'upper.skipHere', {
    group: 'run',
    when: () => workspaceState.isRunning && head() > 0,
    run: () => act({ t: 'SkipTo', step: head(), doc: workspace.app }),
  })
  add('addFlow', 'upper.addFlow', { when: isOpen, run: () => addFlow() })
  add('removeFlow', 'upper.removeThisFlow', {
    when: () => isOpen() && (topsOf(workspaceState.app!).length > 1 || workspace.place.flow.includes('/')),
    run: () => removeFlow(workspace.place.flow),
  })
  add('turnKind', 'upper.turnKind', {
    when: () => isOpen() && topsOf(workspaceState.app!).length > 1,
    run: () => setParallel(!workspaceState.app?.is_parallel),
  })
  add('larger', 'upper.larger', { group: 'view', keys: ['+', '='], when: isHere, run: () => nextSize(1) })
  add('smaller', 'upper.smaller', { group: 'view', keys: ['-'], when: isHere, run: () => nextSize(-1) })
  add('letters', 'upper.turnLetters', { group: 'view', when: isOpen, run: () => workspaceState.turnLetters() })
  add('walk', 'upper.walk', { keys: ['←↑→↓', 'Home', 'End'], when: () => false, run: () => undefined }) // for the help sheet; see keys.ts
  add('pick', 'upper.pick', { keys: ['Space', 'Shift+←→'], when: () => false, run: () => undefined })
}

function leave(): void {
  deselect()
  workspace.onikon = ''
}

/** Where a click would have been: at the cursor. */
function openMenu(): void {
  const { caret } = workspaceState
  const at = workspaceState.toWindow({ x: caret?.x ?? 60, y: (caret?.y ?? 60) + workspaceState.size })
  workspaceState.opened = {
    kind: 'menu',
    at,
    over: workspaceState.step(workspace.place.after)
      ? { kind: 'step', step: workspace.place.after }
      : { kind: 'flow', flow: workspace.place.flow },
  }
}

registerUpper()
