/** Points and rectangles of a scene, in pixels; y grows downwards. */

export type Pt = readonly [number, number]

export interface Rect {
  readonly x: number
  readonly y: number
  readonly w: number
  readonly h: number
}

/** A rectangle by its sides, the form that is quick to compare. */
export interface Area {
  readonly x0: number
  readonly y0: number
  readonly x1: number
  readonly y1: number
}

/** The sides of a rectangle, moved outwards by `pad`. */
export const areaOf = ({ x, y, w, h }: Rect, pad = 0): Area => ({
  x0: x - pad,
  y0: y - pad,
  x1: x + w + pad,
  y1: y + h + pad,
})

export const rectOf = (a: Area): Rect => ({ x: a.x0, y: a.y0, w: a.x1 - a.x0, h: a.y1 - a.y0 })

export const grown = (a: Area, pad: number): Area => ({
  x0: a.x0 - pad,
  y0: a.y0 - pad,
  x1: a.x1 + pad,
  y1: a.y1 + pad,
})

/** The square around a point. */
export const around = (x: number, y: number, pad: number): Area => ({
  x0: x - pad,
  y0: y - pad,
  x1: x + pad,
  y1: y + pad,
})

/** Whether two areas share more than a border. */
export const overlaps = (a: Area, b: Area): boolean => a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1

/** Whether two areas share at least a border. */
export const touches = (a: Area, b: Area): boolean => a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1

/** Whether a point lies within an area and not on its border. */
export const holds = (a: Area, p: Pt): boolean => p[0] > a.x0 && p[0] < a.x1 && p[1] > a.y0 && p[1] < a.y1

/** The smallest area around points, at least one. */
export function span(points: readonly Pt[]): Area {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity]
  for (const [x, y] of points) {
    if (x < x0) x0 = x
    if (x > x1) x1 = x
    if (y < y0) y0 = y
    if (y > y1) y1 = y
  }
  return { x0, y0, x1, y1 }
}

/** The smallest area around areas; null where there are none. */
export function union(areas: Iterable<Area>): Area | null {
  const corners = [...areas].flatMap(({ x0, y0, x1, y1 }): Pt[] => [
    [x0, y0],
    [x1, y1],
  ])
  return corners.length ? span(corners) : null
}
