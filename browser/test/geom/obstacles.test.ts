import { expect, test } from 'vitest'
import { cleared, Obstacles } from '../../src/geom/obstacles'
import { holds, overlaps, type Area, type Pt } from '../../src/geom/rect'
import { chance } from './scenes'

test('a box is widened by 10 px where it stands alone', () => {
  const obstacles = new Obstacles()
  obstacles.setBox('a', { x: 0, y: 0, w: 100, h: 50 })
  expect(obstacles.box('a').wide).toEqual({ x0: -10, y0: -10, x1: 110, y1: 60 })
})

test('neighbours share their gap, and get it back when one of them goes', () => {
  const obstacles = new Obstacles()
  obstacles.setBox('a', { x: 0, y: 0, w: 100, h: 50 })
  obstacles.setBox('b', { x: 106, y: 0, w: 100, h: 50 })
  expect([obstacles.box('a').wide.x1, obstacles.box('b').wide.x0]).toEqual([103, 103])
  obstacles.removeBox('b')
  expect(obstacles.box('a').wide.x1).toBe(110)
})

test('no two widened boxes overlap, however they stand', () => {
  const next = chance(1)
  for (let round = 0; round < 200; round++) {
    const obstacles = new Obstacles()
    const placed: Area[] = []
    for (let k = 0; k < 12; k++) {
      const rect = { x: next() * 120, y: next() * 120, w: 10 + next() * 30, h: 10 + next() * 30 }
      const area = { x0: rect.x, y0: rect.y, x1: rect.x + rect.w, y1: rect.y + rect.h }
      if (placed.some((other) => overlaps(other, area))) continue
      obstacles.setBox(`${placed.length}`, rect)
      placed.push(area)
    }
    const wide = placed.map((_, k) => obstacles.box(`${k}`).wide)
    wide.forEach((a, i) =>
      wide.slice(0, i).forEach((b) => {
        const [w, h] = [Math.min(a.x1, b.x1) - Math.max(a.x0, b.x0), Math.min(a.y1, b.y1) - Math.max(a.y0, b.y0)]
        expect(Math.min(w, h)).toBeLessThan(1e-9)
      }),
    )
  }
})

test('making way for an end gives up padding only, unless the end lies within the box', () => {
  const core = { x0: 0, y0: 0, x1: 100, y1: 50 }
  const wide = { x0: -10, y0: -10, x1: 110, y1: 60 }
  expect(cleared(wide, core, [105, 20])).toEqual({ ...wide, x1: 105 })
  expect(cleared(wide, core, [200, 20])).toBe(wide)
  expect(cleared(wide, core, [90, 20])).toEqual({ ...wide, x1: 90 })
  const next = chance(2)
  for (let k = 0; k < 1000; k++) {
    const p: Pt = [next() * 140 - 20, next() * 90 - 20]
    const left = cleared(wide, core, p)
    expect(holds(left, p)).toBe(false)
    if (!holds(core, p)) expect(left.x0 <= 0 && left.y0 <= 0 && left.x1 >= 100 && left.y1 >= 50).toBe(true)
  }
})

test("the loci of other variables stand in the way, a variable's own does not", () => {
  const obstacles = new Obstacles()
  obstacles.setLocus('q', 50, 50)
  const area = { x0: 0, y0: 0, x1: 100, y1: 100 }
  expect(obstacles.blocking(area, 'q')).toEqual([])
  expect(obstacles.blocking(area, 'r').map((o) => o.wide)).toEqual([{ x0: 43, y0: 43, x1: 57, y1: 57 }])
  obstacles.removeLocus('q')
  expect(obstacles.blocking(area, 'r')).toEqual([])
})
