/** Where the onikons of flows stand: in rows that wrap around, an action in one row with its targets (§5.5.5). */

import { onikonWidth } from './jigsaw'
import type { Pt } from './rect'

/** What the layout must know of an onikon or hole: whether it belongs to the one before it. */
export interface Step {
  readonly joined: boolean
}

export interface Frame {
  readonly width: number
  /** The side of a picture. */
  readonly size: number
  readonly left: number
  readonly top: number
  /** Between two rows of a flow: room for marks beneath and above; between two flows: for the name as well. */
  readonly rowGap: number
  readonly flowGap: number
}

export const FRAME = { left: 20, top: 24, rowGap: 30, flowGap: 48 }

export interface Place {
  readonly x: number
  readonly y: number
  readonly row: number
}

export interface PlacedFlow {
  readonly places: readonly Place[]
  /** The lines of the arrows from the end of a row to the beginning of the next. */
  readonly wraps: readonly (readonly Pt[])[]
  readonly y: number
  readonly height: number
}

/** All flows, one below the other, and the height they take. */
export function layOut(flows: readonly (readonly Step[])[], frame: Frame): { flows: PlacedFlow[]; height: number } {
  const placed: PlacedFlow[] = []
  let y = frame.top
  for (const steps of flows) {
    const flow = placeFlow(steps, frame, y)
    placed.push(flow)
    y += flow.height + frame.flowGap
  }
  return { flows: placed, height: placed.length ? y - frame.flowGap + frame.rowGap : y }
}

function placeFlow(steps: readonly Step[], frame: Frame, y: number): PlacedFlow {
  const width = onikonWidth(frame.size)
  const pitch = frame.size + frame.rowGap
  const perRow = Math.max(1, Math.floor((frame.width - 2 * frame.left) / width))
  const places: Place[] = []
  let [row, column] = [0, 0]
  for (const group of groups(steps)) {
    if (column > 0 && column + group > perRow) [row, column] = [row + 1, 0]
    for (let k = 0; k < group; k++) {
      if (column === perRow) [row, column] = [row + 1, 0] // a group longer than a row: it cannot but be split
      places.push({ x: frame.left + column * width, y: y + row * pitch, row })
      column++
    }
  }
  return { places, wraps: wrapsOf(places, frame), y, height: row * pitch + frame.size }
}

/** The lengths of the groups that stay together. */
function groups(steps: readonly Step[]): number[] {
  const lengths: number[] = []
  for (const step of steps) {
    if (step.joined && lengths.length) lengths[lengths.length - 1]++
    else lengths.push(1)
  }
  return lengths
}

function wrapsOf(places: readonly Place[], frame: Frame): Pt[][] {
  const wraps: Pt[][] = []
  for (let k = 1; k < places.length; k++) {
    const [a, b] = [places[k - 1], places[k]]
    if (a.row === b.row) continue
    const [right, left] = [a.x + onikonWidth(frame.size), b.x]
    const between = b.y - frame.rowGap / 2
    const [from, to] = [a.y + frame.size / 2, b.y + frame.size / 2]
    const [out, back] = [right + 9, left - 9]
    wraps.push([[right, from], [out, from], [out, between], [back, between], [back, to], [left, to]])
  }
  return wraps
}

/** A place where something can be inserted: before the onikon of this index, or at the end. */
export interface Slot {
  readonly flow: number
  readonly index: number
  readonly x: number
  readonly y: number
}

/** All slots; where a row wraps, one at the end of the row and one at the beginning of the next mean the same. */
export function slots(flows: readonly PlacedFlow[], size: number): Slot[] {
  return flows.flatMap(({ places }, flow) =>
    places.flatMap(({ x, y, row }, index) => {
      const own = { flow, index, x, y }
      const wraps = index + 1 < places.length && places[index + 1].row !== row
      const after = { flow, index: index + 1, x: x + onikonWidth(size), y }
      return wraps || index + 1 === places.length ? [own, after] : [own]
    }),
  )
}

/** The slot a pointer is at: the nearest in its row; null where it is in none. */
export function slotAt(all: readonly Slot[], [x, y]: Pt, size: number, reach = 15): Slot | null {
  let best: Slot | null = null
  for (const slot of all) {
    if (y < slot.y - reach || y > slot.y + size + reach || Math.abs(x - slot.x) > onikonWidth(size)) continue
    if (!best || Math.abs(x - slot.x) < Math.abs(x - best.x)) best = slot
  }
  return best
}
