// The time line of a run: blocks of time laid along a line of so many pixels.
import { isOpen, type Block } from './past'

/** From when to when is shown. */
export type Window = readonly [from_s: number, to_s: number]

export interface Bar {
  block: Block
  x: number
  width: number
  isNow: boolean
  /** Whether a picture has room in it. */
  hasRoom: boolean
}

/** While a run goes on, so much of it is shown. */
const SEEN_S = 14
const LEAST_S = 4
const ROOM_PX = 19
const GAP_PX = 2
const LEAST_PX = 3
const TICKS = [0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1800, 3600]
const MOST_TICKS = 6

/** The last seconds while it goes on; all of it once it is over. */
export function windowOf(now_s: number, isOver: boolean): Window {
  const to_s = Math.max(now_s, LEAST_S)
  return [isOver ? 0 : Math.max(0, to_s - SEEN_S), to_s]
}

/** The blocks of one flow that are seen. */
export function bars(
  blocks: readonly Block[],
  flow: number,
  [from_s, to_s]: Window,
  width: number,
  now_s: number,
): Bar[] {
  const at = scale([from_s, to_s], width)
  return blocks.flatMap((block) => {
    const end_s = isOpen(block) ? now_s : block.to_s
    if (block.flow !== flow || end_s < from_s || block.from_s > to_s) return []
    const x = at(Math.max(block.from_s, from_s))
    const wide = Math.max(LEAST_PX, at(Math.min(end_s, to_s)) - x - GAP_PX)
    return [{ block, x, width: wide, isNow: isOpen(block), hasRoom: wide >= ROOM_PX }]
  })
}

/** Where a moment stands. */
export function scale([from_s, to_s]: Window, width: number): (at_s: number) => number {
  const per_s = width / Math.max(1e-9, to_s - from_s)
  return (at_s) => (at_s - from_s) * per_s
}

/** Round moments to write beneath. */
export function ticks([from_s, to_s]: Window): number[] {
  const step = TICKS.find((tick) => (to_s - from_s) / tick <= MOST_TICKS) ?? TICKS.at(-1)!
  const first = Math.ceil(from_s / step)
  return Array.from({ length: Math.max(0, Math.floor(to_s / step) - first + 1) }, (_, k) => (first + k) * step)
}
