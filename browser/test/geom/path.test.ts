import { expect, test } from 'vitest'
import { pathOf } from '../../src/geom/path'

test('corners are rounded and lines are straight', () => {
  expect(
    pathOf([
      [0, 0],
      [100, 0],
      [100, 50],
    ]),
  ).toBe('M0 0L95 0Q100 0 100 5L100 50')
})

test('a short piece between two corners gives each half of it', () => {
  expect(
    pathOf([
      [0, 0],
      [50, 0],
      [50, 4],
      [100, 4],
    ]),
  ).toBe('M0 0L48 0Q50 0 50 2L50 2Q50 4 52 4L100 4')
})

test('wires of one piece, of a point and of nothing', () => {
  expect(
    pathOf([
      [0, 0],
      [10, 0],
    ]),
  ).toBe('M0 0L10 0')
  expect(pathOf([[3, 4]])).toBe('M3 4')
  expect(pathOf([])).toBe('')
})

test('a point that stands twice does no harm', () => {
  expect(
    pathOf([
      [0, 0],
      [10, 0],
      [10, 0],
      [10, 20],
    ]),
  ).not.toContain('NaN')
})

test('numbers are short', () => {
  expect(
    pathOf([
      [0.123456, 0],
      [10, 0],
    ]),
  ).toBe('M0.12 0L10 0')
})
