// When a scope begins to draw: where a course crosses a level.
import type { Course } from './response'

export type Edge = 'rising' | 'falling'

/** The newest crossing that has `after_s` behind it, later than `since_s`; NaN where there is none. */
export function crossing(course: Course, edge: Edge, level: number, after_s: number, since_s = -Infinity): number {
  const { t, y } = course
  const end_s = (t[t.length - 1] ?? NaN) - after_s
  const sign = edge === 'rising' ? 1 : -1
  for (let k = t.length - 1; k > 0 && t[k]! > since_s; k -= 1) {
    if (t[k]! <= end_s && sign * (y[k]! - level) >= 0 && sign * (y[k - 1]! - level) < 0) return t[k]!
  }
  return NaN
}
