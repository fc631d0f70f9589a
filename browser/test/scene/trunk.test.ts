// Lines of one variable share a trunk that is drawn once.
import { describe, expect, test } from 'vitest'
import type { Pt } from '../../src/geom/rect'
import { trunk } from '../../src/scene/trunk'

const first: Pt[] = [
  [0, 0],
  [10, 0],
  [10, 100],
  [200, 100],
]

describe('a trunk', () => {
  // R-C09
  test('the first line is whole', () => {
    expect(trunk([first])).toEqual([first])
  })

  test('a line ends a little after its corner onto what is drawn', () => {
    const second: Pt[] = [
      [50, 0],
      [60, 0],
      [60, 100],
      [200, 100],
    ]
    expect(trunk([first, second])[1]).toEqual([
      [50, 0],
      [60, 0],
      [60, 100],
      [66, 100],
    ])
  })

  test('a line that comes onto it straight ahead ends where it meets it', () => {
    const second: Pt[] = [
      [-50, 100],
      [200, 100],
    ]
    expect(trunk([first, second])[1]).toEqual([
      [-50, 100],
      [10, 100],
    ])
  })

  test('a line that follows around corners is cut before them', () => {
    const second: Pt[] = [
      [-20, 50],
      [10, 50],
      [10, 100],
      [200, 100],
    ]
    expect(trunk([first, second])[1]).toEqual([
      [-20, 50],
      [10, 50],
      [10, 56],
    ])
  })

  test('a line that only crosses, or comes from the other side, is whole', () => {
    const other: Pt[] = [
      [300, 100],
      [200, 100],
    ]
    const crossing: Pt[] = [
      [100, 200],
      [100, 50],
      [200, 50],
      [200, 100],
    ]
    expect(trunk([first, other, crossing]).slice(1)).toEqual([other, crossing])
  })

  test('nothing that was covered before is uncovered', () => {
    const random = (seed: number) => () => (seed = (seed * 16807) % 2147483647) / 2147483647
    const next = random(11)
    const at = (): number => Math.round(next() * 8) * 10
    for (let round = 0; round < 60; round += 1) {
      const routes = Array.from({ length: 5 }, (): Pt[] => {
        const [x, y, mx] = [at(), at(), at()]
        const all: Pt[] = [
          [x, y],
          [mx, y],
          [mx, 40],
          [40, 40],
        ]
        return all.filter((p, k) => k === 0 || p[0] !== all[k - 1]![0] || p[1] !== all[k - 1]![1])
      })
      const cells = (list: readonly (readonly Pt[])[]): Set<string> => {
        const found = new Set<string>()
        for (const route of list)
          for (let k = 0; k + 1 < route.length; k += 1) {
            const [[ax, ay], [bx, by]] = [route[k]!, route[k + 1]!]
            for (let s = 0; s < Math.hypot(bx - ax, by - ay); s += 1)
              found.add(
                `${Math.sign(bx - ax) >= 0 ? ax + Math.sign(bx - ax) * s : ax - s - 1}/${Math.sign(by - ay) >= 0 ? ay + Math.sign(by - ay) * s : ay - s - 1}/${ax === bx}`,
              )
          }
        return found
      }
      const drawn = cells(trunk(routes))
      expect([...cells(routes)].filter((cell) => !drawn.has(cell))).toEqual([])
    }
  })
})
