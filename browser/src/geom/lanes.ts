/** Wires drawn side by side: overlapping inner segments of different variables get parallel lanes. */

import { grown, type Area, type Pt } from './rect'
import type { Obstacles } from './obstacles'
import { tidy } from './router'
import { Bands, segmentsOf, withJogs, type Segment } from './segment'
import { GAP, separate, type Room } from './separate'

/** Lines nearer than this are laid out together. */
const REACH = 12
/** The farthest a segment moves from its line. */
const MOST = 30
/** What stays free between a moved segment and a box. */
const AIR = 2

interface Wire {
  readonly points: readonly Pt[]
  readonly segments: readonly Segment[]
  drawn: Pt[]
}

/**
 * First all vertical segments find their lanes, then the horizontal ones between them: so each is moved once, over an
 * area known to be free, and a moved segment only lengthens its neighbours within that area.
 */
export class Lanes {
  private readonly wires = new Map<string, Wire>()
  private readonly vertical = new Bands()
  private readonly horizontal = new Bands()
  private readonly restless = new Set<Segment>() // what changed, or lay beside what changed
  private readonly changed = new Set<string>()
  private readonly obstacles: Obstacles
  /** How far lines that run side by side are apart, in pixels. */
  gap = GAP

  constructor(obstacles: Obstacles) {
    this.obstacles = obstacles
  }

  /** Take in the route of a wire, in place of an earlier one. */
  set(link: string, svar: string, route: readonly Pt[]): void {
    this.remove(link)
    const points = withJogs(route)
    const segments = segmentsOf(link, svar, points)
    this.wires.set(link, { points, segments, drawn: route.slice() })
    for (const segment of segments) {
      if (segment.hold === 'jog') continue
      this.bands(segment).add(segment)
      this.restless.add(segment)
    }
    this.changed.add(link)
  }

  remove(link: string): void {
    const wire = this.wires.get(link)
    if (!wire) return
    this.wires.delete(link)
    this.changed.delete(link)
    const segments = wire.segments.filter((segment) => segment.hold !== 'jog')
    for (const segment of segments) this.bands(segment).drop(segment)
    for (const segment of segments) {
      this.restless.delete(segment)
      for (const other of this.bands(segment).beside(segment, REACH)) this.restless.add(other)
    }
  }

  /** The corners of a wire as it is drawn; it must be known. */
  drawn(link: string): Pt[] {
    return this.wires.get(link)!.drawn
  }

  /** Lay out anew what changed since the last time; the wires that are drawn differently now. */
  settle(): Set<string> {
    this.layOut(
      this.vertical,
      [...this.restless].filter((s) => s.vertical),
    )
    for (const link of this.changed) this.stretch(this.wires.get(link)!)
    this.layOut(
      this.horizontal,
      [...this.restless].filter((s) => !s.vertical),
    )
    for (const link of this.changed) redraw(this.wires.get(link)!)
    const changed = new Set(this.changed)
    this.restless.clear()
    this.changed.clear()
    return changed
  }

  private bands(segment: Segment): Bands {
    return segment.vertical ? this.vertical : this.horizontal
  }

  private layOut(bands: Bands, start: readonly Segment[]): void {
    const seen = new Set<Segment>()
    for (const segment of start) {
      if (seen.has(segment)) continue
      const cluster = clusterOf(bands, segment, seen)
      const before = cluster.map((s) => s.at)
      separate(cluster, (s) => this.room(s), this.gap)
      cluster.forEach((s, k) => {
        if (s.at !== before[k]) this.changed.add(s.link)
      })
    }
  }

  /** After the vertical segments moved: the horizontal ones between them reach from one to the other. */
  private stretch(wire: Wire): void {
    wire.segments.forEach((segment, k) => {
      if (segment.vertical || segment.hold === 'jog') return
      const a = wire.segments[k - 1]?.at ?? wire.points[k][0]
      const b = wire.segments[k + 1]?.at ?? wire.points[k + 1][0]
      segment.lo = Math.min(a, b)
      segment.hi = Math.max(a, b)
      this.restless.add(segment)
    })
  }

  /** How far a segment may be moved before it comes to a box or to the locus of another variable. */
  private room(segment: Segment): Room {
    const { line, lo, hi, vertical, svar } = segment
    const swept: Area = vertical
      ? { x0: line - MOST, x1: line + MOST, y0: lo, y1: hi }
      : { x0: lo, x1: hi, y0: line - MOST, y1: line + MOST }
    let [min, max] = [line - MOST, line + MOST]
    const keepOff = (o: Area, air: number): void => {
      const [from, to] = vertical ? [o.y0, o.y1] : [o.x0, o.x1]
      if (from >= hi || to <= lo) return // beside the ends: the neighbouring segments never get there
      const [near, far] = vertical ? [o.x0, o.x1] : [o.y0, o.y1]
      if (far <= line) min = Math.max(min, Math.min(far + air, line))
      else if (near >= line) max = Math.min(max, Math.max(near - air, line))
      else if (air > 0) min = max = line // within a box already: the wire's end lies under it
    }
    for (const box of this.obstacles.boxesNear(grown(swept, AIR))) keepOff(box, AIR)
    for (const locus of this.obstacles.foreignLoci(swept, svar)) keepOff(locus, 0)
    return min <= line && max >= line ? { min, max } : { min: line, max: line }
  }
}

function clusterOf(bands: Bands, first: Segment, seen: Set<Segment>): Segment[] {
  const cluster = [first]
  seen.add(first)
  for (let k = 0; k < cluster.length; k++) {
    for (const other of bands.beside(cluster[k], REACH)) {
      if (seen.has(other)) continue
      seen.add(other)
      cluster.push(other)
    }
  }
  return cluster
}

function redraw(wire: Wire): void {
  const { points, segments } = wire
  const corners = points.map((p, k): Pt => {
    if (k === 0 || k === points.length - 1) return p
    const [before, next] = [segments[k - 1], segments[k]]
    return before.vertical ? [before.at, next.at] : [next.at, before.at]
  })
  wire.drawn = tidy(corners)
}
