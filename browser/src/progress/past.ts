// What has happened in a run, flow by flow: actions and waits, as blocks of time. A run itself only tells what was last.
import type { ApplicationView, RunView } from '../api.gen'

export interface Block {
  key: string
  kind: 'action' | 'wait'
  /** The number of its flow. */
  flow: number
  step: number
  from_s: number
  /** NaN while it goes on. */
  to_s: number
  /** Whether it has come to stand still in it. */
  isFault: boolean
}

const MOST = 2000

export class Past {
  constructor(
    readonly run: number = 0,
    readonly blocks: readonly Block[] = [],
    private readonly homes: ReadonlyMap<number, number> = new Map(),
  ) {}

  /** With what a run says now; a run of another number begins anew. */
  with(run: RunView, app: ApplicationView | undefined): Past {
    const before = run.number === this.run ? this : new Past(run.number)
    const homes = app ? flowsOfSteps(app) : before.homes
    const byKey = new Map(before.blocks.map((block) => [block.key, block]))
    takeActions(byKey, run, homes)
    takeWaits(byKey, run)
    const blocks = [...byKey.values()].sort((block, other) => block.from_s - other.from_s)
    return new Past(run.number, blocks.slice(-MOST), homes)
  }
}

/** Of every step the number of its outermost flow. */
export function flowsOfSteps(app: ApplicationView): Map<number, number> {
  const homes = new Map<number, number>()
  for (const [path, flow] of Object.entries(app.flows ?? {})) {
    for (const step of flow.steps ?? []) homes.set(step, Number(path.split('/')[0]))
  }
  return homes
}

function takeActions(byKey: Map<string, Block>, run: RunView, homes: ReadonlyMap<number, number>): void {
  const open = new Map(
    [...byKey.values()].filter((block) => block.kind === 'action' && isOpen(block)).map((block) => [block.step, block]),
  )
  const stops = Object.values(run.stops ?? {}).filter(
    (stop) => stop.subsystem && run.flows?.[stop.subsystem]?.state === 'stopped',
  )
  for (const [number, at] of Object.entries(run.steps ?? {})) {
    const step = Number(number)
    const [from_s, took_s] = [at.began_s ?? 0, at.took_s ?? 0]
    const key = `${step}@${from_s}`
    // a step that has begun again has ended before, however few messages said so
    const former = open.get(step)
    if (former && former.key !== key)
      byKey.set(former.key, { ...former, to_s: Math.min(from_s, former.from_s + took_s) })
    const stop = stops.find((stop) => stop.step === step && stop.at_s >= from_s)
    const wasRunning = (at.state ?? 'running') === 'running'
    const end_s = wasRunning ? Math.max(from_s, run.took_s ?? from_s) : from_s + took_s
    const before = byKey.get(key)
    const to_s = stop ? stop.at_s : before?.isFault ? before.to_s : wasRunning && run.state !== 'over' ? NaN : end_s
    const isFault = stop !== undefined || before?.isFault === true
    if (before && isFault === before.isFault && Object.is(before.to_s, to_s)) continue
    byKey.set(key, { key, kind: 'action', flow: homes.get(step) ?? 0, step, from_s, to_s, isFault })
  }
}

function takeWaits(byKey: Map<string, Block>, run: RunView): void {
  for (const flow of Object.values(run.flows ?? {})) {
    if (flow.is_nested) continue
    const since_s = flow.waits_since_s ?? 0
    const isWaiting = flow.state === 'waiting' && run.state !== 'over'
    for (const block of byKey.values()) {
      if (
        block.kind !== 'wait' ||
        block.flow !== flow.order ||
        !isOpen(block) ||
        (isWaiting && block.from_s === since_s)
      )
        continue
      const began_s = flow.began_s ?? 0
      byKey.set(block.key, {
        ...block,
        to_s: began_s > block.from_s ? began_s : Math.max(block.from_s, run.took_s ?? 0),
      })
    }
    const key = `wait ${flow.order}@${since_s}`
    if (isWaiting && !byKey.has(key))
      byKey.set(key, {
        key,
        kind: 'wait',
        flow: flow.order,
        step: flow.step ?? 0,
        from_s: since_s,
        to_s: NaN,
        isFault: false,
      })
  }
}

export const isOpen = (block: Block): boolean => Number.isNaN(block.to_s)
