// Finding a task to place: by its name first, then by what it is about; those that may not be placed come last.
import type { DocumentView, TaskView } from '../api.gen'
import { isInput } from '../scene/pin'
import { say } from '../texts/say'

export interface Found {
  task: TaskView
  /** Why it may not be placed; empty: it may. */
  why: string
}

const MOST = 40

export function find(
  words: string,
  tasks: Readonly<Record<string, TaskView>>,
  document: DocumentView | undefined,
): Found[] {
  const wanted = words.trim().toLowerCase()
  const ranked = Object.values(tasks).flatMap((task) => {
    const rank = rankOf(task, wanted)
    return rank < 0 ? [] : [{ task, why: say(document?.greyed?.[task.name]?.[0]?.text), rank }]
  })
  ranked.sort(
    (a, b) => Number(a.why !== '') - Number(b.why !== '') || a.rank - b.rank || (a.task.name < b.task.name ? -1 : 1),
  )
  return ranked.slice(0, MOST)
}

/** Less is nearer to what was typed; below nothing: not meant. */
function rankOf({ name, description, pins }: TaskView, wanted: string): number {
  if (!wanted) return 0
  const at = name.toLowerCase().indexOf(wanted)
  if (at >= 0) return at === 0 ? 0 : 1
  if (pins.some((pin) => pin.svar.toLowerCase().startsWith(wanted))) return 2
  return description.toLowerCase().includes(wanted) ? 3 : -1
}

/** What would connect, were it placed: the variables it would read and from whom, and those it would write. */
export interface Joins {
  reads: string[]
  from: string[]
  writes: string[]
}

export function joins(task: TaskView, document: DocumentView | undefined): Joins {
  const writersOf = (svar: string): readonly string[] => document?.loci?.[svar]?.writers ?? []
  const supplied = task.pins.filter((pin) => isInput(pin) && writersOf(pin.svar).length)
  return {
    reads: supplied.map((pin) => pin.svar),
    from: [...new Set(supplied.flatMap((pin) => writersOf(pin.svar)))],
    writes: task.pins.filter((pin) => !isInput(pin)).map((pin) => pin.svar),
  }
}
