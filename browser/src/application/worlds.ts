// Which world a flow drives, real or simulated, and what could stand for it (E09).
import type { ApplicationView, RunView, RuntimeView } from '../api.gen'
import { t } from '../texts/index.svelte'

/** What is known of a world; a copy is as the world that it is made of. */
export const kindOf = (world: string, { world_kinds = {} }: RuntimeView): 'simulated' | 'real' | undefined =>
  world_kinds[world] ?? world_kinds[world.split('@')[0]!]

/** A world with what is known of it: `boxes · simulated`. */
export function worldText(world: string, runtime: RuntimeView): string {
  const kind = kindOf(world, runtime)
  if (!kind) return world
  return t(kind === 'real' ? 'world.real' : 'world.simulated', { world })
}

/** Whether there is anything to tell apart: several worlds, or a real one. */
function isApart(worlds: readonly string[], runtime: RuntimeView): boolean {
  return new Set(worlds).size > 1 || worlds.some((world) => kindOf(world, runtime) === 'real')
}

/** The worlds that a flow of an application drives, by its subsystem; none where all are in one that is simulated. */
export function toldWorlds(app: ApplicationView | undefined, home: string, runtime: RuntimeView): readonly string[] {
  const worlds = app?.worlds ?? {}
  return isApart(Object.values(worlds).flat(), runtime) ? (worlds[home] ?? []) : []
}

/** Those that a flow of a run drives; none where all are in one that is simulated. */
export function drivenWorlds(run: RunView, home: string, runtime: RuntimeView): readonly string[] {
  const flows = run.flows ?? {}
  const every = Object.values(flows).flatMap((flow) => flow.worlds ?? [])
  return isApart(every, runtime) ? (flows[home]?.worlds ?? []) : []
}

/** The worlds that could stand for one in a flow, or in all: what the runtime has, and a copy of a simulated one. */
export function worldChoices(world: string, taken: string, flow: string, runtime: RuntimeView): string[] {
  const kinds = runtime.world_kinds ?? {}
  const others = Object.keys(kinds).filter((name) => !name.includes('@'))
  const copy = kindOf(world, runtime) === 'simulated' ? [`${world.split('@')[0]}@${flow || 'copy'}`] : []
  return [...new Set([...others.sort(), ...copy, taken])].filter((name) => name && name !== world)
}
