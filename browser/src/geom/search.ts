/** A* over a grid: the shortest way where a bend costs as much as some length. */

import { DOWN, RIGHT, type Grid } from './grid'
import { Heap } from './heap'
import type { Pt } from './rect'

/** What a bend costs, in pixels of length. */
const BEND = 24

export class Search {
  /** After a search in vain: whether the start is walled in, so that a larger region would not help. */
  enclosed = false

  private costs = new Float64Array(8192)
  private from = new Int32Array(8192)
  private left = new Uint8Array(8192) // states that were left by the cheapest way: what else leads there is dearer
  private readonly heap = new Heap()

  /** The corners of the way from `start`, which is left horizontally, to `goal`; null where there is none. */
  find(grid: Grid, start: Pt, goal: Pt): Pt[] | null {
    const { xs, ys, blocked } = grid
    const [w, h] = [xs.length, ys.length]
    const size = w * h
    this.reserve(2 * size)
    const { costs, from, left, heap } = this
    costs.fill(Infinity, 0, 2 * size)
    left.fill(0, 0, 2 * size)
    heap.clear()
    this.enclosed = true

    // A state is a crossing, plus `size` where it was reached vertically.
    const first = grid.at(start)
    const last = grid.at(goal)
    const [gx, gy] = goal
    const rest = (i: number, j: number, vertical: boolean): number => {
      const [dx, dy] = [Math.abs(xs[i] - gx), Math.abs(ys[j] - gy)]
      return dx + dy + ((vertical ? dx : dy) > 0 ? BEND : 0)
    }
    const step = (state: number, i: number, j: number, vertical: boolean, length: number): void => {
      const next = j * w + i + (vertical ? size : 0)
      const cost = costs[state] + length + (vertical === state >= size ? 0 : BEND)
      if (cost >= costs[next] - 1e-9) return
      costs[next] = cost
      from[next] = state
      left[next] = 0
      heap.push(cost + rest(i, j, vertical), next)
    }

    costs[first] = 0
    from[first] = -1
    heap.push(0, first)
    while (!heap.empty) {
      const state = heap.pop()
      if (left[state]) continue
      left[state] = 1
      const n = state >= size ? state - size : state
      if (n === last) return this.corners(grid, state, size)
      const i = n % w
      const j = (n - i) / w
      if (i === 0 || j === 0 || i === w - 1 || j === h - 1) this.enclosed = false
      if (i + 1 < w && !(blocked[n] & RIGHT)) step(state, i + 1, j, false, xs[i + 1] - xs[i])
      if (i > 0 && !(blocked[n - 1] & RIGHT)) step(state, i - 1, j, false, xs[i] - xs[i - 1])
      if (j + 1 < h && !(blocked[n] & DOWN)) step(state, i, j + 1, true, ys[j + 1] - ys[j])
      if (j > 0 && !(blocked[n - w] & DOWN)) step(state, i, j - 1, true, ys[j] - ys[j - 1])
    }
    return null
  }

  private corners(grid: Grid, state: number, size: number): Pt[] {
    const path: Pt[] = []
    for (let s = state; s >= 0; s = this.from[s]) {
      const n = s >= size ? s - size : s
      path.push([grid.xs[n % grid.xs.length], grid.ys[Math.floor(n / grid.xs.length)]])
    }
    return path.reverse()
  }

  private reserve(states: number): void {
    if (this.costs.length >= states) return
    this.costs = new Float64Array(2 * states)
    this.from = new Int32Array(2 * states)
    this.left = new Uint8Array(2 * states)
  }
}
