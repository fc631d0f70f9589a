// Which standstill is explained: it shows itself when it comes; put aside, it stays until somebody wants it back.
import { look } from '../state/look.svelte'
import type { RunView, StopView } from '../api.gen'

export interface Standstill {
  /** Where the run says it: a subsystem; empty: the end of the run. */
  at: string
  stop: StopView
  /** One and the same standstill has one and the same key. */
  key: string
}

/** What stands still in a run, or why it ended; an end that somebody wanted needs no explanation. */
export function standstills(run: RunView | null | undefined): Standstill[] {
  if (!run) return []
  const stops = Object.entries(run.stops ?? {}).map(([at, stop]) => ({
    at,
    stop,
    key: `${run.number}/${at}/${stop.at_s}/${stop.kind}`,
  }))
  return stops
    .filter(({ at, stop }) => stop.kind !== 'user' && !(stop.kind === 'deserted' && isComing(run, at)))
    .sort((stop, other) => stop.stop.at_s - other.stop.at_s)
}

/** Whether all that a flow waits for go on meanwhile: then it is deserted no more. */
function isComing(run: RunView, at: string): boolean {
  const awaited = run.flows?.[at]?.waits_for ?? []
  return (
    awaited.length > 0 &&
    awaited.every((name) => !['stopped', 'done', 'killing', 'ended'].includes(run.flows?.[name]?.state ?? ''))
  )
}

class ShownStop {
  /** The key of the one on show; empty: none. */
  shown = $state('')
  private readonly known = new Set<string>()
  private all: Standstill[] = $state.raw([])

  /** What a run says now; true where something new stands still. */
  take(run: RunView | null | undefined): Standstill | undefined {
    this.all = standstills(run)
    const fresh = this.all.find(({ key }) => !this.known.has(key))
    for (const { key } of this.all) this.known.add(key)
    if (!this.all.some(({ key }) => key === this.shown)) this.shown = fresh?.key ?? '' // what is being read stays
    return fresh
  }

  hasAny(run: RunView): boolean {
    return standstills(run).length > 0
  }

  putAside(): void {
    this.shown = ''
  }

  /** Bring back the one of a subsystem. */
  openAt(subsystem: string): void {
    this.open(this.all.find(({ at, stop }) => at === subsystem || stop.subsystem === subsystem)?.key)
  }

  /** Bring one back: this one, or the newest. */
  open(key = this.all.at(-1)?.key ?? ''): void {
    this.shown = key
    look.column = 'desk'
  }
}

export const shownStop = new ShownStop()
