/** Cells, gaps and branches side by side, which are put on a larger sheet as a whole. */

import type { Block, Cell, Gap, Lane, Wrap } from './arrangement'

export class Sheet {
  readonly cells: Cell[] = []
  readonly gaps: Gap[] = []
  readonly blocks: Block[] = []
  readonly wraps: Wrap[] = []
  w = 0
  h = 0
  /** The room that conditions take above its first row. */
  above = 0

  /** Put another one on this one. */
  take(other: Sheet, dx: number, dy: number): void {
    const move = (at: { x: number; y: number }): void => {
      at.x += dx
      at.y += dy
    }
    for (const list of [other.cells, other.gaps, other.blocks]) list.forEach(move)
    for (const block of other.blocks)
      block.lanes.splice(0, block.lanes.length, ...block.lanes.map((lane) => moved(lane, dx, dy)))
    for (const wrap of other.wraps) {
      wrap.right += dx
      wrap.left += dx
      wrap.y += dy
      wrap.next += dy
    }
    // not spread into arguments: a flow may hold thousands
    for (const cell of other.cells) this.cells.push(cell)
    for (const gap of other.gaps) this.gaps.push(gap)
    for (const block of other.blocks) this.blocks.push(block)
    for (const wrap of other.wraps) this.wraps.push(wrap)
  }
}

export const moved = (lane: Lane, dx: number, dy: number): Lane => ({
  ...lane,
  x: lane.x + dx,
  y: lane.y + dy,
  endX: lane.endX + dx,
  endY: lane.endY + dy,
})
