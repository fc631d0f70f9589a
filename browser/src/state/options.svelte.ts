// How this browser starts a run, and what it shows of it.
import { keep, kept } from './kept'

class Options {
  private passes = $state(kept('passesBreakpoints', false))
  private writes = $state(kept('recordsRuns', false))
  /** What becomes of the next run where this environment is lost; not kept, so that whoever comes back begins with the safe choice. */
  onLoss: 'stop' | 'finish' | 'run' = $state('stop')
  private shows = $state(kept('showsWorkcell', true))

  /** Whether breakpoints are passed by. */
  get passesBreakpoints(): boolean {
    return this.passes
  }

  set passesBreakpoints(value: boolean) {
    this.passes = value
    keep('passesBreakpoints', value)
  }

  /** Whether runs are recorded. */
  get records(): boolean {
    return this.writes
  }

  set records(value: boolean) {
    this.writes = value
    keep('recordsRuns', value)
  }

  /** Whether the workcell stands above the run. */
  get showsWorkcell(): boolean {
    return this.shows
  }

  set showsWorkcell(value: boolean) {
    this.shows = value
    keep('showsWorkcell', value)
  }
}

export const options = new Options()
