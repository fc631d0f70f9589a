// Who holds what, as the page knows it now; and a clock for what ends by itself.
import { desk, runsIn } from '../link/desk.svelte'
import { stationIn, stationsIn } from '../link/stations'
import type { RuntimeView, SessionView } from '../api.gen'
import { heldIn, meIn, type Held } from './held'

const own = (station: string): string[] =>
  runsIn(desk.now)
    .filter((run) => run.state !== 'over')
    .flatMap((run) => Object.keys(run.flows ?? {}).filter((flow) => stationIn(run, flow) === station))

/** Everything that lives at all stations, those of the first one ahead. */
export const everything = (): Held[] =>
  stationsIn(desk.live).flatMap(([station, runtime]) => heldIn(runtime, desk.live.documents, own(station), station))
export const me = (): string => meIn(desk.live.runtime)
const isMarked = (runtime: RuntimeView, is: (session: SessionView) => boolean): boolean =>
  Object.values(runtime.sessions ?? {}).some((session) => session.is_you && is(session))
/** Whether nothing may be changed at a station. */
export const mayChangeAt = (runtime: RuntimeView): boolean =>
  !isMarked(runtime, (session) => session.only_watches === true || session.role === 'viewer')
export const onlyWatches = (runtime: RuntimeView = desk.live.runtime): boolean =>
  isMarked(runtime, (session) => session.only_watches === true)
export const isViewer = (runtime: RuntimeView = desk.live.runtime): boolean =>
  isMarked(runtime, (session) => session.role === 'viewer')
/** The station that an act names; the first one is not named. */
export const at = (station: string): { station?: string } => (station ? { station } : {})

/** Seconds since 1970, once a second while somebody looks at it. */
export const now: { s: number } = $state({ s: Date.now() / 1000 })

export function tick(): () => void {
  now.s = Date.now() / 1000
  const beat = setInterval(() => (now.s = Date.now() / 1000), 500)
  return () => clearInterval(beat)
}

/** Losses that were put aside, by subsystem and time. */
export const putAside: { keys: string[] } = $state({ keys: [] })
export const keyOf = (held: Held): string => `${held.station}/${held.subsystems[0]}@${held.since}`
