import { expect, test } from 'vitest'
import { Cells } from '../../src/geom/cells'
import { touches, type Area } from '../../src/geom/rect'
import { chance } from './scenes'

const some = (next: () => number): Area => {
  const [x0, y0] = [next() * 4000 - 2000, next() * 4000 - 2000]
  return { x0, y0, x1: x0 + next() * 400, y1: y0 + next() * 400 }
}

test('what is found near an area is what looking at all of them finds, each once', () => {
  const next = chance(4)
  const cells = new Cells<Area>()
  const all = new Set<Area>()
  for (let k = 0; k < 600; k++) {
    if (next() < 0.3 && all.size) {
      const gone = [...all][Math.floor(next() * all.size)]
      all.delete(gone)
      cells.drop(gone)
    } else {
      const area = some(next)
      all.add(area)
      cells.add(area)
    }
    const wanted = k % 50 ? some(next) : { x0: -9999, y0: -9999, x1: 9999, y1: 9999 }
    const found = cells.near(wanted)
    expect(new Set(found)).toEqual(new Set([...all].filter((area) => touches(area, wanted))))
    expect(new Set(found).size).toBe(found.length)
  }
  expect(new Set(cells.all())).toEqual(all)
})

test('dropping what is not there changes nothing', () => {
  const cells = new Cells<Area>()
  const area = { x0: 0, y0: 0, x1: 1, y1: 1 }
  cells.add(area)
  cells.drop({ ...area })
  expect(cells.near(area)).toEqual([area])
})
