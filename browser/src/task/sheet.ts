// What the sheet of a task says, computed from the tree.
import type { DocumentView, PinView, TaskView } from '../api.gen'
import { isInput } from '../scene/pin'

/** What a pin means for the others of a configuration. */
export interface Ties {
  readers: string[]
  writers: string[]
}

export function ties(doc: DocumentView | undefined, task: string, pin: PinView): Ties {
  const locus = doc?.loci?.[pin.svar]
  const others = (names: readonly string[] | undefined): string[] => (names ?? []).filter((name) => name !== task)
  return { readers: others(locus?.readers), writers: others(locus?.writers) }
}

export const reads = (task: TaskView): PinView[] => task.pins.filter((pin) => isInput(pin))
export const writes = (task: TaskView): PinView[] => task.pins.filter((pin) => !isInput(pin))

/** In how many of the open configurations a task stands. */
export const timesPlaced = (documents: Readonly<Record<string, DocumentView>>, name: string): number =>
  Object.values(documents).filter((doc) => doc.tasks?.[name]).length

/** A rate as it was typed: `500`, `500 Hz`, `2 ms`, `40 us`; NaN where it is none. */
export function hertz(text: string): number {
  const match = /^\s*(\d+(?:[.,]\d+)?)\s*(hz|ms|us|µs|s)?\s*$/i.exec(text)
  if (!match) return NaN
  const number = Number(match[1]!.replace(',', '.'))
  const unit = (match[2] ?? 'hz').toLowerCase()
  if (unit === 'hz') return number
  return (unit === 's' ? 1 : unit === 'ms' ? 1e3 : 1e6) / number
}

/** The words of a LOCAL line, as the file has them. */
export const words = (text: string): string[] => text.split(/\s+/).filter(Boolean)
