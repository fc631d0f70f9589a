// What the tables and plots beneath show: an open configuration, or a subsystem in which an application runs.
import type { LivingTaskView, LocusView, PlacedView, SubsystemView, TaskView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { inside, intoOf, subsystemOf } from '../progress/inside'
import { canvas } from '../state/canvas.svelte'
import { look } from '../state/look.svelte'

export type TaskOfSubject = Pick<PlacedView, 'state' | 'rtpu' | 'hz'> | LivingTaskView

export interface Subject {
  id: string
  name: string
  /** What runs in it; empty: an open configuration. */
  application: string
  tasks: Record<string, TaskOfSubject>
  loci: Record<string, Pick<LocusView, 'line' | 'is_constant' | 'writers' | 'readers'>>
  own?: Record<string, TaskView>
  isLive: boolean
}

/** What is meant by an id: a document's, or `@SUBSYSTEM`. */
export function subjectOf(id: string): Subject | undefined {
  const document = desk.tree.documents[id]
  if (document)
    return {
      id,
      name: document.name,
      application: '',
      tasks: document.tasks ?? {},
      loci: document.loci ?? {},
      own: document.own ?? {},
      isLive: (document.connection ?? 'none') !== 'none',
    }
  const subsystem = inside()[id.slice(1)]
  return subsystem && id.startsWith('@') ? within(id, subsystem) : undefined
}

function within(id: string, subsystem: SubsystemView): Subject {
  const tasks = subsystem.tasks ?? {}
  const line = (writers: readonly string[]): LocusView['line'] => {
    const states = writers.map((name) => tasks[name]?.state)
    return states.includes('ON') ? 'live' : states.includes('ERROR') ? 'stale' : 'idle'
  }
  const loci = Object.entries(subsystem.variables ?? {}).map(
    ([name, variable]) => [name, { ...variable, line: line(variable.writers ?? []) }] as const,
  )
  return {
    id,
    name: id.slice(1),
    application: subsystem.application,
    tasks,
    loci: Object.fromEntries(loci),
    isLive: true,
  }
}

/** The subsystems of running applications, by their ids, those of one application together. */
export const withinRuns = (): [string, SubsystemView][] =>
  Object.entries(inside())
    .map(([name, view]): [string, SubsystemView] => [intoOf(name), view])
    .sort(([a, one], [b, other]) => one.application.localeCompare(other.application) || a.localeCompare(b))

/** The id of what is shown: the one that was chosen, as long as it is there; else a flow of the run that is looked at. */
export function shownSubject(): string {
  if (canvas.subject && subjectOf(canvas.subject)) return canvas.subject
  if (look.level === 'tasks') return canvas.doc
  const runs = withinRuns()
  const ours = runs.find(([id]) => subsystemOf(id) in (desk.tree.run?.flows ?? {}))
  return (ours ?? runs[0])?.[0] ?? canvas.doc
}
