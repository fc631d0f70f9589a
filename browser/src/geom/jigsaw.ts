/**
 * The shapes of onikons: a picture between two bands, whose outer sides are the edges of the syntax definition
 * (§5.7.1, §A.7). The same line bounds a right edge and the left edge that fits it, so neighbours interlock.
 */

import type { Pt } from './rect'

/** Movements of the pen from the top of the outer side, for a picture of 32 pixels. */
export type Vertices = readonly Pt[]

/** A picture at its natural size; it is shown at whole multiples. */
export const PICTURE = 32
/** A band is this wide at every size: edges stretch in height only. */
export const BAND = 16

export const onikonWidth = (size: number): number => size + 2 * BAND

/** The points of an edge from its top, which is at (x, y), to its bottom. */
export function edgeLine(edge: Vertices, x: number, y: number, size: number): Pt[] {
  const points: Pt[] = [[x, y]]
  let [px, py] = [x, y]
  for (const [dx, dy] of edge) points.push([(px += dx), (py += (dy * size) / PICTURE)])
  if (px !== x || Math.abs(py - y - size) > 1e-6) points.push([x, y + size])
  return points
}

/** The band left of a picture; (x, y) is the upper left corner of the onikon. */
export const leftBand = (edge: Vertices, x: number, y: number, size: number): string =>
  closed([...edgeLine(edge, x, y, size), [x + BAND, y + size], [x + BAND, y]])

/** The band right of a picture. */
export function rightBand(edge: Vertices, x: number, y: number, size: number): string {
  const right = x + onikonWidth(size)
  return closed([...edgeLine(edge, right, y, size), [right - BAND, y + size], [right - BAND, y]])
}

/** The contour of an onikon, of a hole between the two edges it must satisfy, or of several onikons in a row. */
export function outline(left: Vertices, right: Vertices, x: number, y: number, size: number, count = 1): string {
  const end = x + count * onikonWidth(size)
  return closed([...edgeLine(left, x, y, size), ...edgeLine(right, end, y, size).reverse()])
}

const closed = (points: readonly Pt[]): string => `M${points.map((p) => p.join(' ')).join('L')}Z`
