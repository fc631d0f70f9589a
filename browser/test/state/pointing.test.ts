// R-D25: a place before a surface, and the way into it.
import { expect, test } from 'vitest'
import { before, into, type PointedPlace } from '../../src/state/pointing.svelte'

const WALL: PointedPlace = { world: 'boxes', position: [1, 2, 3], normal: [-1, 0, 0] }

test('the tool stands before the surface, or behind it, and points into it', () => {
  expect(before(WALL, 0.25)).toEqual([0.75, 2, 3])
  expect(before(WALL, -0.25)).toEqual([1.25, 2, 3])
  expect(into(WALL)).toEqual([1, 0, 0])
})
