/**
 * Pictures of onikons: 32, 48 or 64 rows of as many digits, one string, never changed in place (§5.6.1, §A.3). Every
 * function here answers with a new picture, and none paints on the black border.
 */

import { nearestDigit, PALETTE, rgbOf, type Rgb } from './palette'
import { ellipse, line, rectangle, type Cell } from './strokes'

export type Picture = string

/** Cells of a row, and rows: those of the dissertation, and ours, which stand in files of version 2.0. */
export const SIZES = [32, 48, 64] as const
export type Size = (typeof SIZES)[number]
export const SIZE: Size = SIZES[0]
export const BLACK = '8'
export const WHITE = '7'

const inside = (size: number, x: number, y: number): boolean => x > 0 && y > 0 && x < size - 1 && y < size - 1

/** How many rows a picture has. */
export const sizeOf = (picture: Picture): Size => SIZES.find((size) => size * size === picture.length) ?? SIZE

/** White within the black border; what clearing leaves. */
export const blank = (size: Size = SIZE): Picture => framed(size, () => WHITE)

/** A picture of what stands at each cell within its border. */
function framed(size: Size, digitAt: (x: number, y: number) => string): Picture {
  let picture = ''
  for (let y = 0; y < size; y++) for (let x = 0; x < size; x++) picture += inside(size, x, y) ? digitAt(x, y) : BLACK
  return picture
}

/** Whether a text is a picture: digits from 0 to 8, as many as one has, black around. */
export const isPicture = (text: string): boolean =>
  /^[0-8]+$/.test(text) && text === framed(sizeOf(text), (x, y) => at(text, x, y))

export const at = (picture: Picture, x: number, y: number): string => picture[y * sizeOf(picture) + x]

export function rowsOf(picture: Picture): string[] {
  const size = sizeOf(picture)
  return Array.from({ length: size }, (_, y) => picture.slice(y * size, (y + 1) * size))
}

/** Paint cells in one colour; those on the border or outside are left out. */
export function painted(picture: Picture, cells: Iterable<Cell>, digit: string): Picture {
  const size = sizeOf(picture)
  const digits = [...picture]
  for (const [x, y] of cells) if (inside(size, x, y)) digits[y * size + x] = digit
  return digits.join('')
}

/**
 * The same picture with as many cells as this: each is as the nearest one was. So a picture that grew comes back as it
 * was, and one that shrinks loses what lies between.
 */
export function resized(picture: Picture, size: Size): Picture {
  const before = sizeOf(picture)
  const from = (cell: number): number => 1 + Math.floor(((cell - 0.5) * (before - 2)) / (size - 2))
  return before === size ? picture : framed(size, (x, y) => at(picture, from(x), from(y)))
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
  const size = sizeOf(picture)
  if (!inside(size, x, y) || at(picture, x, y) === digit) return picture
  const old = at(picture, x, y)
  const digits = [...picture]
  const open: Cell[] = [[x, y]]
  for (let cell = open.pop(); cell; cell = open.pop()) {
    const [cx, cy] = cell
    if (!inside(size, cx, cy) || digits[cy * size + cx] !== old) continue
    digits[cy * size + cx] = digit
    open.push([cx + 1, cy], [cx - 1, cy], [cx, cy + 1], [cx, cy - 1])
  }
  return digits.join('')
}

/** Left and right exchanged, or with `upright` top and bottom. */
export function mirrored(picture: Picture, upright = false): Picture {
  const size = sizeOf(picture)
  return framed(size, (x, y) => (upright ? at(picture, x, size - 1 - y) : at(picture, size - 1 - x, y)))
}

/** An image made a picture: averaged down into the border on white, proportions kept, in the nearest colours. */
export function fromRgba(
  data: ArrayLike<number>,
  w: number,
  h: number,
  size: Size = SIZE,
  palette: readonly string[] = PALETTE.map((c) => c.hex),
): Picture {
  if (data.length !== w * h * 4 || w < 1 || h < 1) {
    throw new RangeError(`expected ${w} x ${h} x 4 bytes of an image, found ${data.length}`)
  }
  const colours = palette.map(rgbOf)
  const inner = size - 2 // the side of the part that can be painted on
  const scale = Math.max(w, h) / inner // pixels of the image to one cell
  const [left, top] = [(inner - w / scale) / 2, (inner - h / scale) / 2]
  return framed(size, (x, y) => {
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
