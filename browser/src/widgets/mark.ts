// The mark of a state: the second channel beside its colour.
import type { PlacedView } from '../api.gen'

export type State = NonNullable<PlacedView['state']>

const HOURGLASS = 'M-3.4 -4.2H3.4L-3.4 4.2H3.4Z'

/** Outlines about the middle of the mark. */
export const MARK: Record<Exclude<State, ''>, string> = {
  ON: 'M-3.2 -4.2L4.2 0L-3.2 4.2Z',
  OFF: 'M0 -3.6A3.6 3.6 0 1 0 .01 -3.6Z',
  ASKING: 'M-2.6 -1.8C-2.6 -5.4 2.8 -5.4 2.6 -1.8C2.4 0 0 -.2 0 2M0 4.2V4.5',
  WAITING: HOURGLASS,
  SPAWNING: HOURGLASS,
  KILLING: HOURGLASS,
  ERROR: 'M-3.4 -3.4L3.4 3.4M3.4 -3.4L-3.4 3.4',
}

/** Play and hourglass are filled, the others drawn with the pen. */
export const isSolid = (state: State): boolean => state === 'ON' || looks(state) === 'WAITING'

/** The state whose colours and border are used: a task that comes or goes waits. */
export const looks = (state: State): State => (state === 'SPAWNING' || state === 'KILLING' ? 'WAITING' : state)
