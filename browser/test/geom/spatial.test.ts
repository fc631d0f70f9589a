import { expect, test } from 'vitest'
import { inReadingOrder, neighbour } from '../../src/geom/spatial'

const box = (id: string, x: number, y: number) => ({ id, x, y, w: 100, h: 80 })
const all = [
  box('nw', 0, 0),
  box('n', 200, 10),
  box('ne', 400, 0),
  box('w', 0, 200),
  box('e', 410, 220),
  box('s', 190, 400),
]
const of = (id: string) => all.find((one) => one.id === id)!

test('an arrow key leads to the next box in its direction', () => {
  expect(neighbour(of('nw'), 'right', all)).toBe('n')
  expect(neighbour(of('nw'), 'down', all)).toBe('w')
  expect(neighbour(of('ne'), 'left', all)).toBe('n')
  expect(neighbour(of('s'), 'up', all)).toBe('n')
  expect(neighbour(of('w'), 'right', all)).toBe('e')
})

test('where there is none, to none', () => {
  expect(neighbour(of('ne'), 'right', [of('ne'), of('nw')])).toBeNull()
  expect(neighbour(of('nw'), 'up', [of('nw')])).toBeNull()
})

test('a box level with this one is preferred to a nearer one aside', () => {
  expect(neighbour(box('a', 0, 0), 'right', [box('far', 400, 20), box('aside', 150, 300)])).toBe('far')
})

test('reading order goes by rows', () => {
  expect(inReadingOrder(all).map((one) => one.id)).toEqual(['nw', 'n', 'ne', 'w', 'e', 's'])
})
