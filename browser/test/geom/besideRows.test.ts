// A card over the workspace lies on no row that is needed.
import { expect, test } from 'vitest'
import { besideRows } from '../../src/geom/besideRows'

const WINDOW = { top: 0, bottom: 700 }

test('a card stands where it is wanted, if nothing needed is there', () => {
  expect(besideRows(100, 200, [{ top: 400, bottom: 464 }], WINDOW)).toBe(100)
})

test('it goes to the nearer side of a row', () => {
  expect(besideRows(300, 200, [{ top: 250, bottom: 314 }], WINDOW)).toBe(322)
  expect(besideRows(220, 200, [{ top: 400, bottom: 464 }], WINDOW)).toBe(192)
})

test('it finds the place between two rows', () => {
  const rows = [
    { top: 100, bottom: 164 },
    { top: 400, bottom: 464 },
  ]
  expect(besideRows(120, 200, rows, WINDOW)).toBe(172)
})

test('it never leaves the window, even where nothing is free', () => {
  expect(besideRows(650, 200, [], WINDOW)).toBe(492)
  expect(besideRows(300, 600, [{ top: 300, bottom: 364 }], WINDOW)).toBe(92)
})
