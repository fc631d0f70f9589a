// Where what follows from a fault stands on its small line of time: to scale where its words have room so.
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
export type Kind = 'fault' | 'first' | 'drive' | 'told'

/** The line; not to scale, it shows early things apart and late ones still. */
export interface Line {
  instants: Instant[]
  isToScale: boolean
}

/** What each instant means: the fault, the first change, the last drive that changed, and that all is told. */
export function instantsOf(effects: readonly Happening[], width: number, apart: number): Line {
  const kindsAt = new Map<number, Kind[]>([[0, ['fault']]])
  const put = (times: number[], kind: Kind, choose: (...values: number[]) => number): void => {
    if (!times.length) return
    const ms = choose(...times)
    kindsAt.set(ms, [...(kindsAt.get(ms) ?? []), kind])
  }
  const times = (chosen: readonly Happening[]): number[] => chosen.map((effect) => effect.within_ms)
  put(times(effects.filter((effect) => effect.kind === 'drive')), 'drive', Math.max)
  put(times(effects.filter((effect) => effect.is_told)), 'told', Math.max)
  const first = Math.min(...times(effects))
  if (effects.length && !kindsAt.has(first)) put([first], 'first', Math.min) // else its own word says more
  const instants = [...kindsAt.entries()].sort(([a], [b]) => a - b)
  const moments = instants.map(([ms]) => ms)
  const places = spread(moments, width, apart)
  return {
    instants: instants.map(([ms, kinds], k) => ({ ms, x: places[k] ?? 0, kinds })),
    isToScale: hasRoom(moments, width, apart),
  }
}

/** Whether places to scale are nowhere nearer than `apart`. */
function hasRoom(times: readonly number[], width: number, apart: number): boolean {
  const scale = width / (times.at(-1) || 1)
  return times.slice(1).every((ms, k) => (ms - (times[k] ?? 0)) * scale >= apart)
}

/** Places on a line in the order of the times: to scale, or, where that is too narrow, further apart the later. */
export function spread(times: readonly number[], width: number, apart: number): number[] {
  const last = times.at(-1) ?? 0
  if (hasRoom(times, width, apart)) return times.map((ms) => (last > 0 ? (width * ms) / last : 0))
  const longest = Math.log1p(last)
  const free = Math.max(0, width - apart * (times.length - 1))
  return times.map((ms, k) => k * apart + (free * Math.log1p(ms)) / longest)
}

/** The last of each task's states, for a list of which tasks go where: by state, in the order in which they get there. */
export function byState(effects: readonly (Happening & { subject: string })[]): [string, string[]][] {
  const last = new Map<string, string>()
  for (const effect of effects) if (effect.kind === 'task') last.set(effect.subject, effect.after)
  const groups = new Map<string, string[]>()
  for (const [task, state] of last) groups.set(state, [...(groups.get(state) ?? []), task])
  return [...groups]
}
