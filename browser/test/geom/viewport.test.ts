import { describe, expect, test } from 'vitest'
import type { Pt } from '../../src/geom/rect'
import {
  fitted,
  LEAST,
  MOST,
  panned,
  PLAIN,
  revealed,
  toScene,
  toScreen,
  wheelFactor,
  zoomed,
  zoomedTo,
} from '../../src/geom/viewport'
import { chance } from './scenes'

const screen = { w: 800, h: 600 }

describe('a view', () => {
  test('leads to the screen and back', () => {
    const view = { x: 30, y: -20, scale: 1.5 }
    expect(toScreen(view, [10, 20])).toEqual([45, 10])
    expect(toScene(view, [45, 10])).toEqual([10, 20])
    expect(toScreen(panned(view, 5, 6), [10, 20])).toEqual([50, 16])
  })

  test('keeps the point under the pointer while it zooms', () => {
    const next = chance(1)
    let view = PLAIN
    for (let k = 0; k < 500; k++) {
      const pointer: Pt = [next() * 800, next() * 600]
      const before = toScene(view, pointer)
      view = zoomed(view, 0.5 + next(), pointer)
      const after = toScene(view, pointer)
      expect(after[0]).toBeCloseTo(before[0], 6)
      expect(after[1]).toBeCloseTo(before[1], 6)
      expect(view.scale).toBeGreaterThanOrEqual(LEAST)
      expect(view.scale).toBeLessThanOrEqual(MOST)
    }
  })

  test('reaches from 10 % to 400 %', () => {
    expect(zoomedTo(PLAIN, 100, [0, 0]).scale).toBe(4)
    expect(zoomedTo(PLAIN, 0, [0, 0]).scale).toBe(0.1)
  })

  test('is the same after a turn of the wheel forth and back', () => {
    expect(wheelFactor(120) * wheelFactor(-60) * wheelFactor(-60)).toBeCloseTo(1, 12)
  })
})

describe('fitting', () => {
  test('shows everything with a margin', () => {
    const areas = [
      { x0: -500, y0: 0, x1: 0, y1: 100 },
      { x0: 2000, y0: 3000, x1: 2500, y1: 3100 },
    ]
    const view = fitted(areas, screen, 40)
    for (const a of areas) {
      for (const p of [
        [a.x0, a.y0],
        [a.x1, a.y1],
      ] as Pt[]) {
        const [x, y] = toScreen(view, p)
        expect(x >= 39.9 && x <= 760.1 && y >= 39.9 && y <= 560.1).toBe(true)
      }
    }
  })

  test('does not enlarge a small scene, but puts it in the middle', () => {
    expect(fitted([{ x0: 0, y0: 0, x1: 100, y1: 100 }], screen)).toEqual({ scale: 1, x: 350, y: 250 })
    expect(fitted([], screen)).toEqual(PLAIN)
  })

  test('revealing moves as little as possible', () => {
    expect(revealed(PLAIN, { x0: 100, y0: 100, x1: 200, y1: 200 }, screen)).toEqual(PLAIN)
    expect(revealed(PLAIN, { x0: 900, y0: 100, x1: 1000, y1: 200 }, screen)).toEqual({ scale: 1, x: -220, y: 0 })
    expect(revealed(PLAIN, { x0: -50, y0: 0, x1: 5000, y1: 50 }, screen)).toEqual({ scale: 1, x: 70, y: 20 })
  })
})
