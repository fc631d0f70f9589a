// Boxes from afar are one outline for each state.
import { expect, test } from 'vitest'
import { farBox, outlines } from '../../src/scene/farBoxes'

const left = farBox('left', { x: 0, y: 0, w: 100, h: 80 })
const right = farBox('right', { x: 200, y: 10, w: 100, h: 80 })
const at = { x: 0, y: 0 }

const count = (path: string): number => path.split('M').length - 1

// R-G07
test('boxes of one state are one outline, whatever they are called', () => {
  const both = outlines([left, right], { left: { ...at, state: 'ON' }, right: { ...at, state: 'ON' } })
  expect(both.map(({ look }) => look)).toEqual(['ON'])
  expect(both[0]!.frame).toBe('M0 0h100v80h-100zM200 10h100v80h-100z')
  expect(count(both[0]!.head)).toBe(2)
})

test('a box in an error has a second frame, and only that one', () => {
  const [calm, bad] = outlines([left, right], { left: at, right: { ...at, state: 'ERROR' } })
  expect([calm!.look, calm!.inner]).toEqual(['', ''])
  expect([bad!.look, bad!.inner]).toEqual(['ERROR', 'M204 14h92v72h-92z'])
})

test('a task that comes or goes waits, and one that nobody knows is missing', () => {
  const looks = outlines([left, right], { left: { ...at, state: 'KILLING' }, right: { ...at, is_missing: true } })
  expect(looks.map(({ look }) => look)).toEqual(['WAITING', 'missing'])
})

test('without boxes nothing is drawn', () => {
  expect(outlines([], {})).toEqual([])
})
