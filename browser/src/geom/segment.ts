/** The straight pieces of wires, and which of them lie side by side. */

import type { Pt } from './rect'

/**
 * How willingly a segment moves: the ends of a wire stay where pin and locus are (`fixed`); what runs on from there in
 * the same line moves only to get off another such piece (`stiff`), the rest to get off anything (`loose`). A `jog` has
 * no length unless a stiff piece moved away from its end.
 */
export type Hold = 'fixed' | 'stiff' | 'loose' | 'jog'

/** One straight piece: it runs from `lo` to `hi` along a line at `line`, and is drawn at `at`. */
export interface Segment {
  readonly link: string
  readonly svar: string
  readonly vertical: boolean
  readonly hold: Hold
  readonly line: number
  at: number
  lo: number
  hi: number
  /** Where the wire comes from at `lo` and goes to at `hi`: -1 a smaller, 1 a larger coordinate, 0 it ends here. */
  readonly bendLo: number
  readonly bendHi: number
}

/** What stays straight at a pin and at a locus, and the length from which an end is divided at all. */
const [AT_PIN, AT_LOCUS, LONG] = [10, 12, 40]

/** A route with a jog near either end that is long enough: a point that stands twice. */
export function withJogs(route: readonly Pt[]): Pt[] {
  const points = route.slice()
  const n = points.length
  if (n < 2) return points
  const atLocus = partWay(points[n - 1], points[n - 2], AT_LOCUS)
  if (atLocus) points.splice(n - 1, 0, atLocus, atLocus)
  const atPin = partWay(points[0], points[1], AT_PIN)
  if (atPin) points.splice(1, 0, atPin, atPin)
  return points
}

/** The point on a line `part` away from its beginning; null where the line is short. */
function partWay([x, y]: Pt, [x1, y1]: Pt, part: number): Pt | null {
  if (Math.abs(x1 - x) + Math.abs(y1 - y) < LONG) return null
  return [x + Math.sign(x1 - x) * part, y + Math.sign(y1 - y) * part]
}

const same = (a: Pt, b: Pt): boolean => a[0] === b[0] && a[1] === b[1]

/** The pieces of a wire with its jogs, from pin to locus: level and upright ones by turns. */
export function segmentsOf(link: string, svar: string, points: readonly Pt[]): Segment[] {
  const last = points.length - 2
  const jog = (k: number): boolean => k >= 0 && k <= last && same(points[k], points[k + 1])
  const segments: Segment[] = []
  for (let k = 0; k <= last; k++) {
    const [a, b] = [points[k], points[k + 1]]
    const vertical = k > 0 ? !segments[k - 1].vertical : a[0] === b[0]
    const [across, along] = vertical ? [0, 1] : [1, 0]
    const line = a[across]
    const bendA = k > 0 ? Math.sign(points[k - 1][across] - line) : 0
    const bendB = k < last ? Math.sign(points[k + 2][across] - line) : 0
    const rising = a[along] <= b[along]
    segments.push({
      link,
      svar,
      vertical,
      line,
      at: line,
      hold: jog(k) ? 'jog' : k === 0 || k === last ? 'fixed' : jog(k - 1) || jog(k + 1) ? 'stiff' : 'loose',
      lo: Math.min(a[along], b[along]),
      hi: Math.max(a[along], b[along]),
      bendLo: rising ? bendA : bendB,
      bendHi: rising ? bendB : bendA,
    })
  }
  return segments
}

const BAND = 16

/** All segments of one direction, found by the line they lie on. */
export class Bands {
  private readonly bands = new Map<number, Segment[]>()

  add(segment: Segment): void {
    const key = Math.floor(segment.line / BAND)
    const band = this.bands.get(key)
    if (band) band.push(segment)
    else this.bands.set(key, [segment])
  }

  drop(segment: Segment): void {
    const key = Math.floor(segment.line / BAND)
    const band = this.bands.get(key)
    if (!band) return
    const k = band.indexOf(segment)
    if (k < 0) return
    band[k] = band[band.length - 1]
    band.pop()
    if (!band.length) this.bands.delete(key)
  }

  /** The segments within `reach` of a segment's line that run beside it. */
  beside(segment: Segment, reach: number): Segment[] {
    const neighbours: Segment[] = []
    const last = Math.floor((segment.line + reach) / BAND)
    for (let key = Math.floor((segment.line - reach) / BAND); key <= last; key++) {
      for (const other of this.bands.get(key) ?? []) {
        if (other === segment || Math.abs(other.line - segment.line) > reach) continue
        if (sideBySide(segment, other)) neighbours.push(other)
      }
    }
    return neighbours
  }
}

const AIR = 3 // two ends on one line this near would read as one line

export const sideBySide = (a: Interval, b: Interval): boolean => a.lo - AIR < b.hi && b.lo - AIR < a.hi

export interface Interval {
  readonly lo: number
  readonly hi: number
}
