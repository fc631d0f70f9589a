import { expect, test } from 'vitest'
import { Grid } from '../../src/geom/grid'
import { cleared, Obstacles } from '../../src/geom/obstacles'
import { grown, span, type Pt } from '../../src/geom/rect'
import { Router, tidy, type PinPlace } from '../../src/geom/router'
import { Search } from '../../src/geom/search'
import { scene } from './scenes'

const BEND = 24

function cost(way: readonly Pt[]): number {
  let length = 0
  for (let k = 0; k + 1 < way.length; k++)
    length += Math.abs(way[k][0] - way[k + 1][0]) + Math.abs(way[k][1] - way[k + 1][1])
  return length + BEND * (way.length - 2)
}

/** The cheapest way from a pin at the right, around all that stands near; null where it leads further around. */
function aroundAll(obstacles: Obstacles, pin: PinPlace, goal: Pt, svar: string): Pt[] | null {
  const start: Pt = [obstacles.box(pin.box).wide.x1, pin.y]
  const region = grown(span([start, goal]), 40)
  const areas = obstacles
    .blocking(region, svar)
    .map(({ core, wide }) => cleared(cleared(wide, core, start), core, goal))
  const grid = new Grid()
  grid.lay(areas, [start, goal], region)
  const way = new Search().find(grid, start, goal)
  return way && tidy([[pin.x, pin.y], ...way])
}

test('a way around what it meets is as cheap as the cheapest around everything', () => {
  let compared = 0
  for (let seed = 1; seed <= 12; seed++) {
    const { boxes, loci } = scene(seed, { boxes: 40, svars: 40, gap: seed % 3 ? 10 : 0, size: 1600 })
    const obstacles = new Obstacles()
    for (const [id, box] of boxes) obstacles.setBox(id, box.rect)
    for (const [svar, [x, y]] of loci) obstacles.setLocus(svar, x, y)
    const router = new Router(obstacles)
    for (const [box, { rect }] of boxes) {
      const pin: PinPlace = { box, side: 'right', x: rect.x + rect.w, y: rect.y + 30 }
      for (const [svar, goal] of [...loci].slice(0, 8)) {
        const cheapest = aroundAll(obstacles, pin, goal, svar)
        if (cheapest === null || goal[0] < obstacles.box(box).wide.x1) continue // the stub may be shorter there
        compared++
        expect(cost(router.route(pin, goal, svar))).toBeCloseTo(cost(cheapest), 6)
      }
    }
  }
  expect(compared).toBeGreaterThan(500)
})
