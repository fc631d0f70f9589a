// The newest values of what this browser watches, and the last minute of each. All of it stays outside reactivity:
// whoever draws asks in `onFrame`, which calls once for each picture of the screen in which something has come.
import type { Frame, Watch } from '../api.gen'
import { numbers, Series } from './series'

export type Figures = Record<string, Record<string, unknown>>

const HZ = 30

/** Counts how often each thing is wanted, so that two views of one variable cost one. */
class Wanted {
  private readonly count = new Map<string, number>()

  get names(): string[] {
    return [...this.count.keys()].sort()
  }

  has(name: string): boolean {
    return this.count.has(name)
  }

  add(name: string): void {
    this.count.set(name, (this.count.get(name) ?? 0) + 1)
  }

  /** Whether nobody wants it any more. */
  drop(name: string): boolean {
    const left = (this.count.get(name) ?? 1) - 1
    if (left) this.count.set(name, left)
    else this.count.delete(name)
    return left === 0
  }
}

export class ValueBuffer {
  /** The newest figures of tasks, by `DOC/TASK`; replaced as a whole when others come. */
  figures: Figures = {}
  /** The environment's time of the newest frame. */
  now_s = NaN
  private readonly variables = new Wanted()
  private readonly worlds = new Wanted()
  private readonly tables = new Wanted()
  private readonly values = new Map<string, unknown>()
  private readonly past = new Map<string, Series>()
  private readonly places = new Map<string, unknown>()
  private readonly listeners = new Set<() => void>()
  private isDue = false
  private isReportDue = false
  private lastWish = ''

  /** `tell` sends what is wanted; `soon` runs something with the next picture of the screen. */
  constructor(
    private readonly tell: (wish: Watch) => void,
    private readonly soon: (run: () => void) => void,
  ) {}

  watch(key: string): () => void {
    return this.want(this.variables, key, () => {
      this.values.delete(key)
      this.past.delete(key)
    })
  }

  watchWorld(name: string): () => void {
    return this.want(this.worlds, name, () => this.places.delete(name))
  }

  watchFigures(): () => void {
    return this.want(this.tables, 'figures', () => (this.figures = {}))
  }

  latest(key: string): unknown {
    return this.values.get(key)
  }

  /** The past of a watched variable; undefined until numbers have come. */
  series(key: string): Series | undefined {
    return this.past.get(key)
  }

  /** The newest places of a world's bodies, as the frame gave them. */
  poses(world: string): unknown {
    return this.places.get(world)
  }

  onFrame(listen: () => void): () => void {
    this.listeners.add(listen)
    return () => this.listeners.delete(listen)
  }

  /** Takes what has come. What nobody wants any more is dropped. */
  receive(frame: Frame): void {
    this.now_s = frame.at_s
    for (const [key, value] of Object.entries(frame.values ?? {}))
      if (this.variables.has(key)) this.keep(key, frame.at_s, value)
    for (const [name, rows] of Object.entries(frame.poses ?? {})) if (this.worlds.has(name)) this.places.set(name, rows)
    if (frame.figures && Object.keys(frame.figures).length) this.figures = { ...this.figures, ...frame.figures }
    this.pump()
  }

  /** Says again what is wanted: after a new connection, and where somebody asks for fresh figures. */
  again(): void {
    this.lastWish = ''
    this.tellSoon()
  }

  private keep(key: string, at_s: number, value: unknown): void {
    this.values.set(key, value)
    const row = numbers(value)
    if (!row?.length) return
    let series = this.past.get(key)
    if (series?.width !== row.length) this.past.set(key, (series = new Series(row.length)))
    series.push(at_s, row)
  }

  /** Have everybody look again: what is shown comes from elsewhere now. */
  stir(): void {
    this.pump()
  }

  private pump(): void {
    if (this.isDue || !this.listeners.size) return
    this.isDue = true
    this.soon(() => {
      this.isDue = false
      for (const listen of [...this.listeners]) listen()
    })
  }

  private want(wanted: Wanted, name: string, forget: () => void): () => void {
    wanted.add(name)
    this.tellSoon()
    let isWanted = true
    return () => {
      if (!isWanted) return
      isWanted = false
      if (wanted.drop(name)) forget()
      this.tellSoon()
    }
  }

  /** One message for all that changes in one turn, and none where it comes to the same. */
  private tellSoon(): void {
    if (this.isReportDue) return
    this.isReportDue = true
    queueMicrotask(() => {
      this.isReportDue = false
      const wish: Watch = {
        t: 'Watch',
        variables: this.variables.names,
        worlds: this.worlds.names,
        figures: this.tables.has('figures'),
        hz: HZ,
      }
      const text = JSON.stringify(wish)
      const isNothing = !wish.variables?.length && !wish.worlds?.length && !wish.figures
      if (text === this.lastWish || (isNothing && !this.lastWish)) return
      this.lastWish = text
      this.tell(wish)
    })
  }
}
