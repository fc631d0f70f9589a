// Who holds what, as the page knows it now; and a clock for what ends by itself.
import { desk, runsIn } from '../link/desk.svelte'
import { heldIn, meIn, type Held } from './held'

const own = (): string[] =>
  runsIn(desk.now)
    .filter((run) => run.state !== 'over')
    .flatMap((run) => Object.keys(run.flows ?? {}))

export const everything = (): Held[] => heldIn(desk.live.runtime, desk.live.documents, own())
export const me = (): string => meIn(desk.live.runtime)
export const onlyWatches = (): boolean =>
  Object.values(desk.live.runtime.sessions ?? {}).some((session) => session.is_you && session.only_watches)
export const isViewer = (): boolean =>
  Object.values(desk.live.runtime.sessions ?? {}).some((session) => session.is_you && session.role === 'viewer')

/** Seconds since 1970, once a second while somebody looks at it. */
export const now: { s: number } = $state({ s: Date.now() / 1000 })

export function tick(): () => void {
  now.s = Date.now() / 1000
  const beat = setInterval(() => (now.s = Date.now() / 1000), 500)
  return () => clearInterval(beat)
}

/** Losses that were put aside, by subsystem and time. */
export const putAside: { keys: string[] } = $state({ keys: [] })
export const keyOf = (held: Held): string => `${held.subsystems[0]}@${held.since}`
