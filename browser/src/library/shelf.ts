// How the icons of a library stand on their shelf: rows of cells of known height, so that only what is seen is drawn.
import type { LibraryView, Objection, TaskView } from '../api.gen'
import { say } from '../texts/say'
import { walked } from '../geom/rows'
import { isInput, shape, type Shape } from '../scene/pin'

export { seen } from '../geom/rows'

export const CELL = { width: 108, gap: 4, icon: 96, line: 12.5, head: 24 }
const ICON = { least: 38, margin: 12, pin: 8, frame: 2 }
const LETTERS_A_LINE = 19
const MOST_LINES = 2
const ROW_GAP = 8

export interface Cell {
  task: TaskView
  /** Why it may not be placed, in a line or two; empty: it may. */
  why: string
  lines: number
  height: number
}

export interface Row {
  key: string
  top: number
  height: number
  cells: Cell[]
  /** Of a row that only names a library. */
  title?: string
}

export interface Shelf {
  rows: Row[]
  height: number
}

export const sides = (task: TaskView): [Shape[], Shape[]] => [
  task.pins.filter((pin) => isInput(pin)).map(shape),
  task.pins.filter((pin) => !isInput(pin)).map(shape),
]

export function iconHeight(task: TaskView): number {
  const [ins, outs] = sides(task)
  return Math.max(ICON.least, ICON.margin + Math.max(ins.length, outs.length, 1) * ICON.pin)
}

function cellOf(task: TaskView, reasons: readonly Objection[] | undefined): Cell {
  const why = say(reasons?.[0]?.text)
  const lines = Math.min(MOST_LINES, Math.ceil(why.length / LETTERS_A_LINE))
  return { task, why, lines, height: iconHeight(task) + ICON.frame + lines * CELL.line }
}

export const columnsIn = (width: number): number =>
  Math.max(1, Math.floor((width + CELL.gap) / (CELL.width + CELL.gap)))

/** Groups of tasks, each with the title of its library or none, on a shelf of so many columns. */
export function shelve(
  groups: readonly [string, readonly TaskView[]][],
  columns: number,
  greyed: Readonly<Record<string, Objection[]>>,
): Shelf {
  const rows: Row[] = []
  let top = 0
  const add = (row: Omit<Row, 'top'>): void => {
    rows.push({ ...row, top })
    top += row.height
  }
  for (const [title, tasks] of groups) {
    if (title) add({ key: `library ${title}`, height: CELL.head, cells: [], title })
    for (let k = 0; k < tasks.length; k += columns) {
      const cells = tasks.slice(k, k + columns).map((task) => cellOf(task, greyed[task.name]))
      add({ key: cells[0]!.task.name, height: Math.max(...cells.map((cell) => cell.height)) + ROW_GAP, cells })
    }
  }
  return { rows, height: top }
}

/** The task beside one, as the arrow keys go. */
export const beside = (rows: readonly Row[], name: string, key: string): string | undefined =>
  walked(
    rows.filter((row) => row.cells.length).map((row) => row.cells.map((cell) => cell.task.name)),
    name,
    key,
  )

export const byOrder = (a: { order: number }, b: { order: number }): number => a.order - b.order

/** As a user has arranged them, those that are not arranged behind. */
function byPlace(arranged: readonly string[]): (a: TaskView, b: TaskView) => number {
  const places = new Map(arranged.map((name, place) => [name, place]))
  const placeOf = (task: TaskView): number => places.get(task.name) ?? arranged.length
  return (a, b) => placeOf(a) - placeOf(b) || byOrder(a, b)
}

/** What is on the shelf, of libraries by their keys: one library; or, where words are wanted, all that has them, library by library. */
export function choose(
  tasks: Readonly<Record<string, TaskView>>,
  libraries: readonly (readonly [string, LibraryView])[],
  library: string,
  wanted: string,
): [string, TaskView[]][] {
  const words = wanted.trim().toLowerCase().split(/\s+/).filter(Boolean)
  const all = Object.values(tasks)
  if (!words.length) {
    const arranged = libraries.find(([key]) => key === library)?.[1].arranged ?? []
    return [['', all.filter((task) => task.library === library).sort(byPlace(arranged))]]
  }
  const fits = (task: TaskView): boolean => {
    const text =
      `${task.name} ${task.module} ${task.description} ${task.pins.map((pin) => pin.svar).join(' ')}`.toLowerCase()
    return words.every((word) => text.includes(word))
  }
  const first = (task: TaskView): number =>
    task.name.toLowerCase().startsWith(words[0]!) ? 0 : task.name.toLowerCase().includes(words[0]!) ? 1 : 2
  return libraries
    .map(([key, library]): [string, TaskView[]] => [
      library.name,
      all.filter((task) => task.library === key && fits(task)).sort((a, b) => first(a) - first(b) || byOrder(a, b)),
    ])
    .filter(([, tasks]) => tasks.length > 0)
}
