/** The sparse grid a wire is searched on: the sides of all obstacles of a region, and the two ends. */

import type { Area, Pt } from './rect'

/** Bits of `blocked`: the way from a crossing to its right or to the one below passes through an obstacle. */
export const RIGHT = 1
export const DOWN = 2

export class Grid {
  xs: number[] = []
  ys: number[] = []
  blocked = new Uint8Array(4096)

  /**
   * Lay the grid. Only lines within the region count: beyond it obstacles are unknown, so no wire may leave it
   * within it every side is a line, so that each way between two crossings lies wholly in or out of an obstacle.
   */
  lay(obstacles: readonly Area[], ends: readonly Pt[], region: Area): void {
    const xs = ends.map((p) => p[0])
    const ys = ends.map((p) => p[1])
    for (const o of obstacles) {
      if (o.x0 >= region.x0 && o.x0 <= region.x1) xs.push(o.x0)
      if (o.x1 >= region.x0 && o.x1 <= region.x1) xs.push(o.x1)
      if (o.y0 >= region.y0 && o.y0 <= region.y1) ys.push(o.y0)
      if (o.y1 >= region.y0 && o.y1 <= region.y1) ys.push(o.y1)
    }
    this.xs = distinct(xs)
    this.ys = distinct(ys)
    const size = this.xs.length * this.ys.length
    if (this.blocked.length < size) this.blocked = new Uint8Array(2 * size)
    this.blocked.fill(0, 0, size)
    for (const o of obstacles) this.block(o)
  }

  /** The number of the crossing at a point that is on the grid. */
  at(p: Pt): number {
    return this.ys.indexOf(p[1]) * this.xs.length + this.xs.indexOf(p[0])
  }

  private block(o: Area): void {
    const { xs, ys, blocked } = this
    const [w, h] = [xs.length, ys.length]
    const [i0, i1] = [after(xs, o.x0), before(xs, o.x1)] // lines strictly within the obstacle
    const [j0, j1] = [after(ys, o.y0), before(ys, o.y1)]
    const [left, right] = [Math.max(i0 - 1, 0), Math.min(i1, w - 2)]
    for (let j = j0; j <= j1; j++) for (let i = left; i <= right; i++) blocked[j * w + i] |= RIGHT
    const [above, below] = [Math.max(j0 - 1, 0), Math.min(j1, h - 2)]
    for (let j = above; j <= below; j++) for (let i = i0; i <= i1; i++) blocked[j * w + i] |= DOWN
  }
}

function distinct(values: number[]): number[] {
  values.sort((a, b) => a - b)
  let n = 0
  for (let k = 0; k < values.length; k++) if (k === 0 || values[k] !== values[n - 1]) values[n++] = values[k]
  values.length = n
  return values
}

/** The first line beyond `v`. */
function after(lines: readonly number[], v: number): number {
  let [lo, hi] = [0, lines.length]
  while (lo < hi) {
    const mid = (lo + hi) >> 1
    if (lines[mid] > v) hi = mid
    else lo = mid + 1
  }
  return lo
}

/** The last line short of `v`. */
function before(lines: readonly number[], v: number): number {
  let [lo, hi] = [0, lines.length]
  while (lo < hi) {
    const mid = (lo + hi) >> 1
    if (lines[mid] >= v) hi = mid
    else lo = mid + 1
  }
  return lo - 1
}
