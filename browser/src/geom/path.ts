/** The SVG path of a wire: straight lines with small round corners, and no hops where wires cross. */

import type { Pt } from './rect'

export function pathOf(points: readonly Pt[], radius = 5): string {
  if (points.length === 0) return ''
  let d = `M${pair(points[0])}`
  for (let k = 1; k + 1 < points.length; k++) {
    const [before, corner, next] = [points[k - 1], points[k], points[k + 1]]
    // Two corners share the line between them, so each takes half of it at most.
    const r = Math.min(radius, length(before, corner) / 2, length(corner, next) / 2)
    d +=
      r > 0.01
        ? `L${pair(toward(corner, before, r))}Q${pair(corner)} ${pair(toward(corner, next, r))}`
        : `L${pair(corner)}`
  }
  return points.length > 1 ? `${d}L${pair(points[points.length - 1])}` : d
}

const length = (a: Pt, b: Pt): number => Math.hypot(b[0] - a[0], b[1] - a[1])

function toward(from: Pt, to: Pt, distance: number): Pt {
  const part = distance / length(from, to)
  return [from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part]
}

/** Two digits are finer than any screen and keep the attribute short. */
const pair = (p: Pt): string => `${round(p[0])} ${round(p[1])}`
const round = (v: number): number => Math.round(v * 100) / 100
