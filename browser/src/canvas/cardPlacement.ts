// Where a card lies beside its box: below it, above it, or beside it, wherever it hides least of the other boxes. A card
// has buttons; one that lies on another task would be pressed by who means that task.
import { areaOf, type Area, type Rect } from '../geom/rect'

export type Side = 'below' | 'above' | 'right' | 'left' | 'low right' | 'low left'

const GAP = 8
/** Beside a box, the card leaves room for its pins and the lines that come from them. */
const PINS = 22
const SIDES: readonly Side[] = ['below', 'above', 'right', 'left', 'low right', 'low left']

export interface Size {
  w: number
  h: number
}

/** The upper left corner of the card, from that of the box. */
export function corner(side: Side, box: Size, card: Size): { x: number; y: number } {
  const above = card.w > box.w ? -16 : 0
  if (side === 'below') return { x: above, y: box.h + GAP }
  if (side === 'above') return { x: above, y: -card.h - GAP }
  return { x: side.endsWith('right') ? box.w + PINS : -card.w - PINS, y: side.startsWith('low') ? box.h - card.h : 0 }
}

/** The side on which a card hides least and is seen most; of those that are equal the first. */
export function placeCard(box: Rect, card: Size, others: readonly Rect[], seen?: Area): Side {
  const costs = SIDES.map((side) => {
    const { x, y } = corner(side, box, card)
    const place = areaOf({ x: box.x + x, y: box.y + y, ...card })
    const hidden = others.reduce((sum, other) => sum + shared(place, areaOf(other)), 0)
    return hidden + (seen ? card.w * card.h - shared(place, seen) : 0)
  })
  return SIDES[costs.indexOf(Math.min(...costs))]!
}

function shared(a: Area, b: Area): number {
  const across = Math.min(a.x1, b.x1) - Math.max(a.x0, b.x0)
  const down = Math.min(a.y1, b.y1) - Math.max(a.y0, b.y0)
  return across > 0 && down > 0 ? across * down : 0
}
