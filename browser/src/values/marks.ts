// When tasks changed their state: lines in the plots.

export interface Mark {
  at_s: number
  task: string
  text: string
  isError: boolean
}

/** Marks of the tasks that have to do with a variable. */
export interface Marked {
  of(tasks: ReadonlySet<string>): readonly Mark[]
}

const MOST = 200

/** The changes of one document's tasks, oldest first. */
export class Marks implements Marked {
  readonly all: Mark[] = []
  private states = new Map<string, string>()

  /** The states of all tasks as they are at `at_s`; before the first frame (NaN) they are only remembered. */
  take(at_s: number, states: Iterable<readonly [string, string]>): void {
    const next = new Map(states)
    for (const [task, state] of next) {
      const former = this.states.get(task)
      if (former === undefined || former === state || !state || !Number.isFinite(at_s)) continue
      this.all.push({ at_s, task, text: `${task}: ${state}`, isError: state === 'ERROR' })
    }
    this.states = next
    if (this.all.length > MOST) this.all.splice(0, this.all.length - MOST)
  }

  /** Errors of all tasks, and what else happened to those that have to do with a variable. */
  of(tasks: ReadonlySet<string>): Mark[] {
    return this.all.filter((mark) => mark.isError || tasks.has(mark.task))
  }
}
