import { expect, test } from 'vitest'
import { placeLabels, type Label } from '../../src/geom/labels'
import { overlaps, type Area } from '../../src/geom/rect'
import { chance } from './scenes'

const label = (svar: string, x: number, y: number): Label => ({ svar, x, y, w: 40, h: 12 })

test('a name stands above its dot where that is free', () => {
  expect(placeLabels([label('q', 100, 100)], [])).toEqual([
    { svar: 'q', position: 'above', x0: 80, y0: 80, x1: 120, y1: 92 },
  ])
})

test('a box, a dot or another name sends it elsewhere', () => {
  const box = { x0: 0, y0: 0, x1: 200, y1: 95 }
  expect(placeLabels([label('q', 100, 100)], [box])[0].position).toBe('below')
  const two = placeLabels([label('q', 100, 100), label('r', 100, 85)], [])
  expect(two[0].position).toBe('below')
  expect(two[1].position).toBe('above')
})

test('a name keeps off the name placed before it', () => {
  const [first, second] = placeLabels([label('q', 100, 100), label('r', 130, 100)], [])
  expect([first.position, second.position]).toEqual(['above', 'below'])
})

test('it keeps off wires if it can, and prefers a wire to a box', () => {
  const wire = [
    [0, 86],
    [200, 86],
  ] as const
  expect(placeLabels([label('q', 100, 100)], [], [wire])[0].position).toBe('below')
  const below = { x0: 0, y0: 101, x1: 200, y1: 200 }
  const around = [{ x0: 0, y0: 0, x1: 95, y1: 200 }, { x0: 105, y0: 96, x1: 200, y1: 200 }, below]
  expect(placeLabels([label('q', 100, 100)], around, [wire])[0].position).toBe('above right')
})

test('with all eight positions taken it stands above', () => {
  expect(placeLabels([label('q', 100, 100)], [{ x0: 0, y0: 0, x1: 200, y1: 200 }])[0].position).toBe('above')
})

test('among many loci hardly a name collides', () => {
  const next = chance(3)
  const labels = Array.from({ length: 60 }, (_, k) => label(`v${k}`, next() * 1200, next() * 800))
  const placed = placeLabels(labels, [])
  const clashes = placed.filter((a, i) => placed.slice(0, i).some((b: Area) => overlaps(a, b)))
  expect(clashes.length).toBeLessThanOrEqual(1)
})
