import { expect, test } from 'vitest'
import { BAND, edgeLine, leftBand, onikonWidth, outline, rightBand, type Vertices } from '../../src/geom/jigsaw'
import type { Pt } from '../../src/geom/rect'

const JOINT: Vertices = [
  [0, 9],
  [8, 3],
  [0, 8],
  [-8, 3],
  [0, 9],
]
const NONE: Vertices = [
  [4, 16],
  [-4, 16],
]

test('an edge follows its vertices and ends at the bottom', () => {
  // R-D02
  const points = [
    [100, 10],
    [100, 19],
    [108, 22],
    [108, 30],
    [100, 33],
    [100, 42],
  ]
  expect(edgeLine(JOINT, 100, 10, 32)).toEqual(points)
})

test('edges stretch in height only', () => {
  expect(edgeLine(NONE, 0, 0, 64)).toEqual([
    [0, 0],
    [4, 32],
    [0, 64],
  ])
  expect(onikonWidth(32)).toBe(64)
  expect(onikonWidth(64)).toBe(64 + 2 * BAND)
})

test('a line joins vertices that end elsewhere with the bottom, and without vertices it is straight', () => {
  // §A.7
  expect(
    edgeLine(
      [
        [-5, 5],
        [5, 5],
      ],
      0,
      0,
      32,
    ),
  ).toEqual([
    [0, 0],
    [-5, 5],
    [0, 10],
    [0, 32],
  ])
  expect(edgeLine([[3, 32]], 0, 0, 32)).toEqual([
    [0, 0],
    [3, 32],
    [0, 32],
  ])
  expect(edgeLine([], 7, 0, 32)).toEqual([
    [7, 0],
    [7, 32],
  ])
})

test('the same line bounds a right edge and the left edge that fits it', () => {
  const [size, x] = [64, 20]
  const line = edgeLine(JOINT, x + onikonWidth(size), 0, size)
    .map((p) => p.join(' '))
    .join('L')
  expect(rightBand(JOINT, x, 0, size)).toContain(line)
  expect(leftBand(JOINT, x + onikonWidth(size), 0, size)).toContain(line)
})

test('a band reaches to the picture', () => {
  expect(leftBand([], 0, 0, 32)).toBe('M0 0L0 32L16 32L16 0Z')
  expect(rightBand([], 0, 0, 32)).toBe('M64 0L64 32L48 32L48 0Z')
})

test('an outline goes around one onikon, or around a whole action', () => {
  expect(outline([], [], 0, 0, 32)).toBe('M0 0L0 32L64 32L64 0Z')
  expect(outline([], [], 0, 0, 32, 2)).toBe('M0 0L0 32L128 32L128 0Z')
  const points: Pt[] = [...edgeLine(NONE, 0, 0, 32), ...edgeLine(JOINT, 64, 0, 32).reverse()]
  expect(outline(NONE, JOINT, 0, 0, 32)).toBe(`M${points.map((p) => p.join(' ')).join('L')}Z`)
})
