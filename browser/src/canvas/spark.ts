// The last seconds of a variable as small lines, one for each element.
import type { Stretch } from '../values/series'

/** More lines than this nobody can tell apart in so small a picture. */
const MOST = 6

/** Paths for a picture of this size; the time runs from `from_s` at the left to `to_s` at the right. */
export function spark({ t, y }: Stretch, from_s: number, to_s: number, w: number, h: number): string[] {
  const rows = y.slice(0, MOST)
  const [low, high] = limits(rows)
  const across = (at_s: number): number => ((at_s - from_s) / (to_s - from_s)) * w
  const down = (value: number): number => h - ((value - low) / (high - low)) * h
  return rows.map((row) => {
    let d = ''
    let last = -1
    for (let k = 0; k < row.length; k += 1) {
      const x = Math.max(0, across(t[k]!))
      if (x - last < 1 && k + 1 < row.length) continue // one sample for each pixel is all that can be seen
      d += `${d ? 'L' : 'M'}${x.toFixed(1)} ${down(row[k]!).toFixed(1)}`
      last = x
    }
    return d
  })
}

/** What the values span; a line that does not move lies in the middle. */
function limits(rows: readonly Float64Array[]): [number, number] {
  let [low, high] = [Infinity, -Infinity]
  for (const row of rows)
    for (const value of row)
      if (Number.isFinite(value)) {
        low = Math.min(low, value)
        high = Math.max(high, value)
      }
  if (low > high) return [-1, 1]
  const room = (high - low) * 0.06 || Math.abs(high) * 0.1 || 1
  return [low - room, high + room]
}
