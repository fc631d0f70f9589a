// A picture being drawn: each stroke is a step that can be taken back.
import { flooded, painted, withEllipse, withLine, withRectangle, type Picture } from '../geom/pixels'
import type { Cell } from '../geom/strokes'
import type { TextKey } from '../texts/index.svelte'

export const TOOLS = ['pen', 'line', 'rectangle', 'circle', 'fill'] as const
export type Tool = (typeof TOOLS)[number]

/** How many times larger than to fit a picture may be painted. */
const ZOOMS = [1, 2, 3]

export const nextZoom = (zoom: number, by: number): number => Math.max(ZOOMS[0]!, Math.min(ZOOMS.at(-1)!, zoom + by))

/** The name of a colour, by its digit. */
export const inkName = (digit: string): TextKey => `paint.ink${digit as '0'}`

export interface Drawing {
  readonly picture: Picture
  readonly past: readonly Picture[]
  readonly future: readonly Picture[]
}

export const begun = (picture: Picture): Drawing => ({ picture, past: [], future: [] })

/** After a step; one that changes nothing is none. */
export function after(drawing: Drawing, picture: Picture): Drawing {
  if (picture === drawing.picture) return drawing
  return { picture, past: [...drawing.past, drawing.picture], future: [] }
}

export function undone(drawing: Drawing): Drawing {
  const before = drawing.past.at(-1)
  if (before === undefined) return drawing
  return { picture: before, past: drawing.past.slice(0, -1), future: [drawing.picture, ...drawing.future] }
}

export function redone(drawing: Drawing): Drawing {
  const [next, ...future] = drawing.future
  return next === undefined ? drawing : { picture: next, past: [...drawing.past, drawing.picture], future }
}

/** One stroke in the making: a pen collects where it went, the other tools reach from the first cell to the last. */
export class Stroke {
  readonly digit: string
  private readonly base: Picture
  private trail: Picture
  private last: Cell

  constructor(
    readonly tool: Tool,
    base: Picture,
    readonly first: Cell,
    digit: string,
    private readonly isFilled = false,
  ) {
    this.digit = digit
    this.base = base
    this.last = first
    this.trail = painted(base, [first], digit)
  }

  /** The picture as it would be if the stroke ended at this cell. */
  to(cell: Cell): Picture {
    const { tool, base, first, digit, isFilled } = this
    switch (tool) {
      case 'pen':
        this.trail = withLine(this.trail, this.last, cell, digit)
        this.last = cell
        return this.trail
      case 'line':
        return withLine(base, first, cell, digit)
      case 'rectangle':
        return withRectangle(base, first, cell, digit, isFilled)
      case 'circle':
        return withEllipse(base, first, cell, digit, isFilled)
      case 'fill':
        return flooded(base, cell, digit)
    }
  }
}
