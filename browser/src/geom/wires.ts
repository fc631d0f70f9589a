/** The wires of a configuration: it knows boxes, pins and loci, and keeps the routes between them up to date. */

import { Lanes } from './lanes'
import { Obstacles, PAD, type Side } from './obstacles'
import { areaOf, around, grown, span, touches, type Area, type Pt, type Rect } from './rect'
import { Router, type PinPlace } from './router'

/** A pin of a task box: on its left or right side, `dy` below its top. */
export interface Pin {
  readonly id: string
  readonly svar: string
  readonly side: Side
  readonly dy: number
}

interface Link {
  readonly id: string
  readonly svar: string
  readonly pin: PinPlace
  /** The way before lanes, and the area that it and the drawn wire take; null while there is no locus to lead to. */
  route: Pt[] | null
  area: Area | null
}

interface Locus {
  readonly place: Pt
  readonly shown: boolean
}

export const linkId = (box: string, pin: string): string => `${box}/${pin}`

/**
 * Moving a box looks anew for the ways of its own wires and of those that touch the place it leaves or takes, and for
 * no others: the rest of the picture stays as the user knows it. `settle` looks for all of them anew.
 */
export class Wires {
  private readonly obstacles = new Obstacles()
  private readonly router = new Router(this.obstacles)
  private readonly lanes = new Lanes(this.obstacles)
  private readonly boxes = new Map<string, { area: Area; links: Link[] }>()
  private readonly loci = new Map<string, Locus>()
  private readonly ofSvar = new Map<string, Set<Link>>()
  private readonly links = new Map<string, Link>()
  private readonly stale = new Set<Link>()
  private readonly drawn = new Map<string, Pt[]>()
  private changed = new Set<string>()

  /** Put a box there, or move it, or change its pins. */
  setBox(id: string, rect: Rect, pins: readonly Pin[]): void {
    this.removeBox(id)
    this.obstacles.setBox(id, rect)
    const links = pins.map((pin) => newLink(id, rect, pin))
    this.boxes.set(id, { area: areaOf(rect), links })
    this.disturb(areaOf(rect, PAD))
    for (const link of links) this.addLink(link)
  }

  removeBox(id: string): void {
    const box = this.boxes.get(id)
    if (!box) return
    this.boxes.delete(id)
    this.obstacles.removeBox(id)
    for (const link of box.links) this.dropLink(link)
    this.disturb(grown(box.area, PAD))
  }

  /** Put a variable's locus there, or move it. The wires of one that is not `shown` are not drawn, its dot is. */
  setLocus(svar: string, x: number, y: number, shown = true): void {
    const old = this.loci.get(svar)
    if (old && old.place[0] === x && old.place[1] === y && old.shown === shown) return
    if (old) this.disturb(around(...old.place, PAD))
    this.obstacles.setLocus(svar, x, y)
    this.loci.set(svar, { place: [x, y], shown })
    this.disturb(around(x, y, PAD))
    this.staleSvar(svar)
  }

  removeLocus(svar: string): void {
    const old = this.loci.get(svar)
    if (!old) return
    this.loci.delete(svar)
    this.obstacles.removeLocus(svar)
    this.disturb(around(...old.place, PAD))
    this.staleSvar(svar)
  }

  /** The corners of every wire, by link (see `linkId`). It is one map, brought up to date by each call. */
  routes(): ReadonlyMap<string, Pt[]> {
    for (const link of this.stale) this.reroute(link)
    this.stale.clear()
    for (const id of this.lanes.settle()) {
      const link = this.links.get(id)!
      const drawn = this.lanes.drawn(id)
      link.area = span([...link.route!, ...drawn])
      const old = this.drawn.get(id)
      if (old && same(old, drawn)) continue
      this.drawn.set(id, drawn)
      this.changed.add(id)
    }
    return this.drawn
  }

  /** The links whose wires came, changed or went since the last call. */
  takeChanged(): ReadonlySet<string> {
    this.routes()
    const changed = this.changed
    this.changed = new Set()
    return changed
  }

  /** How far wires that run side by side are apart, in pixels: all of them are drawn anew. */
  keepApart(gap: number): void {
    if (this.lanes.gap === gap) return
    this.lanes.gap = gap
    this.settle()
  }

  /** Look for all ways anew, as when the configuration was opened. */
  settle(): void {
    for (const link of this.links.values()) this.stale.add(link)
  }

  /**
   * The wires a box would get if it were put there, by pin; nothing changes. `loci` tells where loci would stand that
   * do not exist yet or would move.
   */
  preview(rect: Rect, pins: readonly Pin[], loci: ReadonlyMap<string, Pt> = new Map()): Map<string, Pt[]> {
    const ghost = '\0ghost' // no task can have this name
    this.obstacles.setBox(ghost, rect)
    const paths = new Map<string, Pt[]>()
    for (const pin of pins) {
      const locus = loci.get(pin.svar) ?? this.loci.get(pin.svar)?.place
      if (locus) paths.set(pin.id, this.router.route(newLink(ghost, rect, pin).pin, locus, pin.svar))
    }
    this.obstacles.removeBox(ghost)
    return paths
  }

  private addLink(link: Link): void {
    this.links.set(link.id, link)
    this.stale.add(link)
    const all = this.ofSvar.get(link.svar)
    if (all) all.add(link)
    else this.ofSvar.set(link.svar, new Set([link]))
  }

  private dropLink(link: Link): void {
    this.links.delete(link.id)
    this.stale.delete(link)
    this.ofSvar.get(link.svar)!.delete(link)
    this.lanes.remove(link.id)
    if (this.drawn.delete(link.id)) this.changed.add(link.id)
  }

  private staleSvar(svar: string): void {
    for (const link of this.ofSvar.get(svar) ?? []) this.stale.add(link)
  }

  /** The wires that touch an area must find a new way. */
  private disturb(area: Area): void {
    for (const link of this.links.values()) {
      if (!link.area || !touches(link.area, area) || this.stale.has(link)) continue
      if (passes(link.route!, area) || passes(this.drawn.get(link.id)!, area)) this.stale.add(link)
    }
  }

  private reroute(link: Link): void {
    const locus = this.loci.get(link.svar)
    if (locus?.shown) {
      link.route = this.router.route(link.pin, locus.place, link.svar)
      this.lanes.set(link.id, link.svar, link.route) // even if it is the old one: there may be less room for its lanes
      return
    }
    link.route = link.area = null
    this.lanes.remove(link.id)
    if (this.drawn.delete(link.id)) this.changed.add(link.id)
  }
}

function newLink(box: string, rect: Rect, pin: Pin): Link {
  const x = pin.side === 'left' ? rect.x : rect.x + rect.w
  const place = { box, side: pin.side, x, y: rect.y + pin.dy }
  return { id: linkId(box, pin.id), svar: pin.svar, pin: place, route: null, area: null }
}

/** Whether a wire comes to an area. It is asked of all wires at every step of a drag, so it makes nothing new. */
function passes(points: readonly Pt[], area: Area): boolean {
  for (let k = 0; k + 1 < points.length; k++) {
    const [a, b] = [points[k], points[k + 1]]
    if (Math.min(a[0], b[0]) > area.x1 || Math.max(a[0], b[0]) < area.x0) continue
    if (Math.min(a[1], b[1]) <= area.y1 && Math.max(a[1], b[1]) >= area.y0) return true
  }
  return false
}

const same = (a: readonly Pt[], b: readonly Pt[]): boolean =>
  a.length === b.length && a.every((p, k) => p[0] === b[k][0] && p[1] === b[k][1])
