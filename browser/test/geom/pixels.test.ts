import { describe, expect, test } from 'vitest'
import { nearestDigit, PALETTE, rgbOf } from '../../src/geom/palette'
import {
  at,
  blank,
  flooded,
  fromRgba,
  isPicture,
  mirrored,
  painted,
  resized,
  rowsOf,
  SIZES,
  sizeOf,
  withEllipse,
  withLine,
  withRectangle,
  type Picture,
} from '../../src/geom/pixels'
import { chance } from './scenes'

const count = (picture: Picture, digit: string) => [...picture].filter((one) => one === digit).length

/** Each pixel of a picture as four bytes. */
const bytes = (text: string) =>
  new Uint8ClampedArray([...text].flatMap((digit) => [...rgbOf(PALETTE[+digit].hex), 255]))

describe('a picture', () => {
  test('is 32 rows of 32 digits, white within a black border', () => {
    // R-B11
    expect(isPicture(blank())).toBe(true)
    expect([count(blank(), '7'), count(blank(), '8')]).toEqual([900, 124])
    expect(rowsOf(blank())[1]).toBe(`8${'7'.repeat(30)}8`)
  })

  test('is told from other texts', () => {
    expect(isPicture('7'.repeat(1024))).toBe(false)
    expect(isPicture(blank().slice(1))).toBe(false)
    expect(isPicture(blank().replace('7', '9'))).toBe(false)
  })

  test.each(SIZES)('may have %i rows and as many digits in each', (size) => {
    // R-B09
    expect(isPicture(blank(size))).toBe(true)
    expect(sizeOf(blank(size))).toBe(size)
    expect(rowsOf(blank(size))).toHaveLength(size)
    expect(isPicture('8'.repeat(40 * 40))).toBe(false)
  })

  test.each(SIZES)('of %i rows stays one, border and all, whatever is drawn on it', (size) => {
    // R-D07, R-B09
    const next = chance(6)
    const place = (): number => Math.floor(next() * (size + 8)) - 4
    const cell = (): [number, number] => [place(), place()]
    let picture = blank(size)
    for (let k = 0; k < 400; k++) {
      const digit = String(Math.floor(next() * 9))
      const tools = [
        () => withLine(picture, cell(), cell(), digit),
        () => withRectangle(picture, cell(), cell(), digit, next() < 0.5),
        () => withEllipse(picture, cell(), cell(), digit, next() < 0.5),
        () => flooded(picture, cell(), digit),
        () => mirrored(picture, next() < 0.5),
      ]
      picture = tools[k % tools.length]()
      expect(isPicture(picture) && sizeOf(picture) === size).toBe(true)
    }
  })

  test('that grew and shrinks again is as it was, from every size to every larger one', () => {
    // R-B09
    const next = chance(7)
    for (const size of SIZES) {
      let picture = blank(size)
      for (let k = 0; k < 200; k++) {
        const cell = [1 + Math.floor(next() * (size - 2)), 1 + Math.floor(next() * (size - 2))] as const
        picture = painted(picture, [cell], String(Math.floor(next() * 9)))
      }
      for (const larger of SIZES.filter((other) => other >= size)) {
        expect(isPicture(resized(picture, larger))).toBe(true)
        expect(resized(resized(picture, larger), size)).toBe(picture)
      }
    }
  })

  test('keeps its shape at another size', () => {
    // R-B09
    const half = withRectangle(blank(), [1, 1], [15, 30], '0', true)
    expect(count(resized(half, 64), '0')).toBe(31 * 62)
    expect(sizeOf(resized(half, 48))).toBe(48)
    expect(at(resized(half, 64), 1, 1)).toBe('0')
    expect(at(resized(half, 64), 62, 62)).toBe('7')
  })
})

