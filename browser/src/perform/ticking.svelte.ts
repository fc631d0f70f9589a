// The time of the run, ten times a second while it goes on; and all that has happened in it since this page came.
import { untrack } from 'svelte'
import { announce } from '../announce'
import type { RunView } from '../api.gen'
import { desk } from '../desk.svelte'
import { RunClock } from './clock'
import { t } from '../texts/index.svelte'
import { Past } from './past'
import { newly } from './spoken'
import { flowName } from './words'

const TICK_MS = 100
const clock = new RunClock()
let last: RunView | undefined

export const ticking: { now_s: number; past: Past } = $state({ now_s: 0, past: new Past() })

/** The run's own time now, for who draws every frame. */
export const now_s = (): number => clock.at(performance.now() / 1000, desk.tree.runtime.is_virtual === true)

// It listens as long as the page is there, also while the run is not looked at.
$effect.root(() => {
  $effect(() => {
    const run = desk.tree.run
    if (!run) return
    const app = desk.tree.applications[run.doc]
    const whole = $state.snapshot(run) as typeof run
    const before = last
    last = whole
    untrack(() => {
      clock.take(whole, performance.now() / 1000, Date.now() / 1000)
      ticking.past = ticking.past.with(whole, app)
      ticking.now_s = now_s()
      if (whole.state === 'running') for (const flow of newly(before, whole)) announce(`${flowName(flow.order)}: ${t(`perform.state.${flow.state}` as 'perform.state.paused')}`)
    })
  })
  $effect(() => {
    if (!desk.tree.run || desk.tree.run.state === 'over') return
    const beat = setInterval(() => (ticking.now_s = now_s()), TICK_MS)
    return () => clearInterval(beat)
  })
})
