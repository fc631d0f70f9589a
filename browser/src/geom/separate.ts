/** Segments that run side by side, moved apart into lanes; those of one variable on one line share a lane. */

import { sideBySide, type Segment } from './segment'

/** Held lanes nearer than this cannot be told apart. */
const NEAR = 2

/** How far a segment may move: from `min` to `max`. */
export interface Room {
  readonly min: number
  readonly max: number
}

interface Lane {
  readonly svar: string
  readonly line: number
  readonly segments: Segment[]
  min: number
  max: number
  /** An end of a wire is on it. */
  fixed: boolean
  /** It keeps to its line. */
  held: boolean
  lo: number
  hi: number
}

/** Between two lanes, in pixels, where nobody prefers something else. */
export const GAP = 5

/** As much of it as there is room for. */
const PARTS = [1, 0.7, 0.5, 0.3]

/** Give each segment of a cluster its place `at`, within its room and apart from those of other variables. */
export function separate(cluster: readonly Segment[], room: (segment: Segment) => Room, most = GAP): void {
  const lanes = ordered(lanesOf(cluster))
  loosen(lanes)
  for (const lane of lanes) if (!lane.held) confine(lane, room)
  const before = lanes.map((lane, j) => earlier(lanes, lane, j))
  for (const part of PARTS) {
    const { places, feasible } = placed(lanes, before, part * most)
    if (!feasible && part !== PARTS[PARTS.length - 1]) continue
    lanes.forEach((lane, k) => {
      for (const segment of lane.segments) segment.at = places[k]
    })
    return
  }
}

/** Whether two lanes must not come together: they run side by side, differ in variable, and one of them can move. */
const apart = (a: Lane, b: Lane): boolean => sideBySide(a, b) && !(a.held && b.held) && a.svar !== b.svar

/** Which of the first `count` lanes a lane must be apart from. */
function earlier(lanes: readonly Lane[], lane: Lane, count: number): number[] {
  const indices: number[] = []
  for (let i = 0; i < count; i++) if (apart(lanes[i], lane)) indices.push(i)
  return indices
}

/**
 * Places that keep `gap` between neighbours and lie as near to the lines as that allows. Pushing all to the right as
 * far as needed is one answer, all to the left another; halfway between them is one too, and it is centred. The
 * outermost answers that the rooms allow bound it. Where some corridor is too narrow, its lanes come nearer together.
 */
function placed(lanes: readonly Lane[], before: readonly (readonly number[])[], gap: number): Placing {
  const right = lanes.map((lane) => lane.line)
  const lowest = lanes.map((lane) => lane.min)
  const left = lanes.map((lane) => lane.line)
  const highest = lanes.map((lane) => lane.max)
  let feasible = true
  for (let j = 0; j < lanes.length; j++) {
    for (const i of before[j]) {
      right[j] = Math.max(right[j], right[i] + gap)
      lowest[j] = Math.max(lowest[j], lowest[i] + gap)
    }
    if (lowest[j] > lanes[j].max) [lowest[j], feasible] = [lanes[j].max, false]
  }
  for (let j = lanes.length - 1; j >= 0; j--) {
    if (highest[j] < lanes[j].min) [highest[j], feasible] = [lanes[j].min, false]
    for (const i of before[j]) {
      left[i] = Math.min(left[i], left[j] - gap)
      highest[i] = Math.min(highest[i], highest[j] - gap)
    }
  }
  const places = lanes.map((lane, k) => {
    if (lowest[k] > highest[k]) return Math.min(Math.max((lowest[k] + highest[k]) / 2, lane.min), lane.max)
    return Math.min(Math.max((right[k] + left[k]) / 2, lowest[k]), highest[k])
  })
  return { places, feasible: feasible && lanes.every((_, k) => lowest[k] <= highest[k]) }
}

interface Placing {
  readonly places: readonly number[]
  readonly feasible: boolean
}

/** Segments of one variable that overlap on one line become one lane. */
function lanesOf(cluster: readonly Segment[]): Lane[] {
  const lanes: Lane[] = []
  let lane: Lane | undefined
  for (const segment of cluster.slice().sort(byLine)) {
    const { svar, line, hold, lo, hi } = segment
    if (!lane || lane.svar !== svar || lane.line !== line || lane.hi <= lo) {
      lane = { svar, line, segments: [], min: line, max: line, fixed: false, held: false, lo, hi }
      lanes.push(lane)
    }
    lane.segments.push(segment)
    lane.fixed ||= hold === 'fixed'
    lane.held ||= hold !== 'loose'
    lane.hi = Math.max(lane.hi, hi)
  }
  return lanes
}

/** Where two lanes that would keep to their lines lie on each other, one has to move: the shorter if both can. */
function loosen(lanes: readonly Lane[]): void {
  for (const [j, lane] of lanes.entries()) {
    for (let i = j - 1; i >= 0 && lane.line - lanes[i].line < NEAR; i--) {
      const other = lanes[i]
      if (!lane.held || !other.held || other.svar === lane.svar || !sideBySide(lane, other)) continue
      const shorter = lane.hi - lane.lo < other.hi - other.lo ? lane : other
      const yielding = lane.fixed ? other : other.fixed ? lane : shorter
      yielding.held = yielding.fixed
    }
  }
}

/** A lane has the room that all its segments have. */
function confine(lane: Lane, room: (segment: Segment) => Room): void {
  ;[lane.min, lane.max] = [-Infinity, Infinity]
  for (const segment of lane.segments) {
    const { min, max } = room(segment)
    lane.min = Math.max(lane.min, min)
    lane.max = Math.min(lane.max, max)
  }
}

const byLine = (a: Segment, b: Segment): number =>
  a.line - b.line || (a.svar < b.svar ? -1 : a.svar > b.svar ? 1 : 0) || a.lo - b.lo || (a.link < b.link ? -1 : 1)

/** In the order of their lines; on one line in the order that needs the fewest crossings at the ends. */
function ordered(lanes: readonly Lane[]): Lane[] {
  const out: Lane[] = []
  for (const lane of lanes) {
    let k = out.length
    while (k > 0 && out[k - 1].line === lane.line && votes(lane, out[k - 1]) < 0) k--
    out.splice(k, 0, lane)
  }
  return out
}

/** Negative where `a` had better lie before `b`: each end that bends away within the other one would cross it. */
const votes = (a: Lane, b: Lane): number => bends(a, b) - bends(b, a)

function bends(lane: Lane, other: Lane): number {
  let sum = 0
  for (const s of lane.segments) {
    if (s.lo > other.lo && s.lo < other.hi) sum += s.bendLo
    if (s.hi > other.lo && s.hi < other.hi) sum += s.bendHi
  }
  return sum
}
