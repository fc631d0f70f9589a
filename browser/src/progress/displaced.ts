// What does not stand where it stood at the start, in the workcells that an application drives.
import type { ApplicationView, RuntimeView } from '../api.gen'
import type { Reason } from '../texts/say'

/** What is not at its place, workcell by workcell; of one that the application does not drive nothing is said. */
export function displaced(runtime: RuntimeView, app: ApplicationView | undefined): Reason[] {
  return worldsOf(runtime, app).flatMap((world) => runtime.displaced?.[world] ?? [])
}

/** Whether all of that can be put back from here: no real workcell is among them. */
export function canBePutBack(runtime: RuntimeView, app: ApplicationView | undefined): boolean {
  const worlds = worldsOf(runtime, app)
  return worlds.length > 0 && worlds.every((world) => runtime.world_kinds?.[world] === 'simulated')
}

function worldsOf(runtime: RuntimeView, app: ApplicationView | undefined): string[] {
  const driven = new Set(Object.values(app?.worlds ?? {}).flat())
  return Object.keys(runtime.displaced ?? {}).filter((world) => driven.has(world))
}
