import { expect, test } from 'vitest'
import { covers, jumped, minimap, shrunk, wanted } from '../../src/geom/minimap'
import { PLAIN, seen, toScreen } from '../../src/geom/viewport'

const screen = { w: 800, h: 600 }
const size = { w: 160, h: 120 }
const boxes = [
  { x0: -1000, y0: -500, x1: -900, y1: -400 },
  { x0: 3000, y0: 2000, x1: 3100, y1: 2100 },
]

test('the whole scene and the screen fit into the small picture', () => {
  const map = minimap(boxes, seen(PLAIN, screen), size)
  for (const area of [...boxes, seen(PLAIN, screen)]) {
    const { x, y, w, h } = shrunk(map, area)
    expect(x >= 3.99 && y >= 3.99 && x + w <= 156.01 && y + h <= 116.01).toBe(true)
  }
})

test('a click brings what is under it to the middle of the screen', () => {
  const map = minimap(boxes, seen(PLAIN, screen), size)
  const { x, y, w, h } = shrunk(map, boxes[1])
  const [mx, my] = toScreen(jumped(map, [x + w / 2, y + h / 2], PLAIN, screen), [3050, 2050])
  expect(mx).toBeCloseTo(400, 6)
  expect(my).toBeCloseTo(300, 6)
})

test('it covers what lies under its place on the screen, as far as that is seen now', () => {
  const place = { x: 640, y: 480, w: 150, h: 110 }
  const under = { x0: 700, y0: 500, x1: 750, y1: 560 }
  expect(covers(place, [under], PLAIN)).toBe(true)
  expect(covers(place, boxes, PLAIN)).toBe(false)
  expect(covers(place, [under], { ...PLAIN, x: -300 })).toBe(false)
})

test('it is wanted for many boxes, and when one is off the screen', () => {
  const here = { x0: 10, y0: 10, x1: 50, y1: 50 }
  expect(wanted([here], PLAIN, screen)).toBe(false)
  expect(wanted([here, boxes[1]], PLAIN, screen)).toBe(true)
  expect(wanted(Array(41).fill(here), PLAIN, screen)).toBe(true)
})
