/** Walking from box to box with the arrow keys. */

import type { Rect } from './rect'

export type Direction = 'left' | 'right' | 'up' | 'down'

export interface Named extends Rect {
  readonly id: string
}

/** How much a step aside counts against a step ahead. */
const ASIDE = 3

/** The box one comes to from `from` in a direction; null where there is none. */
export function neighbour(from: Rect, direction: Direction, boxes: Iterable<Named>): string | null {
  let best: { id: string; cost: number } | null = null
  for (const box of boxes) {
    const { ahead, aside } = distance(from, direction, box)
    if (ahead <= 0) continue
    const cost = ahead + ASIDE * aside
    if (!best || cost < best.cost || (cost === best.cost && box.id < best.id)) best = { id: box.id, cost }
  }
  return best?.id ?? null
}

/** How far a box lies ahead, from centre to centre, and how far aside: hardly, while the two are level. */
function distance(from: Rect, direction: Direction, to: Rect): { ahead: number; aside: number } {
  const level = direction === 'left' || direction === 'right'
  const sign = direction === 'right' || direction === 'down' ? 1 : -1
  const [dx, dy] = [to.x + to.w / 2 - from.x - from.w / 2, to.y + to.h / 2 - from.y - from.h / 2]
  const gap = level
    ? Math.max(to.y - from.y - from.h, from.y - to.y - to.h)
    : Math.max(to.x - from.x - from.w, from.x - to.x - to.w)
  // A little for being off centre, so that of two boxes level with this one the straighter way wins.
  return { ahead: sign * (level ? dx : dy), aside: Math.max(gap, 0) + Math.abs(level ? dy : dx) / 20 }
}

/** All boxes in reading order: by rows, each from left to right. The order of the Tab key. */
export function inReadingOrder<T extends Rect>(boxes: Iterable<T>): T[] {
  const left = [...boxes].sort((a, b) => a.y - b.y || a.x - b.x)
  const out: T[] = []
  while (left.length) {
    const bottom = left[0].y + left[0].h / 2 // those that begin above the middle of the topmost box are in its row
    const row = left.filter((box) => box.y <= bottom).sort((a, b) => a.x - b.x)
    out.push(...row)
    for (const box of row) left.splice(left.indexOf(box), 1)
  }
  return out
}
