/** Finding the place of the insertion cursor: the nearest to a pointer, and the next one for a key. */

import { BAND, onikonWidth } from '../geom/jigsaw'
import type { Cell, Gap, Place } from './arrangement'

export const isSame = (a: Place, b: Place): boolean => a.flow === b.flow && a.after === b.after

export const gapOf = (gaps: readonly Gap[], place: Place): Gap | undefined => gaps.find((gap) => isSame(gap, place))

/** The gap that a pointer is at: the nearest in its row; undefined where it is in none. */
export function gapAt(gaps: readonly Gap[], x: number, y: number, size: number, reach = 22): Gap | undefined {
  const width = onikonWidth(size)
  let best: Gap | undefined
  let least = Infinity
  for (const gap of gaps) {
    const off = Math.max(gap.y - y, y - gap.y - size, 0)
    if (off > reach || Math.abs(x - gap.x) > 1.5 * width) continue
    const far = Math.abs(x - gap.x) + 3 * off
    if (far < least) [best, least] = [gap, far]
  }
  return best
}

/** The step whose picture a pointer is at; its sides belong to the gaps beside it. */
export function cellAt(cells: readonly Cell[], x: number, y: number, size: number): Cell | undefined {
  const side = BAND + size / 8
  return cells.find(
    (cell) => cell.step > 0 && x >= cell.x + side && x < cell.x + cell.w - side && y >= cell.y && y < cell.y + size,
  )
}

export type Way = 'left' | 'right' | 'up' | 'down' | 'first' | 'last' | 'begin' | 'end'

/** Where a key takes the cursor; along the flow, to the rows beside, to the ends of the flow or of everything. */
export function walked(gaps: readonly Gap[], from: Place, way: Way): Gap | undefined {
  const all = gaps.filter((gap) => !gap.isSecond)
  const at = all.findIndex((gap) => isSame(gap, from))
  const here = all[at]
  if (!here) return all[0]
  const own = all.filter((gap) => gap.flow === here.flow)
  switch (way) {
    case 'left':
      return all[at - 1]
    case 'right':
      return all[at + 1]
    case 'first':
      return own[0]
    case 'last':
      return own.at(-1)
    case 'begin':
      return all[0]
    case 'end':
      return all.at(-1)
    default:
      return nextRow(all, here, way === 'down' ? 1 : -1)
  }
}

function nextRow(all: readonly Gap[], { x, y }: Gap, sign: 1 | -1): Gap | undefined {
  let best: Gap | undefined
  for (const gap of all) {
    const off = (gap.y - y) * sign
    if (off <= 0) continue
    const bestOff = best ? (best.y - y) * sign : Infinity
    if (off < bestOff || (off === bestOff && Math.abs(gap.x - x) < Math.abs(best!.x - x))) best = gap
  }
  return best
}
