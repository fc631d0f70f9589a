/** Random scenes for the tests, the same ones every time. */

import { areaOf, grown, holds, overlaps, span, touches, type Area, type Pt, type Rect } from '../../src/geom/rect'
import { linkId, type Pin, Wires } from '../../src/geom/wires'

/** A small generator of numbers from 0 to 1 (mulberry32). */
export function chance(seed: number): () => number {
  let state = seed
  return () => {
    state = (state + 0x6d2b79f5) | 0
    let t = Math.imul(state ^ (state >>> 15), 1 | state)
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296
  }
}

export interface Box {
  readonly rect: Rect
  readonly pins: readonly Pin[]
}

export interface Scene {
  readonly boxes: Map<string, Box>
  readonly loci: Map<string, Pt>
}

/** Boxes with pins, at least `gap` apart, and one locus for each variable, on none of the boxes. */
export function scene(seed: number, { boxes = 20, svars = 25, gap = 10, size = 1000 } = {}): Scene {
  const next = chance(seed)
  const whole = (n: number) => Math.floor(next() * n)
  const all = new Map<string, Box>()
  for (let tries = 0; all.size < boxes && tries < 60 * boxes; tries++) {
    const rows = 1 + whole(5)
    const rect = { x: whole(size / 5) * 5, y: whole(size / 5) * 5, w: 136, h: 68 + rows * 18 }
    if ([...all.values()].some((box) => overlaps(areaOf(box.rect, gap), areaOf(rect)))) continue
    all.set(`task${all.size}`, { rect, pins: pinsOf(rows, svars, next) })
  }
  const loci = new Map<string, Pt>()
  for (let k = 0; k < svars; k++) {
    let place: Pt
    do place = [whole(size + 200) - 30, whole(size + 200) - 30]
    while ([...all.values()].some((box) => holds(areaOf(box.rect, 6), place)))
    loci.set(`v${k}`, place)
  }
  return { boxes: all, loci }
}

function pinsOf(rows: number, svars: number, next: () => number): Pin[] {
  const flip = next() < 0.3
  return Array.from({ length: 2 * rows }, (_, k) => ({
    id: `${k}`,
    svar: `v${Math.floor(next() * svars)}`,
    side: k < rows !== flip ? ('left' as const) : ('right' as const),
    dy: 46 + 9 + 18 * (k % rows),
  }))
}

/** Boxes in a grid that all touch each other, or lie `gap` apart. */
export function wall(seed: number, gap = 0): Scene {
  const open = scene(seed, { boxes: 0, svars: 12 })
  const next = chance(seed + 1000)
  const boxes = new Map<string, Box>()
  for (let k = 0; k < 12; k++) {
    const rect = { x: 200 + (k % 4) * (136 + gap), y: 200 + Math.floor(k / 4) * (122 + gap), w: 136, h: 122 }
    boxes.set(`task${k}`, { rect, pins: pinsOf(3, 12, next) })
  }
  const block = span([
    [200, 200],
    [200 + 4 * (136 + gap), 200 + 3 * (122 + gap)],
  ])
  const outside = ([x, y]: Pt): Pt => (holds(block, [x, y]) ? [x, y - 700] : [x, y])
  const loci = new Map([...open.loci].map(([svar, place]) => [svar, outside(place)]))
  return { boxes, loci }
}

export function wiresOf({ boxes, loci }: Scene): Wires {
  const wires = new Wires()
  for (const [id, { rect, pins }] of boxes) wires.setBox(id, rect, pins)
  for (const [svar, [x, y]] of loci) wires.setLocus(svar, x, y)
  return wires
}

/** The wires of one scene that are not as they should be, each with what is wrong. */
export function faults({ boxes, loci }: Scene, routes: ReadonlyMap<string, readonly Pt[]>): string[] {
  const areas = [...boxes.values()].map((box) => areaOf(box.rect))
  const found: string[] = []
  let expected = 0
  for (const [id, { rect, pins }] of boxes) {
    for (const pin of pins) {
      expected++
      const link = linkId(id, pin.id)
      const points = routes.get(link)
      if (!points) found.push(`${link}: no wire`)
      else found.push(...wireFaults(points, rect, pin, loci.get(pin.svar)!, areas).map((fault) => `${link}: ${fault}`))
    }
  }
  if (routes.size !== expected) found.push(`${routes.size} wires for ${expected} pins`)
  return found
}

function wireFaults(points: readonly Pt[], rect: Rect, pin: Pin, locus: Pt, areas: readonly Area[]): string[] {
  const found: string[] = []
  const out = pin.side === 'right' ? 1 : -1
  const [x, y] = [pin.side === 'right' ? rect.x + rect.w : rect.x, rect.y + pin.dy]
  const last = points[points.length - 1]
  if (points[0][0] !== x || points[0][1] !== y) found.push('does not begin at its pin')
  if (last[0] !== locus[0] || last[1] !== locus[1]) found.push('does not end at its locus')
  if (points.length > 1 && points[1][1] === y && (points[1][0] - x) * out < 0) found.push('leaves into its box')
  for (const piece of pieces(points)) {
    if (piece.x0 !== piece.x1 && piece.y0 !== piece.y1) found.push('is diagonal')
    if (areas.some((area) => overlaps(area, piece))) found.push('crosses a box')
  }
  return found
}

export const pieces = (points: readonly Pt[]): Area[] => points.slice(1).map((p, k) => span([points[k], p]))

/** How many wires run over the dot of another variable. */
export function overDots({ boxes, loci }: Scene, routes: ReadonlyMap<string, readonly Pt[]>): number {
  let count = 0
  for (const [id, { pins }] of boxes) {
    for (const pin of pins) {
      const own = pieces(routes.get(linkId(id, pin.id))!)
      const over = (p: Pt) => own.some((piece) => touches(grown(span([p]), 4), piece))
      if ([...loci].some(([svar, p]) => svar !== pin.svar && over(p))) count++
    }
  }
  return count
}

/** The length along which wires of different variables lie on each other; the first and last pieces count if `ends`. */
export function overlap({ boxes }: Scene, routes: ReadonlyMap<string, readonly Pt[]>, ends: boolean): number {
  const all: { svar: string; piece: Area; end: boolean }[] = []
  for (const [id, { pins }] of boxes) {
    for (const pin of pins) {
      const own = pieces(routes.get(linkId(id, pin.id))!)
      own.forEach((piece, k) => all.push({ svar: pin.svar, piece, end: k === 0 || k === own.length - 1 }))
    }
  }
  let sum = 0
  all.forEach((a, i) =>
    all.slice(0, i).forEach((b) => {
      if (a.svar === b.svar || (a.end && b.end && !ends)) return
      sum += shared(a.piece, b.piece)
    }),
  )
  return sum
}

function shared(a: Area, b: Area): number {
  const [w, h] = [Math.min(a.x1, b.x1) - Math.max(a.x0, b.x0), Math.min(a.y1, b.y1) - Math.max(a.y0, b.y0)]
  const level = a.y0 === a.y1 && b.y0 === b.y1 && Math.abs(a.y0 - b.y0) < 0.5
  const upright = a.x0 === a.x1 && b.x0 === b.x1 && Math.abs(a.x0 - b.x0) < 0.5
  return Math.max(level ? w : upright ? h : 0, 0)
}
