// The time of the run, ten times a second while it goes on; and all that has happened in it since this page came.
import { untrack } from 'svelte'
import { announce } from '../state/announce'
import type { RunView } from '../api.gen'
import { desk, runsIn } from '../link/desk.svelte'
import { runtimeFor } from '../link/stations'
import { isReviewing, review } from '../recording/review.svelte'
import { RunClock } from '../progress/clock'
import { t } from '../texts/index.svelte'
import { Past } from '../progress/past'
import { isSimulator } from '../progress/recording'
import { newFlowStates } from '../progress/newFlowStates'
import { flowName } from '../sentences/words'

const TICK_MS = 100
/** Of every run by its number: several go on side by side. */
const clocks = new Map<number, RunClock>()
const lasts = new Map<number, RunView>()
const NOTHING = new Past()

const live: { now_s: number; pasts: Record<number, Past> } = $state({ now_s: 0, pasts: {} })

/** The time of the run that is shown, which may be a recorded one. */
export const runTime = {
  get now_s(): number {
    return isReviewing() ? review.shown_s : live.now_s
  },
  get past(): Past {
    return isReviewing() ? review.past : (live.pasts[desk.live.run?.number ?? 0] ?? NOTHING)
  },
}

const now_s = (): number =>
  clocks
    .get(desk.live.run?.number ?? 0)
    ?.at(performance.now() / 1000, runtimeFor(desk.live).is_virtual === true && !isSimulator(runtimeFor(desk.live))) ??
  0

/** What a run says now. */
function take(run: RunView): void {
  const before = lasts.get(run.number)
  lasts.set(run.number, run)
  const clock = clocks.get(run.number) ?? new RunClock()
  clocks.set(run.number, clock)
  clock.take(run, performance.now() / 1000, Date.now() / 1000)
  live.pasts[run.number] = (live.pasts[run.number] ?? NOTHING).with(run, desk.now.applications[run.doc])
  if (run.state !== 'running' || isReviewing()) return
  for (const flow of newFlowStates(before, run))
    announce(`${flowName(flow.order)}: ${t(`perform.state.${flow.state}` as 'perform.state.paused')}`)
}

function forget(present: ReadonlySet<number>): void {
  for (const number of [...clocks.keys()].filter((number) => !present.has(number))) {
    clocks.delete(number)
    lasts.delete(number)
    delete live.pasts[number]
  }
}

// It listens as long as the page is there, also while the run is not looked at.
$effect.root(() => {
  $effect(() => {
    const runs = runsIn(desk.now)
    for (const run of runs) void desk.now.applications[run.doc]
    const whole = $state.snapshot(runs) as RunView[]
    void desk.live.run // another one is looked at
    untrack(() => {
      for (const run of whole) take(run)
      forget(new Set(whole.map((run) => run.number)))
      live.now_s = now_s()
    })
  })
  $effect(() => {
    if (!desk.live.run || desk.live.run.state === 'over') return
    const beat = setInterval(() => (live.now_s = now_s()), TICK_MS)
    return () => clearInterval(beat)
  })
})
