import { describe, expect, test } from 'vitest'
import { Obstacles } from '../../src/geom/obstacles'
import { Router, tidy } from '../../src/geom/router'
import type { Pt } from '../../src/geom/rect'

type Sides = [number, number, number, number]

const router = (boxes: Record<string, Sides>, loci: Record<string, Pt> = {}) => {
  const obstacles = new Obstacles()
  for (const [id, [x, y, w, h]] of Object.entries(boxes)) obstacles.setBox(id, { x, y, w, h })
  for (const [svar, [x, y]] of Object.entries(loci)) obstacles.setLocus(svar, x, y)
  return new Router(obstacles)
}
const right = { box: 'a', side: 'right', x: 100, y: 50 } as const
const left = { box: 'a', side: 'left', x: 0, y: 50 } as const

describe('a route', () => {
  test('is straight where nothing is in the way', () => {
    expect(router({ a: [0, 0, 100, 100] }).route(right, [300, 50], 'q')).toEqual([
      [100, 50],
      [300, 50],
    ])
  })

  test('has one bend where one is enough', () => {
    expect(router({ a: [0, 0, 100, 100] }).route(right, [300, 200], 'q')).toEqual([
      [100, 50],
      [300, 50],
      [300, 200],
    ])
  })

  test('leaves a pin on its own side, with a stub of 10 px, even if the locus is on the other', () => {
    // R-C09
    const points = router({ a: [0, 0, 100, 100] }).route(left, [300, 50], 'q')
    expect(points.slice(0, 2)).toEqual([
      [0, 50],
      [-10, 50],
    ])
  })

  test('keeps 10 px from a box where there is room, half of the gap where there is less', () => {
    expect(router({ a: [0, 0, 100, 100], b: [200, 0, 100, 100] }).route(right, [400, 50], 'q')).toContainEqual([
      190, 50,
    ])
    expect(router({ a: [0, 0, 100, 100], b: [108, 0, 100, 100] }).route(right, [400, 50], 'q')[1]).toEqual([104, 50])
  })

  test('runs along the common border of boxes that touch', () => {
    const points = router({ a: [0, 0, 100, 100], b: [100, 0, 100, 100] }).route(right, [300, 50], 'q')
    expect(points[1][0]).toBe(100)
    expect(points[points.length - 1]).toEqual([300, 50])
  })

  test('goes around the dot of another variable and not around its own', () => {
    const one = router({ a: [0, 0, 100, 100] }, { q: [300, 50], r: [200, 50] })
    expect(one.route(right, [300, 50], 'q').length).toBeGreaterThan(2)
    expect(one.route(right, [200, 50], 'r')).toEqual([
      [100, 50],
      [200, 50],
    ])
  })

  test('ends at a locus nearer than the stub is long', () => {
    expect(router({ a: [0, 0, 100, 100] }).route(right, [106, 50], 'q')).toEqual([
      [100, 50],
      [106, 50],
    ])
    expect(router({ a: [0, 0, 100, 100] }).route(right, [106, 80], 'q')).toEqual([
      [100, 50],
      [106, 50],
      [106, 80],
    ])
  })

  test('finds its way around a wall far wider than the first region it looks at', () => {
    const points = router({ a: [0, 0, 100, 100], wall: [150, -900, 50, 1500] }).route(right, [300, 50], 'q')
    expect(points.some(([, y]) => y === 610)).toBe(true)
  })

  test('finds its way around everything where no smaller region will do', () => {
    const points = router({ a: [0, 0, 100, 100], wall: [150, -4000, 50, 9000] }).route(right, [300, 50], 'q')
    expect(points.some(([, y]) => y === -4010)).toBe(true)
  })

  test('reaches a locus beneath a box from its nearest side', () => {
    const points = router({ a: [0, 0, 100, 100], b: [200, 0, 200, 200] }).route(right, [390, 100], 'q')
    expect(points[points.length - 1]).toEqual([390, 100])
    expect(points.every(([x, y]) => !(x > 200 && x < 390 && y > 0 && y < 200))).toBe(true)
  })

  test('exists even from a pin that is walled in by boxes that lie on each other', () => {
    const [n, s]: Sides[] = [
      [-50, -90, 250, 70],
      [-50, 120, 250, 70],
    ]
    const [e, w]: Sides[] = [
      [130, -90, 70, 280],
      [-90, -90, 70, 280],
    ]
    const points = router({ a: [0, 0, 100, 100], n, s, e, w }).route(right, [400, 300], 'q')
    expect(points[0]).toEqual([100, 50])
    expect(points[points.length - 1]).toEqual([400, 300])
    expect(points.slice(1).every(([x, y], k) => x === points[k][0] || y === points[k][1])).toBe(true)
  })
})

describe('tidy', () => {
  test('keeps the corners alone', () => {
    expect(
      tidy([
        [0, 0],
        [0, 0],
        [5, 0],
        [9, 0],
        [9, 4],
        [9, 9],
      ]),
    ).toEqual([
      [0, 0],
      [9, 0],
      [9, 9],
    ])
  })
})
