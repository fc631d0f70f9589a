// Rows of cells: which a window sees, how the arrow keys walk them.
import { describe, expect, test } from 'vitest'
import { seen, walked } from '../../src/geom/rows'

const rows = Array.from({ length: 1000 }, (_, k) => ({ top: 10 * k, height: 10 }))

describe('a window', () => {
  test('sees the rows that it touches, and no others', () => {
    expect(seen(rows, 25, 41).map((row) => row.top)).toEqual([20, 30, 40])
  })

  test('sees nothing below the last row', () => expect(seen(rows, 20_000, 20_100)).toEqual([]))
})

describe('arrow keys', () => {
  const lines = [['a', 'b', 'c'], ['d'], ['e', 'f', 'g']]
  test.each([
    ['b', 'ArrowRight', 'c'],
    ['c', 'ArrowRight', 'd'],
    ['d', 'ArrowLeft', 'c'],
    ['c', 'ArrowDown', 'd'],
    ['g', 'ArrowUp', 'd'],
    ['a', 'ArrowUp', 'a'],
    ['b', 'End', 'g'],
    ['f', 'Home', 'a'],
    ['a', 'PageDown', 'e'],
  ])('from %s %s leads to %s', (from, key, to) => expect(walked(lines, from, key)).toBe(to))

  test('from what is not there they lead to the first', () => expect(walked(lines, 'z', 'ArrowDown')).toBe('a'))
  test('other keys lead nowhere', () => expect(walked(lines, 'a', 'x')).toBeUndefined())
})
