// A configuration in small: its boxes where they stand, scaled to a field, and lines from who writes to who reads.
import type { PeekView } from '../api.gen'

export interface Box {
  name: string
  x: number
  y: number
  w: number
  h: number
}

export interface Small {
  boxes: Box[]
  /** Paths of the lines. */
  lines: string[]
}

/** A margin around, so that lines find room. */
const MARGIN = 12
/** No box is drawn larger than this share of its size. */
const LARGEST = 0.3

export function small(seen: Pick<PeekView, 'tasks' | 'wires'>, width: number, height: number): Small {
  const all = Object.entries(seen.tasks ?? {})
  if (!all.length) return { boxes: [], lines: [] }
  const left = Math.min(...all.map(([, [x]]) => x))
  const top = Math.min(...all.map(([, [, y]]) => y))
  const wide = Math.max(...all.map(([, [x, , w]]) => x + w)) - left
  const high = Math.max(...all.map(([, [, y, , h]]) => y + h)) - top
  const scale = Math.min(LARGEST, (width - 2 * MARGIN) / wide, (height - 2 * MARGIN) / high)
  const [dx, dy] = [(width - wide * scale) / 2, (height - high * scale) / 2]
  const boxes = all.map(([name, [x, y, w, h]]) => ({
    name,
    x: dx + (x - left) * scale,
    y: dy + (y - top) * scale,
    w: w * scale,
    h: h * scale,
  }))
  const of = new Map(boxes.map((box) => [box.name, box]))
  const lines = (seen.wires ?? []).flatMap(([from, to], k) => line(of.get(from), of.get(to), k, width, height))
  return { boxes, lines }
}

/** Out at the right, in at the left; what goes back runs below everything. */
function line(from: Box | undefined, to: Box | undefined, k: number, width: number, height: number): string[] {
  if (!from || !to) return []
  const shift = (k % 3) * 2
  const [ax, ay, bx, by] = [from.x + from.w, from.y + from.h * 0.45 + shift, to.x, to.y + to.h * 0.55 + shift].map(
    round,
  ) as [number, number, number, number]
  if (bx > ax) return [`M${ax} ${ay}H${round((ax + bx) / 2)}V${by}H${bx}`]
  const low = round(Math.min(height - 3, Math.max(from.y + from.h, to.y + to.h) + 4 + shift))
  return [
    `M${ax} ${ay}H${round(Math.min(width - 2, ax + 4 + shift))}V${low}H${round(Math.max(2, bx - 4 - shift))}V${by}H${bx}`,
  ]
}

const round = (value: number): number => Math.round(value * 10) / 10
