// Variables of a recorded run over time: asked for when somebody plots them, the whole run first, then what is looked at closer.
import type { StretchView } from '../api.gen'
import type { Past, Stretch } from '../values/series'

const SOON_MS = 120
const MOST = 24

export interface Course {
  labels: readonly string[]
  stretch: Stretch
}

/** In each part of a time the least and the greatest value, as one line that touches both. */
export function courseOf(views: readonly StretchView[]): Course | undefined {
  const [first] = views
  if (!first) return undefined
  const part_s = first.at_s.length > 1 ? (first.at_s.at(-1)! - first.at_s[0]!) / (first.at_s.length - 1) : 0
  const t = new Float64Array(2 * first.at_s.length)
  first.at_s.forEach((at_s, k) => t.set([at_s, at_s + part_s / 2], 2 * k))
  const y = views.map((view) => {
    const row = new Float64Array(t.length)
    // up where it goes up, down where it goes down, so that a slope is drawn as one
    view.least.forEach((low, k) => {
      const high = view.most[k]!
      const isRising = k === 0 || low + high >= view.least[k - 1]! + view.most[k - 1]!
      row.set(isRising ? [low, high] : [high, low], 2 * k)
    })
    return row
  })
  return { labels: views.map((view) => view.label), stretch: { t, y } }
}

type Ask = (variable: string, begin_s: number, end_s: number) => Promise<readonly StretchView[]>

export class Courses {
  private readonly whole = new Map<string, Course | null>()
  private readonly close = new Map<string, { from_s: number; to_s: number; course: Course | undefined }>()
  private readonly timers = new Map<string, ReturnType<typeof setTimeout>>()
  private isEnded = false

  /** `come` is called when something has come. */
  constructor(
    private readonly begin_s: number,
    private readonly end_s: number,
    private readonly ask: Ask,
    private readonly come: () => void,
  ) {}

  /** The whole run, roughly; undefined until it has come, and where it is not recorded. */
  of(variable: string): Course | undefined {
    const kept = this.whole.get(variable)
    if (kept !== undefined) return kept ?? undefined
    if (this.whole.size >= MOST) this.whole.delete(this.whole.keys().next().value!)
    this.whole.set(variable, null)
    void this.fetch(variable, this.begin_s, this.end_s).then((course) => {
      if (this.isEnded || !course) return
      this.whole.set(variable, course)
      this.come()
    })
    return undefined
  }

  /** A part of the run, as finely as it is known; what is missing is asked for as soon as the hand rests. */
  between(variable: string, from_s: number, to_s: number): Course | undefined {
    const whole = this.of(variable)
    if (!whole || (from_s <= this.begin_s && to_s >= this.end_s)) return whole
    const near = this.close.get(variable)
    if (near && near.from_s === from_s && near.to_s === to_s) return near.course ?? whole
    this.close.set(variable, { from_s, to_s, course: undefined })
    clearTimeout(this.timers.get(variable))
    this.timers.set(
      variable,
      setTimeout(() => void this.look(variable, from_s, to_s), SOON_MS),
    )
    return whole
  }

  end(): void {
    this.isEnded = true
    for (const timer of this.timers.values()) clearTimeout(timer)
  }

  private async look(variable: string, from_s: number, to_s: number): Promise<void> {
    const room_s = (to_s - from_s) / 10 // so that lines reach both sides
    const course = await this.fetch(
      variable,
      Math.max(this.begin_s, from_s - room_s),
      Math.min(this.end_s, to_s + room_s),
    )
    const near = this.close.get(variable)
    if (this.isEnded || !near || near.from_s !== from_s || near.to_s !== to_s) return
    near.course = course
    this.come()
  }

  private async fetch(variable: string, from_s: number, to_s: number): Promise<Course | undefined> {
    try {
      return courseOf(await this.ask(variable, from_s, to_s))
    } catch {
      return undefined // it is not there, or the line is down; after that all is asked for anew
    }
  }
}

/** A course as a plot reads it: up to an instant, or whole. */
export class RecordedPast implements Past {
  constructor(
    private readonly course: Course,
    readonly last_s: number,
  ) {}

  get width(): number {
    return this.course.stretch.y.length
  }

  get length(): number {
    return this.course.stretch.t.length
  }

  since(from_s: number): Stretch {
    const { t, y } = this.course.stretch
    const first = Math.max(0, before(t, from_s))
    const end = Math.max(first + 1, before(t, this.last_s) + 1)
    return { t: t.subarray(first, end), y: y.map((row) => row.subarray(first, end)) }
  }

  all(): Stretch {
    return this.course.stretch
  }
}

/** The last place whose time is not after this one; -1: none is. */
export function before(t: Float64Array, at_s: number): number {
  let [low, high] = [0, t.length]
  while (low < high) {
    const middle = (low + high) >> 1
    if (t[middle]! <= at_s) low = middle + 1
    else high = middle
  }
  return low - 1
}

/** Two runs on one line of time: the columns of the one, then those of the other; between its samples a line stays a line. */
export function together(first: Stretch, other: Stretch): Stretch {
  const t = Float64Array.from(new Set([...first.t, ...other.t])).sort()
  return { t, y: [...first.y.map((row) => along(t, first.t, row)), ...other.y.map((row) => along(t, other.t, row))] }
}

/** NaN before its first sample and after its last. */
function along(t: Float64Array, at: Float64Array, row: Float64Array): Float64Array {
  const values = new Float64Array(t.length)
  let k = 0
  t.forEach((at_s, n) => {
    while (k + 1 < at.length && at[k + 1]! <= at_s) k += 1
    const [t0, t1 = t0, v0, v1 = v0] = [at[k], at[k + 1], row[k], row[k + 1]] as [
      number,
      number | undefined,
      number,
      number | undefined,
    ]
    if (t0 === undefined || at_s < t0 || (at[k + 1] === undefined && at_s > t0)) values[n] = NaN
    else values[n] = at_s === t0 || t1 === t0 ? v0 : v0 + ((v1 - v0) * (at_s - t0)) / (t1 - t0)
  })
  return values
}
