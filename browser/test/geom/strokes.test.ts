import { expect, test } from 'vitest'
import { ellipse, line, rectangle, type Cell } from '../../src/geom/strokes'

/** One end of a line in each direction. */
const ends: Cell[] = Array.from({ length: 9 * 9 }, (_, k) => [(k % 9) - 4, Math.floor(k / 9) - 4])

test('a line has one cell for each step along its longer direction, none far from the straight', () => {
  for (const [x, y] of ends) {
    const steps = Math.max(Math.abs(x), Math.abs(y))
    const cells = line([0, 0], [x, y])
    expect(cells.length).toBe(steps + 1)
    cells.forEach(([cx, cy], k) => {
      expect(Math.abs(cx - (x * k) / Math.max(steps, 1))).toBeLessThanOrEqual(0.5)
      expect(Math.abs(cy - (y * k) / Math.max(steps, 1))).toBeLessThanOrEqual(0.5)
    })
  }
})

test('figures in one cell are that cell', () => {
  expect(rectangle([3, 4], [3, 4], false)).toEqual([[3, 4]])
  expect(ellipse([3, 4], [3, 4], false)).toEqual([[3, 4]])
})

test('an ellipse is as wide and high as its box, whichever corner comes first', () => {
  for (const [x, y] of ends) {
    const cells = ellipse([0, 0], [x, y], false)
    const [xs, ys] = [cells.map((cell) => cell[0]), cells.map((cell) => cell[1])]
    expect([Math.min(...xs), Math.max(...xs)]).toEqual([Math.min(0, x), Math.max(0, x)])
    expect([Math.min(...ys), Math.max(...ys)]).toEqual([Math.min(0, y), Math.max(0, y)])
    expect(new Set(ellipse([x, y], [0, 0], false).map(String))).toEqual(new Set(cells.map(String)))
  }
})
