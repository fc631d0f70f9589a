// The keys of the workspace that mean something by how they are held or where the cursor is; all others are commands.
import { allCommands, isAvailable, matches } from '../state/commands'
import { pickSteps, workspace } from '../state/workspace.svelte'
import { workspaceState } from './workspaceState.svelte'
import { goTo, select, selectAlso, selectTo } from './acts'
import { walked, type Way } from '../application/gaps'

const WAYS: Readonly<Record<string, Way>> = {
  ArrowLeft: 'left',
  ArrowRight: 'right',
  ArrowUp: 'up',
  ArrowDown: 'down',
  Home: 'first',
  End: 'last',
}

/** True where the key meant something here. */
export function keyDown(event: KeyboardEvent): boolean {
  if (!workspaceState.hasKeyboard || event.altKey) return false
  if (workspaceState.opened.kind !== '') return false
  const way = WAYS[event.key]
  const isControl = event.ctrlKey || event.metaKey
  if (way)
    return walk(isControl && way === 'first' ? 'begin' : isControl && way === 'last' ? 'end' : way, event.shiftKey)
  if (isControl) return false
  if (event.key === ' ') return turn()
  return type(event)
}

/** What is picked alone goes along with the cursor; with Shift more and more is picked. */
function walk(way: Way, adds: boolean): boolean {
  const from = workspace.place
  const gap = walked(workspaceState.base.gaps, from, way)
  if (!gap) return true
  if (adds) {
    if (from.after && !workspace.steps.size) workspace.steps.add(from.after)
    if (gap.after) selectTo(gap.after)
    goTo(gap, true)
    return true
  }
  const goesAlong = workspace.steps.size === 1 && workspace.steps.has(from.after)
  if (goesAlong && gap.after) select(gap.after)
  else if (workspace.steps.size) pickSteps()
  goTo(gap, true)
  return true
}

function turn(): boolean {
  if (workspace.place.after) selectAlso(workspace.place.after)
  return true
}

/** A letter begins the search for an icon, where it is not a key for what is picked. */
function type(event: KeyboardEvent): boolean {
  const isLetter = event.key.length === 1 && /\p{L}/u.test(event.key)
  if (!isLetter || workspace.steps.size > 0 || isPasting(event.key) || workspaceState.isRunning || isCommand(event))
    return false
  workspaceState.opened = { kind: 'quick', words: event.key }
  return true
}

/** With the keyboard nowhere in particular, a letter that is a command stays one. */
const isCommand = (event: KeyboardEvent): boolean =>
  !workspaceState.hasKeys &&
  allCommands().some((command) => command.keys?.some((keys) => matches(keys, event)) && isAvailable(command))

/** V pastes what is in the buffer, wherever it is pressed (table B.4). */
const isPasting = (key: string): boolean => key.toLowerCase() === 'v'
