// Where what follows from a fault stands on its small line of time: early things are told apart, late ones still fit.
export interface Happening {
  within_ms: number
  kind: string
  after: string
  is_told?: boolean
}

/** One instant of the line: its ms, where it stands, and what comes there. */
export interface Instant {
  ms: number
  x: number
  kinds: Kind[]
}
export type Kind = 'fault' | 'noticed' | 'drive' | 'told'

/** What each instant means: the fault, the first change, the last drive that changed, and that all is told. */
export function instantsOf(effects: readonly Happening[], width: number, apart: number): Instant[] {
  const kindsAt = new Map<number, Kind[]>([[0, ['fault']]])
  const put = (ms: number | undefined, kind: Kind): void => {
    if (ms !== undefined) kindsAt.set(ms, [...(kindsAt.get(ms) ?? []), kind])
  }
  const times = (chosen: readonly Happening[]): number[] => chosen.map((effect) => effect.within_ms)
  const drives = times(effects.filter((effect) => effect.kind === 'drive'))
  const told = times(effects.filter((effect) => effect.is_told))
  put(effects.length ? Math.min(...times(effects)) : undefined, 'noticed')
  put(drives.length ? Math.max(...drives) : undefined, 'drive')
  put(told.length ? Math.max(...told) : undefined, 'told')
  const instants = [...kindsAt.entries()].sort(([a], [b]) => a - b)
  const places = spread(
    instants.map(([ms]) => ms),
    width,
    apart,
  )
  return instants.map(([ms, kinds], k) => ({ ms, x: places[k] ?? 0, kinds }))
}

/** Places on a line, in the order of the times and further apart the later, but never nearer than `apart`. */
export function spread(times: readonly number[], width: number, apart: number): number[] {
  const last = times.length - 1
  const longest = Math.log1p(times[last] ?? 0)
  const free = Math.max(0, width - apart * last)
  return times.map((ms, k) => k * apart + (longest > 0 ? (free * Math.log1p(ms)) / longest : 0))
}

/** The last of each task's states, for a list of which tasks go where: by state, in the order in which they get there. */
export function byState(effects: readonly (Happening & { subject: string })[]): [string, string[]][] {
  const last = new Map<string, string>()
  for (const effect of effects) if (effect.kind === 'task') last.set(effect.subject, effect.after)
  const groups = new Map<string, string[]>()
  for (const [task, state] of last) groups.set(state, [...(groups.get(state) ?? []), task])
  return [...groups]
}
