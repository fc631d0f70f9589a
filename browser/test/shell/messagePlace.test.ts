// Where messages stand, and how many at once.
import { expect, test } from 'vitest'
import { atOnce } from '../../src/act/toasts.svelte'
import { placeOf } from '../../src/shell/messagePlace'

const PAGE = { width: 900, height: 700 }
const PART = { left: 250, right: 570, top: 48, bottom: 560 }
const foot = (left: number, right: number, top: number) => ({ left, right, top, bottom: top + 80 })

test('messages stand in the middle part, at its lower end', () => {
  expect(placeOf({ part: PART, feet: [] }, PAGE)).toEqual({ left: 258, width: 304, bottom: 148 })
})

test('they are no wider than is good to read', () => {
  const { left, width } = placeOf({ part: { ...PART, left: 0, right: 1200 }, feet: [] }, PAGE)
  expect([left, width]).toEqual([370, 460])
})

test('they stand above buttons at the lower end, but not above those beside them', () => {
  expect(placeOf({ part: PART, feet: [foot(250, 570, 480)] }, PAGE).bottom).toBe(228)
  expect(placeOf({ part: PART, feet: [foot(600, 800, 480)] }, PAGE).bottom).toBe(148)
})

test('they stay on the page where something high stands at the lower end', () => {
  expect(placeOf({ part: PART, feet: [foot(250, 570, 20)] }, PAGE).bottom).toBe(540)
})

test('at most two messages stand at once: the last, and the last that went wrong', () => {
  const lines = (...levels: ('info' | 'error' | 'warning')[]) => levels.map((level, id) => ({ level, id }))
  const ids = (...levels: ('info' | 'error' | 'warning')[]) => atOnce(lines(...levels)).map(({ id }) => id)
  expect(ids()).toEqual([])
  expect(ids('info', 'info', 'info')).toEqual([2])
  expect(ids('error', 'info', 'info')).toEqual([0, 2])
  expect(ids('error', 'warning', 'info')).toEqual([1, 2])
  expect(ids('error', 'warning', 'error')).toEqual([1, 2])
})
