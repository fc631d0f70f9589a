// The time of the run, ten times a second while it goes on; and all that has happened in it since this page came.
import { untrack } from 'svelte'
import { announce } from '../state/announce'
import type { RunView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { isReviewing, review } from '../recording/review.svelte'
import { RunClock } from '../progress/clock'
import { t } from '../texts/index.svelte'
import { Past } from '../progress/past'
import { isSimulator } from '../progress/recording'
import { newFlowStates } from '../progress/newFlowStates'
import { flowName } from '../sentences/words'

const TICK_MS = 100
const clock = new RunClock()
let last: RunView | undefined

const live: { now_s: number; past: Past } = $state({ now_s: 0, past: new Past() })

/** The time of the run that is shown, which may be a recorded one. */
export const runTime = {
  get now_s(): number {
    return isReviewing() ? review.shown_s : live.now_s
  },
  get past(): Past {
    return isReviewing() ? review.past : live.past
  },
}

const now_s = (): number =>
  clock.at(performance.now() / 1000, desk.live.runtime.is_virtual === true && !isSimulator(desk.live.runtime))

// It listens as long as the page is there, also while the run is not looked at.
$effect.root(() => {
  $effect(() => {
    const run = desk.live.run
    if (!run) return
    const app = desk.live.applications[run.doc]
    const whole = $state.snapshot(run) as typeof run
    const before = last
    last = whole
    untrack(() => {
      clock.take(whole, performance.now() / 1000, Date.now() / 1000)
      live.past = live.past.with(whole, app)
      live.now_s = now_s()
      if (whole.state === 'running' && !isReviewing())
        for (const flow of newFlowStates(before, whole))
          announce(`${flowName(flow.order)}: ${t(`perform.state.${flow.state}` as 'perform.state.paused')}`)
    })
  })
  $effect(() => {
    if (!desk.live.run || desk.live.run.state === 'over') return
    const beat = setInterval(() => (live.now_s = now_s()), TICK_MS)
    return () => clearInterval(beat)
  })
})
