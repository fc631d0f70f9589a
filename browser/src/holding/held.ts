// Who holds what, as one list: a configuration's subsystem each, an application with all its flows.
import type { AskView, DocumentView, HoldView, RuntimeView, SessionView } from '../api.gen'
import { every, type Reason } from '../texts/say'

export interface Held {
  /** What it is called: the application, else the subsystem. */
  name: string
  subsystems: string[]
  /** Where it lives; empty: at the first station. */
  station: string
  /** Whether an application runs in it. */
  isRun: boolean
  /** Whether it is the run that this environment began. */
  isOwnRun: boolean
  /** The open configuration that is connected with it; empty: none is. */
  doc: string
  /** The session; empty: nobody. */
  holder: string
  isMine: boolean
  /** Seconds since 1970; 0: it was so before this environment came. */
  since: number
  /** Why the holder changed last. */
  cause: Reason | undefined
  /** Who held it and is gone, or fell silent. */
  former: string
  wasHere: boolean
  offeredTo: string
  isOfferedHere: boolean
  offeredUntil: number
  /** Where the flows are, each once. */
  states: string[]
  /** What becomes of a run where its holder is lost. */
  onLoss: string
  /** What its tasks ask, as `SUBSYSTEM/TASK`. */
  asks: Record<string, AskView>
}

type Documents = Record<string, DocumentView>

export const meIn = (runtime: RuntimeView): string =>
  Object.entries(runtime.sessions ?? {}).find(([, session]) => session.is_you)?.[0] ?? ''

/** Everything that lives on a runtime; `own` are the flows of the run of this environment. */
export function heldIn(runtime: RuntimeView, all: Documents, own: readonly string[], station = ''): Held[] {
  const documents = Object.fromEntries(Object.entries(all).filter(([, doc]) => (doc.station ?? '') === station))
  const me = meIn(runtime)
  const rows = new Map<string, Held>()
  for (const [subsystem, hold] of Object.entries(runtime.holds ?? {})) {
    const key = hold.application
      ? `${hold.application}/${hold.holder ?? ''}/${own.includes(subsystem)}`
      : `/${subsystem}`
    const row = rows.get(key)
    if (row) {
      row.subsystems.push(subsystem)
      Object.assign(row.asks, asksIn(subsystem, hold))
      if (hold.state && !row.states.includes(hold.state)) row.states.push(hold.state)
    } else rows.set(key, { ...heldOf(subsystem, hold, documents, own, me), station })
  }
  return [...rows.values()]
}

function heldOf(
  subsystem: string,
  hold: HoldView,
  documents: Documents,
  own: readonly string[],
  me: string,
): Omit<Held, 'station'> {
  const home = Object.entries(documents).find(([, doc]) => doc.connection === 'live' && doc.subsystem === subsystem)
  const holder = hold.holder ?? ''
  return {
    name: hold.application || subsystem,
    subsystems: [subsystem],
    isRun: !!hold.application,
    isOwnRun: own.includes(subsystem),
    doc: home?.[0] ?? '',
    holder,
    isMine: (me !== '' && holder === me) || home?.[1].is_held_here === true,
    since: hold.since_at_s ?? 0,
    cause: hold.cause,
    former: hold.former ?? '',
    wasHere: hold.was_here === true,
    offeredTo: hold.offered_to ?? '',
    isOfferedHere: me !== '' && hold.offered_to === me,
    offeredUntil: hold.offered_until_s ?? 0,
    states: hold.state ? [hold.state] : [],
    onLoss: hold.on_loss ?? '',
    asks: asksIn(subsystem, hold),
  }
}

const asksIn = (subsystem: string, hold: HoldView): Record<string, AskView> =>
  Object.fromEntries(Object.entries(hold.asks ?? {}).map(([task, ask]) => [`${subsystem}/${task}`, ask]))

/** What runs that others began and that are held here ask. */
export const takenAsks = (all: readonly Held[]): Record<string, AskView> =>
  Object.assign({}, ...all.filter((held) => held.isRun && held.isMine && !held.isOwnRun).map((held) => held.asks))

/** What one holds, by name. */
export const heldBy = (all: readonly Held[], session: string): string[] =>
  all.filter((held) => held.holder === session).map((held) => held.name)

/** Why nothing can be handed over to a session; empty: it can. */
export function cannotTake(session: SessionView): '' | 'away' | 'watches' | 'viewer' {
  if (session.is_here === false) return 'away'
  if (session.only_watches) return 'watches'
  return session.role === 'viewer' ? 'viewer' : ''
}

/** A time that is left, as 0:42. */
export function left(until: number, now: number): string {
  const seconds = Math.max(0, Math.ceil(until - now))
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`
}

/** For how long a holder was not heard, in seconds, where that is why it holds nothing any more; empty: it is not. */
export function silence(cause: Reason | undefined): string {
  if (!cause) return ''
  const seconds = every(cause).find((reason) => reason.key === 'host.holder_silent')?.args?.seconds
  return typeof seconds === 'number' ? seconds.toFixed(2) : ''
}
