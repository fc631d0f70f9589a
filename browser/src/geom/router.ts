/** Routes of wires: horizontal and vertical lines from a pin to its locus, around the boxes (§5.3.5). */

import { Grid } from './grid'
import { cleared, PAD, type Obstacle, type Obstacles, type Side } from './obstacles'
import { grown, holds, span, type Area, type Pt } from './rect'
import { Search } from './search'

/** Where a wire begins: a point on the side of a box. */
export interface PinPlace {
  readonly box: string
  readonly side: Side
  readonly x: number
  readonly y: number
}

/** How far around its two ends a way is looked for, one after the other; then around everything. */
const MARGINS = [40, 160, 640]

export class Router {
  private readonly grid = new Grid()
  private readonly search = new Search()
  private readonly obstacles: Obstacles

  constructor(obstacles: Obstacles) {
    this.obstacles = obstacles
  }

  /** The corners of a wire; there always is one, and it crosses a box only where its own end lies within one. */
  route(pin: PinPlace, locus: Pt, svar: string): Pt[] {
    const start = this.stub(pin, locus)
    const way = this.around(start, locus, svar) ?? [start, [locus[0], start[1]], locus]
    return tidy([[pin.x, pin.y], ...way])
  }

  /** The end of the stub that leads away from the box: on the widened side, or above a locus that lies nearer. */
  private stub(pin: PinPlace, locus: Pt): Pt {
    const { wide } = this.obstacles.box(pin.box)
    const out = pin.side === 'right' ? 1 : -1
    const length = pin.side === 'right' ? wide.x1 - pin.x : pin.x - wide.x0
    const reach = (locus[0] - pin.x) * out
    const near = reach >= 0 && reach < length && holds(wide, locus)
    return [pin.x + out * (near ? reach : length), pin.y]
  }

  private around(start: Pt, goal: Pt, svar: string): Pt[] | null {
    const ends = span([start, goal])
    for (const margin of MARGINS) {
      const way = this.within(grown(ends, margin), start, goal, svar)
      if (way) return way
      if (this.search.enclosed) return null
    }
    const all = this.obstacles.bounds()
    return all && this.within(grown(all, 2 * PAD), start, goal, svar)
  }

  /**
   * Only obstacles that a way has met are laid: the cheapest way around some, where it meets no others, is the cheapest
   * around all. So a wire through thousands of boxes is looked for among the few in its way.
   */
  private within(region: Area, start: Pt, goal: Pt, svar: string): Pt[] | null {
    const met = new Map<Obstacle, Area>()
    for (;;) {
      this.grid.lay([...met.values()], [start, goal], region)
      const way = this.search.find(this.grid, start, goal)
      if (!way || !this.meets(way, svar, met)) return way
    }
  }

  /** Whether a way leads through obstacles that were not met so far; now they are. */
  private meets(way: readonly Pt[], svar: string, met: Map<Obstacle, Area>): boolean {
    const [start, goal] = [way[0], way[way.length - 1]]
    const before = met.size
    for (const [a, b] of sections(way))
      for (const obstacle of this.obstacles.blocking(span([a, b]), svar)) {
        if (met.has(obstacle)) continue
        const area = cleared(cleared(obstacle.wide, obstacle.core, start), obstacle.core, goal)
        if (crosses(a, b, area)) met.set(obstacle, area)
      }
    return met.size > before
  }
}

/** The straight parts of a way. */
function* sections(way: readonly Pt[]): Generator<readonly [Pt, Pt]> {
  const corners = tidy(way)
  for (let k = 0; k + 1 < corners.length; k++) yield [corners[k], corners[k + 1]]
}

/** Whether a straight part leads through the inside of an area. */
function crosses(a: Pt, b: Pt, area: Area): boolean {
  const [x0, x1] = a[0] < b[0] ? [a[0], b[0]] : [b[0], a[0]]
  const [y0, y1] = a[1] < b[1] ? [a[1], b[1]] : [b[1], a[1]]
  return x1 > area.x0 && x0 < area.x1 && y1 > area.y0 && y0 < area.y1
}

/** The corners alone: without points twice and without points on the way between two others. */
export function tidy(points: readonly Pt[]): Pt[] {
  const corners: Pt[] = []
  for (const p of points) {
    const n = corners.length
    if (n > 0 && corners[n - 1][0] === p[0] && corners[n - 1][1] === p[1]) continue
    if (n > 1 && aligned(corners[n - 2], corners[n - 1], p)) corners[n - 1] = p
    else corners.push(p)
  }
  return corners
}

const aligned = (a: Pt, b: Pt, c: Pt): boolean => (a[0] === b[0] && b[0] === c[0]) || (a[1] === b[1] && b[1] === c[1])
