import { describe, expect, test } from 'vitest'
import { areaOf, around, overlaps, type Area, type Pt } from '../../src/geom/rect'
import { linkId, Wires, type Pin } from '../../src/geom/wires'
import { chance, faults, overDots, overlap, pieces, scene, wall, wiresOf, type Box, type Scene } from './scenes'

const seeds = (n: number) => Array.from({ length: n }, (_, k) => k)
const out = (id: string, svar: string): Pin => ({ id, svar, side: 'right', dy: 50 })
const into = (id: string, svar: string): Pin => ({ id, svar, side: 'left', dy: 50 })
const at = (x: number, y: number) => ({ x, y, w: 100, h: 100 })

describe('whole scenes', () => {
  test('no wire crosses a box where boxes lie 10 px apart, and all end at their pins and loci', () => {
    // R-C09
    let wires = 0
    for (const seed of seeds(30)) {
      const dense = scene(seed, { boxes: 24, svars: 30, gap: 10 })
      const routes = wiresOf(dense).routes()
      wires += routes.size
      expect(faults(dense, routes)).toEqual([])
    }
    expect(wires).toBeGreaterThan(4000)
  })

  test('nor does one where boxes touch each other', () => {
    // R-C09
    for (const seed of seeds(12)) {
      const narrow = scene(seed, { boxes: 20, svars: 20, gap: 0 })
      expect(faults(narrow, wiresOf(narrow).routes())).toEqual([])
    }
    for (const seed of seeds(24)) {
      const block = wall(seed, seed % 6)
      expect(faults(block, wiresOf(block).routes())).toEqual([])
    }
  })

  test('a wire exists for every pin where boxes lie on each other and on loci', () => {
    // R-C09
    for (const seed of seeds(12)) {
      const heap = scene(seed, { boxes: 20, svars: 20, gap: -60 })
      const [a, b] = [...heap.boxes.values()].map((box) => box.rect)
      heap.loci.set('v0', [a.x + 70, a.y + 50])
      heap.loci.set('v1', [b.x + 5, b.y + 40])
      const found = faults(heap, wiresOf(heap).routes())
      expect(found.filter((fault) => !/crosses a box|leaves into its box/.test(fault))).toEqual([])
    }
  })

  test('hardly a wire runs over the dot of another variable', () => {
    // R-C09
    let [over, all] = [0, 0]
    for (const seed of seeds(12)) {
      const dense = scene(seed, { boxes: 24, svars: 30 })
      const routes = wiresOf(dense).routes()
      over += overDots(dense, routes)
      all += routes.size
    }
    expect(over / all).toBeLessThan(0.01) // those whose pin or locus lies beside the dot
  })

  test('wires of different variables hardly ever lie on each other', () => {
    let [together, length] = [0, 0]
    for (const seed of seeds(6)) {
      const roomy = scene(seed, { boxes: 12, svars: 16, gap: 40 })
      const routes = wiresOf(roomy).routes()
      together += overlap(roomy, routes, true)
      for (const points of routes.values()) for (const p of pieces(points)) length += p.x1 - p.x0 + p.y1 - p.y0
    }
    expect(together / length).toBeLessThan(0.01)
  })
})

describe('small changes', () => {
  test('after any number of moves the wires are as valid as those looked for anew', () => {
    // R-C09
    for (const seed of seeds(8)) {
      const next = chance(seed)
      const now = scene(seed, { boxes: 16, svars: 18, gap: 10 })
      const wires = wiresOf(now)
      wires.routes()
      for (let step = 0; step < 60; step++) {
        shake(now, wires, next)
        expect(faults(now, wires.routes())).toEqual([])
      }
      wires.settle()
      expect(faults(now, wires.routes())).toEqual([])
    }
  })

  test('only what a move concerns is drawn anew', () => {
    const now = scene(3, { boxes: 24, svars: 60, gap: 30 })
    const wires = wiresOf(now)
    const all = wires.routes().size
    wires.takeChanged()
    const { rect, pins } = now.boxes.get('task5')!
    wires.setBox('task5', { ...rect, x: rect.x + 5 }, pins)
    const changed = wires.takeChanged()
    for (const pin of pins) expect(changed).toContain(linkId('task5', pin.id))
    expect(changed.size).toBeLessThan(all / 2)
    expect(wires.takeChanged().size).toBe(0)
  })

  test('loci stay where they are, and their wires follow a moved box', () => {
    // R-C24
    const wires = new Wires()
    wires.setBox('a', at(0, 0), [out('1', 'q')])
    wires.setLocus('q', 200, 50)
    expect(wires.routes().get('a/1')).toEqual([
      [100, 50],
      [200, 50],
    ])
    wires.setBox('a', at(0, 200), [out('1', 'q')])
    expect(wires.routes().get('a/1')).toEqual([
      [100, 250],
      [200, 250],
      [200, 50],
    ])
  })

  test('a wire that ran around a box runs straight when the box is gone', () => {
    const wires = new Wires()
    wires.setBox('a', at(0, 0), [out('1', 'q')])
    wires.setLocus('q', 500, 50)
    wires.setBox('b', at(200, 0), [])
    expect(wires.routes().get('a/1')!.length).toBeGreaterThan(2)
    wires.removeBox('b')
    expect(wires.routes().get('a/1')).toEqual([
      [100, 50],
      [500, 50],
    ])
  })

  test('the wires of a removed box are gone, and those of a variable without a locus', () => {
    const wires = new Wires()
    wires.setBox('a', at(0, 0), [out('1', 'q')])
    wires.setBox('b', at(300, 0), [into('1', 'q')])
    wires.setLocus('q', 200, 50)
    expect([...wires.routes().keys()].sort()).toEqual(['a/1', 'b/1'])
    wires.removeBox('a')
    expect([...wires.routes().keys()]).toEqual(['b/1'])
    wires.removeLocus('q')
    expect(wires.routes().size).toBe(0)
    expect(wires.takeChanged()).toEqual(new Set(['a/1', 'b/1']))
  })

  test('the wires of a hidden locus are not drawn, and others go around its dot all the same', () => {
    // R-C09
    const wires = new Wires()
    wires.setBox('a', at(0, 0), [out('1', 'q')])
    wires.setBox('c', at(0, 200), [out('1', 'other')])
    wires.setLocus('q', 500, 50)
    wires.setLocus('other', 300, 50, false)
    const points = wires.routes().get('a/1')!
    expect(wires.routes().has('c/1')).toBe(false)
    expect(pieces(points).some((p) => overlaps(p, { x0: 295, y0: 45, x1: 305, y1: 55 }))).toBe(false)
    wires.setLocus('other', 300, 50, true)
    expect(wires.routes().has('c/1')).toBe(true)
  })
})

