// What a user says to a run, as lines of steering.
import { act } from '../act/act'
import type { FlowRunView, RunView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { runtimeFor, stationFor } from '../link/stations'
import { beginsAfresh } from '../progress/displaced'
import { isSimulator } from '../progress/recording'
import { options } from '../state/options.svelte'

/** Whether there is a run that can be steered: what a recording shows cannot. */
export const isGoing = (): boolean => !desk.live.review && desk.live.run != null && desk.live.run.state !== 'over'
export const flowsOf = (run: RunView | null | undefined): string[] =>
  Object.entries(run?.flows ?? {})
    .filter(([, flow]) => !flow.is_nested)
    .sort(([, flow], [, other]) => flow.order - other.order)
    .map(([name]) => name)

/** Whether some flow goes on, so that a pause would do something. */
export function canPause(run: RunView | null | undefined): boolean {
  return Object.values(run?.flows ?? {}).some(
    (flow) => !isHeld(flow.state ?? '') && !flow.is_pausing && !isEnded(flow.state ?? ''),
  )
}

/** Where a flow is; what says nothing has not begun. */
export const stateOf = (flow: FlowRunView | undefined): NonNullable<FlowRunView['state']> => flow?.state ?? 'ready'

export const isHeld = (state: string): boolean => state === 'paused' || state === 'stopped'
export const isEnded = (state: string): boolean => ['done', 'killing', 'ended'].includes(state)

export const start = (doc: string, putsBack = false, endsFormer = false): Promise<unknown> =>
  act({
    t: 'Run',
    doc,
    ...(putsBack ? { puts_back: true } : {}),
    ...(endsFormer ? { ends_former: true } : {}),
    passes_breakpoints: options.passesBreakpoints,
    is_recorded: options.records,
    on_loss: runtimeFor(desk.live).address ? options.onLoss : 'stop',
  })
/** Begin where the flows of the last run ended, with whoever stands for whom now. */
export const goOn = (doc: string): Promise<unknown> =>
  act({ t: 'Run', doc, goes_on: true, is_recorded: options.records, passes_breakpoints: options.passesBreakpoints })
/** The application whose run is shown: what is steered is what is seen. */
const shownDoc = (): string => desk.live.run?.doc ?? ''

export const steer = (verb: string, flow = '', doc = shownDoc()): Promise<unknown> =>
  act({ t: 'Steer', line: flow ? `${verb} ${flow}` : verb, doc })
export const dismiss = (): Promise<unknown> => act({ t: 'Dismiss', doc: shownDoc() })
/** Everything to where it stood at the start, in the same runtime; a simulator of a recorded run is left. */
export const putBack = (): Promise<unknown> =>
  isSimulator(runtimeFor(desk.live)) ? startAnew() : act({ t: 'PutBack', station: stationFor(desk.live) })
export const startAnew = (): Promise<unknown> => act({ t: 'StartAnew' })
/** Begin as the black button says: where something has left its place it is put back first. */
export const startAfresh = (doc: string): Promise<unknown> =>
  start(doc, beginsAfresh(runtimeFor(desk.live), desk.live.applications[doc]))

/** End the run that stands, put everything back and begin anew. */
export const startOver = (doc: string): Promise<unknown> => start(doc, true, true)

/** Pause what goes on; where all stand still, go on. */
export const pauseOrContinue = (): Promise<unknown> => steer(canPause(desk.live.run) ? 'pause' : 'continue')
