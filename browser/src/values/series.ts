// The past of one variable: the last minute of its values, in memory that never grows.

/** A stretch of the past, oldest first: times and, for each element, its values. The arrays are views: copy to keep. */
export interface Stretch {
  t: Float64Array
  y: Float64Array[]
}

/** The past of a variable, wherever it comes from. */
export interface Past {
  readonly width: number
  readonly length: number
  /** Up to when it is shown; NaN before the first sample. */
  readonly last_s: number
  since(from_s: number): Stretch
  all(): Stretch
}

/** 60 s at 30 Hz, and a little more. */
export const DEPTH = 2048

/** A sample may overtake another on its way by so much. */
const LATE_S = 1

/** Every sample stands twice, `depth` apart, so that any stretch lies in one piece and nothing is copied to draw it. */
export class Series implements Past {
  readonly width: number
  private readonly depth: number
  private readonly t: Float64Array
  private readonly y: Float64Array[]
  private written = 0

  constructor(width: number, depth = DEPTH) {
    this.width = width
    this.depth = depth
    this.t = new Float64Array(2 * depth)
    this.y = Array.from({ length: width }, () => new Float64Array(2 * depth))
  }

  get length(): number {
    return Math.min(this.written, this.depth)
  }

  /** The time of the newest sample; NaN before the first. */
  get last_s(): number {
    return this.written ? this.t[(this.written - 1) % this.depth] : NaN
  }

  /** Take a sample. One of the same time replaces the last, one that comes late is dropped; far back, the clock began anew. */
  push(at_s: number, row: ArrayLike<number>): void {
    if (at_s < this.last_s - LATE_S) this.written = 0
    if (at_s < this.last_s) return
    if (at_s === this.last_s) this.written -= 1
    const at = this.written % this.depth
    this.t[at] = this.t[at + this.depth] = at_s
    for (let k = 0; k < this.width; k += 1) this.y[k][at] = this.y[k][at + this.depth] = row[k]
    this.written += 1
  }

  /** What came from `from_s` on, with one sample before it, so that a line reaches the left side. */
  since(from_s: number): Stretch {
    const n = this.length
    const end = ((this.written - 1) % this.depth) + this.depth + 1
    let first = end - n
    let last = end
    while (first < last) {
      const middle = (first + last) >> 1
      if (this.t[middle] < from_s) first = middle + 1
      else last = middle
    }
    const start = n ? Math.max(end - n, first - 1) : end
    return { t: this.t.subarray(start, end), y: this.y.map((column) => column.subarray(start, end)) }
  }

  /** All of it. */
  all(): Stretch {
    return this.since(-Infinity)
  }
}

/** The numbers in a value: itself, its elements row by row; a truth is 1 or 0. Undefined for text and the like. */
export function numbers(value: unknown): number[] | undefined {
  if (typeof value === 'number') return [value]
  if (typeof value === 'boolean') return [value ? 1 : 0]
  if (!Array.isArray(value)) return undefined
  const rows = value.map(numbers)
  return rows.every((row) => row !== undefined) ? rows.flat() : undefined
}
