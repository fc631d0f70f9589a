import { describe, expect, test } from 'vitest'
import { Lanes } from '../../src/geom/lanes'
import { Obstacles } from '../../src/geom/obstacles'
import type { Pt } from '../../src/geom/rect'
import { Wires } from '../../src/geom/wires'

/** Two bends: out of a pin at height `y`, up or down at `x`, on to a locus. */
const bent = (y: number, x: number, to: number): Pt[] => [
  [0, y],
  [x, y],
  [x, to],
  [400, to],
]
const laid = (routes: Record<string, [string, Pt[]]>, obstacles = new Obstacles()) => {
  const lanes = new Lanes(obstacles)
  for (const [link, [svar, points]] of Object.entries(routes)) lanes.set(link, svar, points)
  lanes.settle()
  return lanes
}
const upright = (points: readonly Pt[]) => points.slice(1).flatMap(([x], k) => (points[k][0] === x ? [x] : []))

describe('lanes', () => {
  test('a wire alone stays on its line', () => {
    expect(laid({ a: ['q', bent(0, 100, 90)] }).drawn('a')).toEqual(bent(0, 100, 90))
  })

  test('wires of two variables on one line come to lie side by side, half to each side', () => {
    const lanes = laid({ a: ['q', bent(0, 100, 90)], b: ['r', bent(20, 100, 120)] })
    const [[a], [b]] = [upright(lanes.drawn('a')), upright(lanes.drawn('b'))]
    expect(Math.abs(a - b)).toBe(5)
    expect((a + b) / 2).toBe(100)
  })

  test('they are as far apart as is preferred, where there is room, and the same way again after a change of mind', () => {
    const wires = new Wires() // R-G01
    wires.setBox('left', { x: 0, y: 0, w: 60, h: 100 }, [
      { id: 'A', svar: 'A', side: 'right', dy: 20 },
      { id: 'B', svar: 'B', side: 'right', dy: 40 },
    ])
    wires.setLocus('A', 400, 300)
    wires.setLocus('B', 400, 340)
    const between = (gap: number): number => {
      wires.keepApart(gap)
      const [[a], [b]] = ['left/A', 'left/B'].map((link) => upright(wires.routes().get(link)!))
      return Math.abs(a! - b!)
    }
    const usual = between(5)
    expect(usual).toBeGreaterThanOrEqual(5)
    expect(between(12)).toBeGreaterThanOrEqual(12)
    expect(between(5)).toBe(usual)
  })

  test('wires of one variable share a lane', () => {
    // R-C09
    const lanes = laid({ a: ['q', bent(0, 100, 90)], b: ['q', bent(20, 100, 90)] })
    expect(upright(lanes.drawn('a'))).toEqual(upright(lanes.drawn('b')))
  })

  test('the order of lanes is the one without crossings', () => {
    // Both come from the left, go down and on to the right: the one that starts and ends higher turns farther out.
    const lanes = laid({ b: ['a first name', bent(20, 100, 150)], a: ['q', bent(0, 100, 120)] })
    expect(upright(lanes.drawn('a'))[0]).toBeGreaterThan(upright(lanes.drawn('b'))[0])
  })

  test('no lane is pushed into a box', () => {
    const obstacles = new Obstacles()
    obstacles.setBox('left', { x: 0, y: 40, w: 98, h: 20 })
    obstacles.setBox('right', { x: 104, y: 40, w: 98, h: 20 })
    const routes: Record<string, [string, Pt[]]> = {}
    for (let k = 0; k < 4; k++) routes[`w${k}`] = [`v${k}`, bent(k * 5, 101, 90 + k * 5)]
    const lanes = laid(routes, obstacles)
    for (const link of Object.keys(routes)) {
      const [x] = upright(lanes.drawn(link))
      expect(x).toBeGreaterThan(98)
      expect(x).toBeLessThan(104)
    }
  })

  test('wires whose ends nearly meet on one line would read as one, so they part; farther ends do not', () => {
    const near = laid({ a: ['q', bent(0, 100, 50)], b: ['r', bent(52, 100, 90)] })
    expect(upright(near.drawn('a'))).not.toEqual(upright(near.drawn('b')))
    const far = laid({ a: ['q', bent(0, 100, 50)], b: ['r', bent(60, 100, 90)] })
    expect([upright(far.drawn('a')), upright(far.drawn('b'))]).toEqual([[100], [100]])
  })

  test('lines that are apart already are left alone', () => {
    const lanes = laid({ a: ['q', bent(0, 100, 90)], b: ['r', bent(20, 108, 120)] })
    expect([upright(lanes.drawn('a')), upright(lanes.drawn('b'))]).toEqual([[100], [108]])
  })

  test('two ends on one line: the shorter steps aside, but not at its pin and its locus', () => {
    const lanes = laid({
      a: [
        'q',
        [
          [0, 50],
          [300, 50],
          [300, 0],
        ],
      ],
      b: [
        'r',
        [
          [350, 50],
          [200, 50],
          [200, 90],
        ],
      ],
    })
    expect(lanes.drawn('a')).toEqual([
      [0, 50],
      [300, 50],
      [300, 0],
    ])
    const b = lanes.drawn('b')
    expect(b.slice(0, 2)).toEqual([
      [350, 50],
      [340, 50],
    ])
    expect(b[b.length - 1]).toEqual([200, 90])
    expect(b.some(([x, y]) => x === 200 && Math.abs(y - 50) === 5)).toBe(true)
  })

  test('when a wire goes, the one beside it returns to the middle and is reported', () => {
    const lanes = laid({ a: ['q', bent(0, 100, 90)], b: ['r', bent(20, 100, 120)] })
    lanes.remove('b')
    expect(lanes.settle()).toEqual(new Set(['a']))
    expect(lanes.drawn('a')).toEqual(bent(0, 100, 90))
  })
})
