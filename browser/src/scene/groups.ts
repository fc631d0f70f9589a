// Supermodules: tasks that are handled as one (C17). What a page must know of them, read out of the document.
import type { DocumentView, LocusView, PlacedView } from '../api.gen'
import type { Rect } from '../geom/rect'
import { looks, type State } from '../widgets/mark'

/** How far the frame stands outside of its boxes. */
export const PAD = 12
/** The height of the tab that carries the name: enough for a finger. */
export const TAB = 24

type Doc = Pick<DocumentView, 'groups' | 'tasks' | 'loci'>

/** The supermodule that a task belongs to; empty: none. */
export function groupOf(doc: Doc | undefined, task: string): string {
  return Object.entries(doc?.groups ?? {}).find(([, group]) => group.tasks.includes(task))?.[0] ?? ''
}

/** Its tasks in their order. */
export const membersOf = (doc: Doc | undefined, group: string): string[] => [...(doc?.groups?.[group]?.tasks ?? [])]

/** These tasks, each with all that are handled as one with it. */
export function whole(doc: Doc | undefined, tasks: Iterable<string>): string[] {
  const all = new Set<string>()
  for (const task of tasks) {
    const group = groupOf(doc, task)
    for (const member of group ? membersOf(doc, group) : [task]) all.add(member)
  }
  return [...all]
}

/** The supermodules all of whose tasks are among these. */
export function groupsIn(doc: Doc | undefined, tasks: Iterable<string>): string[] {
  const among = new Set(tasks)
  const groups = Object.entries(doc?.groups ?? {})
  return groups
    .filter(([, { tasks: members }]) => members.length > 0 && members.every((member) => among.has(member)))
    .map(([name]) => name)
}

/** Variables that nobody outside of a supermodule speaks or listens to: their dots go where it goes. */
export function ownLoci(doc: Doc | undefined, group: string): string[] {
  const members = new Set(membersOf(doc, group))
  const isOwn = ({ writers = [], readers = [] }: LocusView): boolean =>
    writers.length + readers.length > 0 && [...writers, ...readers].every((end) => members.has(end))
  return Object.entries(doc?.loci ?? {})
    .filter(([, locus]) => isOwn(locus))
    .map(([svar]) => svar)
}

/** The dots that go where these tasks go. */
export const lociWith = (doc: Doc | undefined, tasks: Iterable<string>): string[] =>
  groupsIn(doc, tasks).flatMap((group) => ownLoci(doc, group))

/** How a supermodule is, in one mark: what asks for somebody first, then whether all are ON, some, or none. */
export interface Summary {
  look: State | 'PARTLY'
  on: number
  of: number
}

export function summary(doc: Doc | undefined, group: string): Summary {
  const states = membersOf(doc, group).map((member) => stateOf(doc?.tasks?.[member]))
  const on = states.filter((state) => state === 'ON').length
  const urgent = (['ERROR', 'ASKING', 'WAITING'] as const).find((state) => states.includes(state))
  const look =
    urgent ?? (on === 0 ? (states.find((state) => state !== '') ?? '') : on === states.length ? 'ON' : 'PARTLY')
  return { look, on, of: states.length }
}

const stateOf = (placed: PlacedView | undefined): State => looks(placed?.state ?? '')

export const isAllOn = (doc: Doc | undefined, group: string): boolean =>
  summary(doc, group).on === membersOf(doc, group).length

/** The frame around boxes that together span this. */
export const frameOf = ({ x, y, w, h }: Rect): Rect => ({ x: x - PAD, y: y - PAD, w: w + 2 * PAD, h: h + 2 * PAD })

/** A name that nobody has yet, to begin with. */
export function freeName(word: string, taken: Iterable<string>): string {
  const names = new Set(taken)
  let k = 1
  while (names.has(`${word}${k}`)) k += 1
  return `${word}${k}`
}

/** A list with one of its members a place earlier. */
export function earlier(tasks: readonly string[], at: number): string[] {
  if (at < 1 || at >= tasks.length) return [...tasks]
  return [...tasks.slice(0, at - 1), tasks[at]!, tasks[at - 1]!, ...tasks.slice(at + 1)]
}
