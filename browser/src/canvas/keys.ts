// The keys of the canvas that mean something by how they are held or where the keyboard is; all others are commands.
import { neighbour, type Direction, type Named } from '../geom/spatial'
import { canvas } from '../state/canvas.svelte'
import { nudge, pickedTasks } from '../scene/acts'
import { selectAlsoAll, wholeOf } from '../group/grouping'
import { membersOf } from '../scene/groups'
import { canvasState } from '../scene/canvasState.svelte'

const STEP = 5
const STRIDE = 25
const WAY: Readonly<Record<string, Direction>> = {
  ArrowLeft: 'left',
  ArrowRight: 'right',
  ArrowUp: 'up',
  ArrowDown: 'down',
}
const ALONG: Record<Direction, readonly [number, number]> = { left: [-1, 0], right: [1, 0], up: [0, -1], down: [0, 1] }

/** Whether the canvas moved the paper while Space was down; otherwise Space picks. */
let seenAtSpace: unknown

/** True where the key meant something here. */
export function keyDown(event: KeyboardEvent): boolean {
  if (!canvasState.hasKeyboard || canvasState.opened.kind !== '' || event.ctrlKey || event.metaKey) return false
  const way = WAY[event.key]
  if (way) return arrow(way, event)
  if (event.key !== ' ' || event.altKey || event.shiftKey) return false
  if (!canvasState.isSpaceDown) seenAtSpace = canvasState.view.seen
  canvasState.isSpaceDown = true
  return true
}

export function keyUp(event: KeyboardEvent): void {
  if (event.key !== ' ' || !canvasState.isSpaceDown) return
  canvasState.isSpaceDown = false
  if (seenAtSpace !== canvasState.view.seen) return
  const [name, group] = [focusedTask(), focusedGroup()]
  if (name) selectAlsoAll(wholeOf(name), `task:${name}`)
  if (group) selectAlsoAll(membersOf(canvasState.document, group), `group:${group}`)
}

/** Arrows move what is picked; with Alt, or with nothing picked, they walk from one thing to the next. */
function arrow(way: Direction, event: KeyboardEvent): boolean {
  const isPicked = pickedTasks().length > 0 || canvas.pickedLocus !== ''
  if (event.altKey || !isPicked) return walk(way)
  const [x, y] = ALONG[way]
  const by = event.shiftKey ? STRIDE : STEP
  nudge(x * by, y * by)
  return true
}

function walk(way: Direction): boolean {
  const all = things()
  const from = canvasState.rectOf(canvasState.focus)
  const to = from
    ? neighbour(
        from,
        way,
        all.filter((place) => place.id !== canvasState.focus),
      )
    : (all[0]?.id ?? null)
  if (to === null) return all.length > 0
  canvasState.focusOn(to)
  return true
}

function things(): Named[] {
  const { boxes, dots } = canvasState.scene
  return [
    ...[...boxes.values()].map((box) => ({ id: `task:${box.name}`, ...box.rect })),
    ...[...dots.values()].map((dot) => ({ id: `locus:${dot.svar}`, ...dot.rect })),
    ...Object.keys(canvasState.document?.groups ?? {}).flatMap((name) => {
      const rect = canvasState.rectOf(`group:${name}`)
      return rect ? [{ id: `group:${name}`, ...rect }] : []
    }),
  ]
}

/** The task, the variable or the supermodule that the keyboard is on. */
export const focusedTask = (): string => focused('task')
export const focusedLocus = (): string => focused('locus')
export const focusedGroup = (): string => focused('group')

function focused(kind: 'task' | 'locus' | 'group'): string {
  const at = document.activeElement
  return at && canvasState.svg?.contains(at) ? (at.closest<SVGElement>(`[data-${kind}]`)?.dataset[kind] ?? '') : ''
}
