/**
 * Pictures of onikons: 32 rows of 32 digits, one string, never changed in place (§5.6.1, §A.3). Every function here
 * answers with a new picture, and none paints on the black border.
 */

import { nearestDigit, PALETTE, rgbOf, type Rgb } from './palette'
import { ellipse, line, rectangle, type Cell } from './strokes'

export type Picture = string

export const SIZE = 32
export const BLACK = '8'
export const WHITE = '7'
/** The side of the part that can be painted on. */
const INNER = SIZE - 2

const inside = (x: number, y: number): boolean => x > 0 && y > 0 && x < SIZE - 1 && y < SIZE - 1

/** White within the black border; what clearing leaves. */
export const blank = (): Picture => drawn((x, y) => (inside(x, y) ? WHITE : BLACK))

function drawn(digitAt: (x: number, y: number) => string): Picture {
  let picture = ''
  for (let y = 0; y < SIZE; y++) for (let x = 0; x < SIZE; x++) picture += digitAt(x, y)
  return picture
}

/** Whether a text is a picture: 1024 digits from 0 to 8, black around. */
export const isPicture = (text: string): boolean =>
  /^[0-8]{1024}$/.test(text) && text === drawn((x, y) => (inside(x, y) ? at(text, x, y) : BLACK))

export const at = (picture: Picture, x: number, y: number): string => picture[y * SIZE + x]

export const rowsOf = (picture: Picture): string[] =>
  Array.from({ length: SIZE }, (_, y) => picture.slice(y * SIZE, (y + 1) * SIZE))

/** Paint cells in one colour; those on the border or outside are left out. */
export function painted(picture: Picture, cells: Iterable<Cell>, digit: string): Picture {
  const digits = [...picture]
  for (const [x, y] of cells) if (inside(x, y)) digits[y * SIZE + x] = digit
  return digits.join('')
}

/** A line; also the stroke of a pen from one cell to the next. */
export const withLine = (picture: Picture, from: Cell, to: Cell, digit: string): Picture =>
  painted(picture, line(from, to), digit)

export const withRectangle = (picture: Picture, a: Cell, b: Cell, digit: string, filled = false): Picture =>
  painted(picture, rectangle(a, b, filled), digit)

/** The ellipse in the box between two cells; a circle where that is a square. */
export const withEllipse = (picture: Picture, a: Cell, b: Cell, digit: string, filled = false): Picture =>
  painted(picture, ellipse(a, b, filled), digit)

/** Fill the patch of one colour around a cell, up to the border. */
export function flooded(picture: Picture, [x, y]: Cell, digit: string): Picture {
  if (!inside(x, y) || at(picture, x, y) === digit) return picture
  const old = at(picture, x, y)
  const digits = [...picture]
  const open: Cell[] = [[x, y]]
  for (let cell = open.pop(); cell; cell = open.pop()) {
    const [cx, cy] = cell
    if (!inside(cx, cy) || digits[cy * SIZE + cx] !== old) continue
    digits[cy * SIZE + cx] = digit
    open.push([cx + 1, cy], [cx - 1, cy], [cx, cy + 1], [cx, cy - 1])
  }
  return digits.join('')
}

/** Left and right exchanged, or with `upright` top and bottom. */
export const mirrored = (picture: Picture, upright = false): Picture =>
  drawn((x, y) => (upright ? at(picture, x, SIZE - 1 - y) : at(picture, SIZE - 1 - x, y)))

/** An image made a picture: averaged down into the border on white, proportions kept, in the nearest colours. */
export function fromRgba(
  data: ArrayLike<number>,
  w: number,
  h: number,
  palette: readonly string[] = PALETTE.map((c) => c.hex),
): Picture {
  if (data.length !== w * h * 4 || w < 1 || h < 1) {
    throw new RangeError(`expected ${w} x ${h} x 4 bytes of an image, found ${data.length}`)
  }
  const colours = palette.map(rgbOf)
  const scale = Math.max(w, h) / INNER // pixels of the image to one cell
  const [left, top] = [(INNER - w / scale) / 2, (INNER - h / scale) / 2]
  return drawn((x, y) => {
    if (!inside(x, y)) return BLACK
    const [x0, y0] = [(x - 1 - left) * scale, (y - 1 - top) * scale]
    const mean = average(data, w, h, x0, y0, scale)
    return mean ? nearestDigit(mean, colours) : WHITE
  })
}

/** The mean colour of a square of an image on white; null where the image has no part in it. */
function average(data: ArrayLike<number>, w: number, h: number, x0: number, y0: number, side: number): Rgb | null {
  const sum = [0, 0, 0]
  let covered = 0
  for (let j = Math.max(Math.floor(y0), 0); j < Math.min(y0 + side, h); j++) {
    for (let i = Math.max(Math.floor(x0), 0); i < Math.min(x0 + side, w); i++) {
      const part = (Math.min(i + 1, x0 + side) - Math.max(i, x0)) * (Math.min(j + 1, y0 + side) - Math.max(j, y0))
      if (part < 1e-9) continue
      const k = (j * w + i) * 4
      const opaque = data[k + 3] / 255
      for (const c of [0, 1, 2]) sum[c] += part * (data[k + c] * opaque + 255 * (1 - opaque))
      covered += part
    }
  }
  if (covered < 1e-9) return null
  const whole = side * side // where the image covers only part of a cell, the white around it shows
  const [r, g, b] = sum.map((s) => (s + 255 * Math.max(whole - covered, 0)) / Math.max(whole, covered))
  return [r, g, b]
}
