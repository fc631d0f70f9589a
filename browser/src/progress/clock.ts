// The clock of a run as this browser knows it: between two messages it goes on by itself, and it never goes back.
import type { RunView } from '../api.gen'

/** How far the clocks of two machines may differ and still be believed when a page joins a run late. */
const BELIEVED_S = 3600

export class RunClock {
  /** The run's own time less that of this browser; a message is late at most, so the greatest is the truest. */
  private offset_s = -Infinity
  private number = 0
  private latest_s = 0
  private isOver = false
  /** Whether it is only about to begin; that may take as long as a runtime takes to start, and is no time of the run. */
  private isBeginning = false

  /** A message has come; `here_s` is this browser's steady clock, `wall_s` the seconds since 1970. */
  take(run: RunView, here_s: number, wall_s: number): void {
    const isNew = run.number !== this.number
    const known_s = latest(run)
    const begins = this.isBeginning && !isNew && run.state === 'running'
    this.isBeginning = (run.state ?? 'beginning') === 'beginning' // what is as usual is not sent
    if (begins) this.offset_s = known_s - here_s
    else if (isNew) {
      this.number = run.number
      this.offset_s = known_s - here_s
      this.latest_s = 0
      const since_s = wall_s - (run.began_at_s ?? wall_s)
      if (run.state === 'running' && since_s > known_s && since_s < known_s + BELIEVED_S)
        this.offset_s = since_s - here_s
    } else if (run.state === 'running') this.offset_s = Math.max(this.offset_s, known_s - here_s)
    this.latest_s = Math.max(this.latest_s, known_s)
    this.isOver = run.state === 'over'
    if (this.isOver) this.latest_s = run.took_s || known_s
  }

  /** Seconds since the run began. `isVirtual`: its time does not pass with ours; what was heard last counts. */
  at(here_s: number, isVirtual = false): number {
    if (this.isOver || this.isBeginning || isVirtual || !Number.isFinite(this.offset_s)) return this.latest_s
    return Math.max(this.latest_s, here_s + this.offset_s)
  }
}

/** The latest moment that a run speaks of. */
export function latest(run: RunView): number {
  let at_s = 0
  for (const flow of Object.values(run.flows ?? {})) at_s = Math.max(at_s, flow.began_s ?? 0, flow.waits_since_s ?? 0)
  for (const step of Object.values(run.steps ?? {}))
    at_s = Math.max(at_s, (step.began_s ?? 0) + ((step.state ?? 'running') === 'running' ? 0 : (step.took_s ?? 0)))
  for (const meet of run.meets ?? []) at_s = Math.max(at_s, meet.at_s)
  for (const stop of Object.values(run.stops ?? {})) at_s = Math.max(at_s, stop.at_s)
  return at_s
}
