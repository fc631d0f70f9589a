import { expect, test } from 'vitest'
import { snap } from '../../src/geom/snap'

const box = (x: number, y: number, rows?: number[]) => ({ x, y, w: 136, h: 104, rows })

test('a box alone rests on the grid of 5 px', () => {
  expect(snap(box(52, 48.4), [])).toEqual({ x: 50, y: 50, guides: [] })
})

test("a side near a neighbour's side is drawn to it, with a line to show it", () => {
  const { x, guides } = snap(box(103, 300), [box(101, 0)])
  expect(x).toBe(101)
  expect(guides).toContainEqual({ vertical: true, at: 101, from: 0, to: 404, kind: 'edge' })
})

test("a row of pins is drawn to a neighbour's row, so that the wire between them is straight", () => {
  const { y, guides } = snap(box(300, 12, [55]), [box(0, 0, [64])])
  expect(y).toBe(9)
  expect(guides).toEqual([{ vertical: false, at: 64, from: 0, to: 436, kind: 'row' }])
})

test('the nearest match wins', () => {
  expect(snap(box(103, 300), [box(100, 0), box(102, 600)]).x).toBe(102)
})

test('out of reach it is the grid again', () => {
  expect(snap(box(108, 301), [box(101, 0)], { reach: 4 })).toEqual({ x: 110, y: 300, guides: [] })
})

test('Alt suspends both', () => {
  expect(snap(box(103, 301), [box(101, 300)], { suspended: true })).toEqual({ x: 103, y: 301, guides: [] })
})
