// For whom robots are booked, asked of their runtimes while somebody looks at it.
import { send } from '../link/link'
import { Refusal } from '../link/refusal'
import { stationsIn, type Station } from '../link/stations'
import { desk } from '../link/desk.svelte'
import { at } from './standing.svelte'

const EACH_S = 10

/** Runtimes elsewhere may keep bookings; one that was started here has nobody else. */
export const shared = (): Station[] =>
  stationsIn(desk.live).filter(([, runtime]) => runtime.state === 'linked' && !!runtime.address)

export async function lookAt(station: string): Promise<void> {
  try {
    await send({ t: 'LookAtBookings', ...at(station) })
  } catch (why) {
    if (!(why instanceof Refusal)) throw why // it was left meanwhile
  }
}

/** Ask now and again, until the returned function is called. */
export function attend(): () => void {
  const ask = () => shared().forEach(([station]) => void lookAt(station))
  ask()
  const beat = setInterval(ask, EACH_S * 1000)
  return () => clearInterval(beat)
}

/** Announced ends that were put aside. */
export const seen: { ends: string[] } = $state({ ends: [] })
