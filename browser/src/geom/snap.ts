/** Where a dragged box comes to rest: in line with its neighbours, or on the grid. */

import type { Rect } from './rect'

/** The grid of the canvas, in pixels. */
export const GRID = 5

/** A box and the heights of its pins below its top, which may be lined up with those of others. */
export interface Snappable extends Rect {
  readonly rows?: readonly number[]
}

/** A line to show while a box is in line with another: along `at`, from `from` to `to`. */
export interface Guide {
  readonly vertical: boolean
  readonly at: number
  readonly from: number
  readonly to: number
  readonly kind: 'edge' | 'row'
}

export interface Snap {
  readonly x: number
  readonly y: number
  readonly guides: readonly Guide[]
}

export interface SnapOptions {
  /** The Alt key: the box goes exactly where it is dragged. */
  readonly suspended?: boolean
  /** How near, in pixels of the scene, another box must be in line to draw this one. */
  readonly reach?: number
}

interface Match {
  readonly shift: number
  readonly guide: Guide
}

export function snap(moving: Snappable, neighbours: readonly Snappable[], options: SnapOptions = {}): Snap {
  const { suspended = false, reach = 4 } = options
  if (suspended) return { x: moving.x, y: moving.y, guides: [] }
  const across = nearest(
    neighbours.flatMap((other) => columns(moving, other)),
    reach,
  )
  const down = nearest(
    neighbours.flatMap((other) => lines(moving, other)),
    reach,
  )
  return {
    x: across.length ? moving.x + across[0].shift : onGrid(moving.x),
    y: down.length ? moving.y + down[0].shift : onGrid(moving.y),
    guides: [...across, ...down].map((match) => match.guide),
  }
}

export const onGrid = (v: number): number => Math.round(v / GRID) * GRID

/** The matches that ask for the smallest shift, and all that agree with it. */
function nearest(matches: readonly Match[], reach: number): Match[] {
  let best: number | null = null
  for (const { shift } of matches) {
    if (Math.abs(shift) <= reach && (best === null || Math.abs(shift) < Math.abs(best))) best = shift
  }
  return best === null ? [] : matches.filter(({ shift }) => Math.abs(shift - best) < 1e-6)
}

/** Left or right side in line with left or right side. */
function columns(moving: Snappable, other: Snappable): Match[] {
  const [from, to] = [Math.min(moving.y, other.y), Math.max(moving.y + moving.h, other.y + other.h)]
  return pairs([moving.x, moving.x + moving.w], [other.x, other.x + other.w]).map(([own, at]) => ({
    shift: at - own,
    guide: { vertical: true, at, from, to, kind: 'edge' },
  }))
}

/** A row of pins in line with a row of pins, or top or bottom with top or bottom. */
function lines(moving: Snappable, other: Snappable): Match[] {
  const [from, to] = [Math.min(moving.x, other.x), Math.max(moving.x + moving.w, other.x + other.w)]
  const match =
    (kind: 'edge' | 'row') =>
    ([own, at]: [number, number]): Match => ({ shift: at - own, guide: { vertical: false, at, from, to, kind } })
  return [
    ...pairs(rowsOf(moving), rowsOf(other)).map(match('row')),
    ...pairs([moving.y, moving.y + moving.h], [other.y, other.y + other.h]).map(match('edge')),
  ]
}

const rowsOf = (box: Snappable): number[] => (box.rows ?? []).map((dy) => box.y + dy)
const pairs = (own: readonly number[], others: readonly number[]): [number, number][] =>
  own.flatMap((a) => others.map((b): [number, number] => [a, b]))
