// What is left of boxes from afar: frames and heads, joined to one outline for each state.
import type { PlacedView } from '../api.gen'
import type { Rect } from '../geom/rect'
import { looks, type State } from '../widgets/mark'

/** The parts of one box as pieces of a path; the inner frame is that of an error. */
export interface FarBox {
  readonly name: string
  readonly frame: string
  readonly head: string
  readonly inner: string
}

/** The same parts of all boxes of one look. */
export interface Outline {
  readonly look: State | 'missing'
  frame: string
  head: string
  inner: string
}

const HEAD = 40
const GAP = 1.5
const INNER = 4

export function farBox(name: string, { x, y, w, h }: Rect): FarBox {
  return {
    name,
    frame: piece(x, y, w, h),
    head: piece(x + GAP, y + GAP, w - 2 * GAP, HEAD - GAP),
    inner: piece(x + INNER, y + INNER, w - 2 * INNER, h - 2 * INNER),
  }
}

const piece = (x: number, y: number, w: number, h: number): string => `M${x} ${y}h${w}v${h}h${-w}z`

/** The outlines of these boxes by what their tasks look like, in the order in which the looks come. */
export function outlines(boxes: readonly FarBox[], tasks: Readonly<Record<string, PlacedView>>): Outline[] {
  const byLook = new Map<Outline['look'], Outline>()
  for (const { name, frame, head, inner } of boxes) {
    const placed = tasks[name]
    const look = placed?.is_missing ? 'missing' : looks(placed?.state ?? '')
    let outline = byLook.get(look)
    if (!outline) byLook.set(look, (outline = { look, frame: '', head: '', inner: '' }))
    outline.frame += frame
    outline.head += head
    if (look === 'ERROR') outline.inner += inner
  }
  return [...byLook.values()]
}
