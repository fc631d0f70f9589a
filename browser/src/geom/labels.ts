/** Where the names of loci stand: in the first free of eight positions around the dot. */

import { Cells } from './cells'
import { overlaps, span, touches, type Area, type Pt } from './rect'

export interface Label {
  readonly svar: string
  /** The centre of the dot. */
  readonly x: number
  readonly y: number
  /** The size of the text. */
  readonly w: number
  readonly h: number
}

export type Position =
  'above' | 'below' | 'right' | 'left' | 'above right' | 'above left' | 'below right' | 'below left'

export interface PlacedLabel extends Area {
  readonly svar: string
  readonly position: Position
}

/** In the order they are tried: across and down from the dot, -1, 0 or 1. */
const POSITIONS: readonly [Position, number, number][] = [
  ['above', 0, -1],
  ['below', 0, 1],
  ['right', 1, 0],
  ['left', -1, 0],
  ['above right', 1, -1],
  ['above left', -1, -1],
  ['below right', 1, 1],
  ['below left', -1, 1],
]

/** From the centre of a dot to the nearest side of its label. */
const AWAY = 8
const DOT = 6

/**
 * Places for all labels, the earlier one first. None lies on a box, a dot or another label while there is such a
 * place; off the wires too if one of these is; above the dot if all eight are taken.
 */
export function placeLabels(
  labels: readonly Label[],
  boxes: readonly Area[],
  wires: Iterable<readonly Pt[]> = [],
): PlacedLabel[] {
  const taken = new Cells<Area>()
  for (const { x0, y0, x1, y1 } of boxes) taken.add({ x0, y0, x1, y1 })
  for (const { x, y } of labels) taken.add({ x0: x - DOT, y0: y - DOT, x1: x + DOT, y1: y + DOT })
  const lines = new Cells<Area>()
  for (const points of wires) for (let k = 0; k + 1 < points.length; k++) lines.add(span([points[k], points[k + 1]]))
  return labels.map((label) => {
    const places = POSITIONS.map(([position, dx, dy]) => placed(label, position, dx, dy))
    const free = places.filter((place) => !taken.near(place).some((area) => overlaps(area, place)))
    const best = free.find((place) => !lines.near(place).some((line) => touches(line, place))) ?? free[0] ?? places[0]
    taken.add(best)
    return best
  })
}

function placed({ svar, x, y, w, h }: Label, position: Position, dx: number, dy: number): PlacedLabel {
  const x0 = dx === 0 ? x - w / 2 : dx > 0 ? x + AWAY : x - AWAY - w
  const y0 = dy === 0 ? y - h / 2 : dy > 0 ? y + AWAY : y - AWAY - h
  return { svar, position, x0, y0, x1: x0 + w, y1: y0 + h }
}
