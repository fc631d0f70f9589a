// What lives inside running applications, and how its tasks and the icons of the application lead to each other.
import type { RunView, SubsystemView } from '../api.gen'
import { desk, runsIn } from '../link/desk.svelte'
import { stationIn, stationsIn } from '../link/stations'

const INTO = '@'
/** Ahead of others in a table of what needs a look. */
const WORKING = ['ERROR', 'ASKING', 'WAITING', 'ON']

const BEHIND = '@'

/** By subsystem; one of another station than the first has the name of that behind it: `flow0@cmu`. */
export const inside = (): Record<string, SubsystemView> =>
  Object.fromEntries(
    stationsIn(desk.tree).flatMap(([station, runtime]) =>
      Object.entries(runtime.inside ?? {}).map(([name, view]) => [station ? name + BEHIND + station : name, view]),
    ),
  )

/** A flow of a run, as its subsystem is named beside those of other stations. */
export function placedIn(run: RunView, flow: string): string {
  const station = stationIn(run, flow)
  return station ? flow + BEHIND + station : flow
}

const bare = (subsystem: string): string => subsystem.split(BEHIND)[0]!
const stationOf = (subsystem: string): string => subsystem.split(BEHIND)[1] ?? ''

/** By which id a subsystem of a running application is watched and shown. */
export const intoOf = (subsystem: string): string => INTO + subsystem
export const subsystemOf = (id: string): string => (id.startsWith(INTO) ? id.slice(INTO.length) : '')

/** The run that goes on in a subsystem, of all that go on side by side; where none is named, the one that is shown. */
export const runIn = (subsystem = ''): RunView | undefined =>
  runsIn(desk.tree).find(
    (run) => bare(subsystem) in (run.flows ?? {}) && stationIn(run, bare(subsystem)) === stationOf(subsystem),
  ) ??
  desk.tree.run ??
  undefined

const stepsByTask = (subsystem = ''): Readonly<Record<string, readonly number[]>> =>
  desk.tree.review?.recording.steps_by_task ?? runIn(subsystem)?.steps_by_task ?? {}

/** The step of the application whose icon a task belongs to: the one that is carried out, else its first one; 0: none. */
export function stepOf(subsystem: string, task: string): number {
  const steps = stepsByTask(subsystem)[`${bare(subsystem)}/${task}`] ?? []
  const now = runIn(subsystem)?.flows?.[bare(subsystem)]?.step ?? 0
  return steps.includes(now) ? now : (steps[0] ?? 0)
}

/** The subsystem in which a step of the application that runs is carried out, or would be; empty: in none. */
export function subsystemAt(step: number): string {
  const run = desk.tree.run
  const now = Object.entries(run?.flows ?? {}).find(([, flow]) => flow.step === step)?.[0]
  if (run && now && placedIn(run, now) in inside()) return placedIn(run, now)
  const address = Object.entries(stepsByTask()).find(([, steps]) => steps.includes(step))?.[0] ?? ''
  const flow = address.slice(0, address.lastIndexOf('/'))
  const subsystem = run ? placedIn(run, flow) : flow
  return subsystem in inside() ? subsystem : ''
}

/** The task that works now: of the present action, first one that stands still, then the trigger; empty: none does. */
export function worksNow(subsystem: string): string {
  const tasks = inside()[subsystem]?.tasks ?? {}
  const now = runIn(subsystem)?.flows?.[bare(subsystem)]?.step ?? 0
  const steps = stepsByTask(subsystem)
  const rank = (name: string): number => {
    const state = WORKING.indexOf(tasks[name]?.state ?? '')
    const isOfNow = (steps[`${bare(subsystem)}/${name}`] ?? []).includes(now)
    return (isOfNow ? 0 : 100) + state * 10 + (desk.tree.tasks[name]?.is_trigger ? 0 : 1)
  }
  const working = Object.keys(tasks).filter((name) => WORKING.includes(tasks[name]?.state ?? ''))
  return working.sort((a, b) => rank(a) - rank(b))[0] ?? ''
}