describe('the preview', () => {
  test('shows the wires a box would get and changes nothing', () => {
    const wires = new Wires()
    wires.setBox('a', at(0, 0), [out('1', 'q')])
    wires.setLocus('q', 200, 50)
    const before = structuredClone([...wires.routes()])
    wires.takeChanged()
    const future = wires.preview(at(300, 0), [into('1', 'q'), into('2', 'unknown')])
    expect([...future]).toEqual([
      [
        '1',
        [
          [300, 50],
          [200, 50],
        ],
      ],
    ])
    expect([...wires.routes()]).toEqual(before)
    expect(wires.takeChanged().size).toBe(0)
  })

  test('leaves nothing behind that other wires would go around', () => {
    const wires = new Wires()
    wires.setBox('a', at(0, 0), [out('1', 'q')])
    wires.setLocus('q', 500, 50)
    wires.preview(at(200, 0), [into('1', 'q')])
    wires.settle()
    expect(wires.routes().get('a/1')).toEqual([
      [100, 50],
      [500, 50],
    ])
  })

  test('leads to loci that do not exist yet', () => {
    const future = new Wires().preview(at(300, 0), [into('1', 'q')], new Map([['q', [280, 50]]]))
    expect(future.get('1')).toEqual([
      [300, 50],
      [280, 50],
    ])
  })

  test('is valid everywhere in a full scene', () => {
    const now = scene(5, { boxes: 16, svars: 20, gap: 30 })
    const wires = wiresOf(now)
    const { pins } = now.boxes.get('task1')!
    const next = chance(9)
    let tried = 0
    while (tried < 30) {
      const rect = { x: Math.floor(next() * 1000), y: Math.floor(next() * 1000), w: 136, h: 158 }
      const clash = [...now.boxes.values()].some((box) => overlaps(areaOf(box.rect, 10), areaOf(rect)))
      if (clash || onLocus(now, areaOf(rect, 6))) continue
      tried++
      const routes = [...wires.preview(rect, pins)].map(([id, points]): [string, Pt[]] => [linkId('new', id), points])
      const others = [...now.boxes].map(([id, box]): [string, Box] => [id, { ...box, pins: [] }])
      const scenery: Scene = { boxes: new Map([...others, ['new', { rect, pins }]]), loci: now.loci }
      expect(faults(scenery, new Map(routes))).toEqual([])
    }
  })
})

const onLocus = (now: Scene, area: Area) => [...now.loci.values()].some((place) => overlaps(area, around(...place, 0)))

/** One random change, made to the scene and to the wires; boxes keep 10 px apart and off the loci. */
function shake(now: Scene, wires: Wires, next: () => number): void {
  const step = () => Math.round((next() - 0.5) * 30) * 5
  if (next() < 0.3) {
    const [svar, [x, y]] = [...now.loci][Math.floor(next() * now.loci.size)]
    const place: Pt = [x + step(), y + step()]
    if ([...now.boxes.values()].some(({ rect }) => overlaps(areaOf(rect, 6), around(...place, 0)))) return
    now.loci.set(svar, place)
    wires.setLocus(svar, ...place)
    return
  }
  const [id, { rect, pins }] = [...now.boxes][Math.floor(next() * now.boxes.size)]
  const moved = { ...rect, x: rect.x + step(), y: rect.y + step() }
  const clash = [...now.boxes].some(([other, box]) => other !== id && overlaps(areaOf(box.rect, 10), areaOf(moved)))
  if (clash || onLocus(now, areaOf(moved, 6))) return
  now.boxes.set(id, { rect: moved, pins })
  wires.setBox(id, moved, pins)
}