describe('the tools', () => {
  test("a pen's stroke has no gaps and both of its ends", () => {
    // R-D07
    const picture = withLine(blank(), [3, 4], [20, 11], '0')
    expect([at(picture, 3, 4), at(picture, 20, 11)]).toEqual(['0', '0'])
    expect(count(picture, '0')).toBe(18)
    expect(withLine(blank(), [5, 5], [5, 5], '0')).toBe(painted(blank(), [[5, 5]], '0'))
  })

  test('a rectangle is an outline, or filled, whichever corner comes first', () => {
    // R-D07
    expect(count(withRectangle(blank(), [5, 5], [9, 8], '1'), '1')).toBe(14)
    expect(count(withRectangle(blank(), [9, 8], [5, 5], '1', true), '1')).toBe(20)
  })

  test('a circle touches all four sides of its box and not its corners', () => {
    // R-D07
    const picture = withEllipse(blank(), [5, 5], [15, 15], '2')
    expect([at(picture, 10, 5), at(picture, 10, 15), at(picture, 5, 10), at(picture, 15, 10)].join('')).toBe('2222')
    expect([at(picture, 5, 5), at(picture, 10, 10)]).toEqual(['7', '7'])
    expect(mirrored(picture)).toBe(withEllipse(blank(), [16, 5], [26, 15], '2'))
  })

  test('the outline of a circle holds what is filled into it', () => {
    // R-D07
    const outline = withEllipse(blank(), [5, 5], [24, 18], '2')
    expect(flooded(outline, [14, 11], '2')).toBe(withEllipse(blank(), [5, 5], [24, 18], '2', true))
  })

  test('filling stops at other colours and at the border, and not at corners', () => {
    // R-D07
    const walled = withRectangle(blank(), [5, 5], [9, 9], '0')
    expect(count(flooded(walled, [7, 7], '3'), '3')).toBe(9)
    expect(count(flooded(blank(), [1, 1], '3'), '3')).toBe(900)
    expect(flooded(blank(), [0, 0], '3')).toBe(blank())
  })

  test('mirroring twice gives the picture back', () => {
    const picture = withLine(blank(), [3, 4], [20, 11], '0')
    expect(mirrored(mirrored(picture))).toBe(picture)
    expect(mirrored(mirrored(picture, true), true)).toBe(picture)
    expect(at(mirrored(picture), 28, 4)).toBe('0')
  })
})

describe('an image', () => {
  test('of 30 x 30 pixels in the colours of the palette comes back as it was', () => {
    const next = chance(8)
    const digits = Array.from({ length: 900 }, () => String(Math.floor(next() * 9))).join('')
    const picture = fromRgba(bytes(digits), 30, 30)
    expect(
      rowsOf(picture)
        .slice(1, 31)
        .map((row) => row.slice(1, 31))
        .join(''),
    ).toBe(digits)
    expect(isPicture(picture)).toBe(true)
  })

  test('comes as many cells wide as are wished', () => {
    // R-B09
    const digits = Array.from({ length: 62 * 62 }, (_, k) => String(k % 9)).join('')
    const picture = fromRgba(bytes(digits), 62, 62, 64)
    expect(sizeOf(picture)).toBe(64)
    expect(
      rowsOf(picture)
        .slice(1, 63)
        .map((row) => row.slice(1, 63))
        .join(''),
    ).toBe(digits)
  })

  test('that is larger is averaged', () => {
    const shade = (k: number) => ((k + Math.floor(k / 60)) % 2 ? 0 : 255)
    const checks = Array.from({ length: 3600 }, (_, k) => [shade(k), shade(k), shade(k), 255]).flat()
    expect(count(fromRgba(checks, 60, 60), '6')).toBe(900) // black and white in equal parts are grey
  })

  test('that is wide stands in the middle with white above and below', () => {
    const picture = fromRgba(bytes('0'.repeat(60 * 20)), 60, 20)
    expect(count(picture, '0')).toBe(300)
    expect([10, 11, 20, 21].map((y) => at(picture, 16, y)).join('')).toBe('7007')
  })

  test('that is transparent is white, and one without its bytes is refused', () => {
    expect(fromRgba(new Uint8ClampedArray(100 * 4), 10, 10)).toBe(blank())
    expect(() => fromRgba([1, 2, 3], 1, 1)).toThrow('expected 1 x 1 x 4 bytes')
  })

  test('has each colour of the palette for its own nearest', () => {
    const colours = PALETTE.map((colour) => rgbOf(colour.hex))
    expect(colours.map((rgb) => nearestDigit(rgb, colours)).join('')).toBe('012345678')
  })
})
