// What does not stand where it stood at the start, in the workcells that an application drives.
import type { ApplicationView, RuntimeView } from '../api.gen'
import type { Reason } from '../texts/say'

/** What is not at its place, workcell by workcell; of one that the application does not drive nothing is said. */
export function displaced(runtime: RuntimeView, app: ApplicationView | undefined): Reason[] {
  return ofDriven(runtime.displaced, app)
}

/** What stands elsewhere and does no harm there, as an arm where a run left it; only a forecast assumes otherwise. */
export function moved(runtime: RuntimeView, app: ApplicationView | undefined): Reason[] {
  return ofDriven(runtime.moved, app)
}

/** Whether all that is not at its place can be put back from here: no real workcell is among them. */
export function canBePutBack(runtime: RuntimeView, app: ApplicationView | undefined): boolean {
  const worlds = driven(runtime.displaced, app)
  return worlds.length > 0 && worlds.every((world) => runtime.world_kinds?.[world] === 'simulated')
}

/** Whether all that an application drives is simulated, so that everything can be put back from here. */
export function isAllSimulated(runtime: RuntimeView, app: ApplicationView | undefined): boolean {
  const worlds = Object.values(app?.worlds ?? {}).flat()
  return worlds.length > 0 && worlds.every((world) => runtime.world_kinds?.[world] === 'simulated')
}

type ByWorld = RuntimeView['displaced']

const ofDriven = (things: ByWorld, app: ApplicationView | undefined): Reason[] =>
  driven(things, app).flatMap((world) => things?.[world] ?? [])

function driven(things: ByWorld, app: ApplicationView | undefined): string[] {
  const worlds = new Set(Object.values(app?.worlds ?? {}).flat())
  return Object.keys(things ?? {}).filter((world) => worlds.has(world))
}

/** Whether a run puts everything back first: something has left its place, or a puzzle wants it from the start. */
export const beginsAfresh = (runtime: RuntimeView, app: ApplicationView | undefined): boolean =>
  !!app?.puzzle || canBePutBack(runtime, app)
