// Which question is shown: those of the document shown, and of the run, come one after the other as they were asked.
import type { AskView, DocumentView, RunView } from '../api.gen'

/** Who asks here: tasks of a document by their names, those of a run, and of one that was taken over, as `SUBSYSTEM/TASK`. */
export function asking(
  doc: DocumentView | undefined,
  runs: readonly RunView[] = [],
  taken: Record<string, AskView> = {},
): Record<string, AskView> {
  const own = Object.entries(doc?.tasks ?? {}).flatMap(([name, task]) => (task.ask ? [[name, task.ask] as const] : []))
  return Object.fromEntries([
    ...own,
    ...Object.entries(taken),
    ...runs.flatMap((run) => Object.entries(run.asks ?? {})),
  ])
}

/** Whether it is a task of the run. */
export const isOfRun = (task: string): boolean => task.includes('/')

export class Asks {
  /** The task whose question is shown; empty: none. */
  shown = $state('')
  /** Whom somebody wants to answer now: that form takes the focus, and none does by itself. */
  wanted = $state('')
  /** Tasks whose question was put aside; it opens again when they ask anew. */
  private readonly aside = new Map<string, AskView>()
  private order: string[] = $state([])
  /** What was typed and not sent, by the question itself: it goes with it. */
  private readonly drafts = new WeakMap<AskView, readonly string[]>()

  /** All who ask now, by their names. */
  take(all: Readonly<Record<string, AskView>>): void {
    const names = new Set(Object.keys(all))
    for (const [name, ask] of Object.entries(all)) if (this.aside.get(name) !== ask) this.aside.delete(name)
    for (const name of [...this.aside.keys()]) if (!names.has(name)) this.aside.delete(name)
    const former = this.order.filter((name) => names.has(name))
    this.order = [...former, ...[...names].filter((name) => !former.includes(name))]
    if (!names.has(this.shown) || this.aside.has(this.shown)) this.shown = this.next()
  }

  /** How many wait behind the one shown. */
  get waiting(): number {
    return this.order.filter((name) => name !== this.shown && !this.aside.has(name)).length
  }

  /** Not now: it stays with its task, and the next one is shown. */
  putAside(ask: AskView | undefined): void {
    if (ask) this.aside.set(this.shown, ask)
    this.shown = this.next()
  }

  /** What was typed as an answer is kept while the question stands, also where it is put aside. */
  keep(ask: AskView, words: readonly string[]): void {
    this.drafts.set(ask, [...words])
  }

  /** What was typed already; undefined: nothing. */
  draft(ask: AskView): readonly string[] | undefined {
    return this.drafts.get(ask)
  }

  /** Somebody wants to answer this one. */
  open(task: string): void {
    this.aside.delete(task)
    if (!this.order.includes(task)) return
    this.shown = task
    this.wanted = task
  }

  private next(): string {
    return this.order.find((name) => !this.aside.has(name)) ?? ''
  }
}

export const asks = new Asks()
