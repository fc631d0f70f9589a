// Where something that is carried would be put on its shelf.
import { expect, test } from 'vitest'
import { placeBy, placeNow, placeOf } from '../../src/gesture/shelfPlace.svelte'

const NAMES = ['a', 'b', 'c', 'd']

test('beside another it comes before it or before the one behind it', () => {
  // R-D24
  expect(placeOf(NAMES, 'd', 'b', false)).toBe('b')
  expect(placeOf(NAMES, 'd', 'b', true)).toBe('c')
  expect(placeOf(NAMES, 'a', 'd', true)).toBe('')
})

test('what is put where it stands is put nowhere else', () => {
  expect(placeOf(NAMES, 'b', 'a', true)).toBe(placeNow(NAMES, 'b'))
  expect(placeOf(NAMES, 'b', 'c', false)).toBe(placeNow(NAMES, 'b'))
  expect(placeNow(NAMES, 'd')).toBe('')
})

test('by one place it goes earlier or later, but not beyond the ends', () => {
  expect([placeBy(NAMES, 'c', -1), placeBy(NAMES, 'b', 1), placeBy(NAMES, 'c', 1)]).toEqual(['b', 'd', ''])
  expect([placeBy(NAMES, 'a', -1), placeBy(NAMES, 'd', 1), placeBy(NAMES, 'x', 1)]).toEqual([
    undefined,
    undefined,
    undefined,
  ])
})
