// Where the icons of an application stand.
import { describe, expect, test } from 'vitest'
import { onikonWidth } from '../../src/geom/jigsaw'
import {
  arrange,
  EMPTY,
  END,
  FORK,
  GHOST,
  MARGIN,
  START,
  type Content,
  type Known,
} from '../../src/application/arrangement'
import { gapAt, walked } from '../../src/application/gaps'
import { chance } from '../geom/scenes'

const W = onikonWidth(64)
const PLAIN: Known = { joined: false, isHole: false, flows: [] }

/** Flows in letters: `.` an icon, `+` one that belongs to the one before, `o` a hole, `B` a branch; numbered from 1. */
function content(flows: Record<string, string>): Content & { numbers: Record<string, number[]> } {
  const known = new Map<number, Known>()
  const numbers: Record<string, number[]> = {}
  let next = 1
  for (const [path, text] of Object.entries(flows)) {
    numbers[path] = [...text].map((letter) => {
      const number = next++
      const inner = Object.keys(flows).filter((other) => letter === 'B' && other.startsWith(`${path}/`))
      known.set(number, { joined: letter === '+', isHole: letter === 'o', flows: inner })
      return number
    })
  }
  return {
    numbers,
    tops: Object.keys(flows).filter((path) => !path.includes('/')),
    steps: (path) => numbers[path] ?? [],
    step: (number) => known.get(number) ?? PLAIN,
  }
}
const frame = (perRow: number) => ({ width: 2 * MARGIN + perRow * W, size: 64, extra: 0 })

describe('a flow', () => {
  test('begins with the start icon, ends with the end icon, and each icon touches the one before it', () => {
    // R-D04
    const { cells } = arrange(content({ 0: '...' }), frame(9))
    expect(cells.map((cell) => cell.step)).toEqual([START, 1, 2, 3, END])
    expect(cells.map((cell) => cell.x)).toEqual([0, 1, 2, 3, 4].map((k) => MARGIN + k * W))
  })

  test('wraps at the width, with an arrow, and moves the next flow down', () => {
    // R-D20
    const one = arrange(content({ 0: '...', 1: '.' }), frame(9))
    const wrapped = arrange(content({ 0: '...', 1: '.' }), frame(3))
    expect(wrapped.wraps).toHaveLength(1)
    expect(one.wraps).toHaveLength(0)
    expect(wrapped.heads[1]!.y).toBeGreaterThan(one.heads[1]!.y)
  })

  test('never parts an action from its targets', () => {
    // R-D20
    for (let perRow = 2; perRow < 9; perRow++) {
      const { cells } = arrange(content({ 0: '..+.+..+.+' }), frame(perRow))
      for (const joined of [3, 5, 8, 10]) {
        const [job, target] = [
          cells.find((cell) => cell.step === joined - 1)!,
          cells.find((cell) => cell.step === joined)!,
        ]
        expect([target.x, target.y]).toEqual([job.x + W, job.y])
      }
    }
  })

  test('keeps every action of random flows together, inside the width', () => {
    const next = chance(5)
    for (let round = 0; round < 100; round++) {
      const text = Array.from({ length: 30 }, (_, k) => (k > 0 && next() < 0.35 ? '+' : '.')).join('')
      const { cells } = arrange(content({ 0: text }), frame(8))
      let length = 1
      for (let k = 1; k < text.length; k++) {
        const [before, cell] = [cells[k]!, cells[k + 1]!] // the first is the start icon
        length = text[k] === '+' ? length + 1 : 1
        if (text[k] === '+' && length <= 8) expect([cell.x, cell.y]).toEqual([before.x + W, before.y])
        expect(cell.x + cell.w).toBeLessThanOrEqual(MARGIN + 8 * W)
      }
    }
  })

  test('in which nothing stands has a room with a gap in its middle', () => {
    const { cells, gaps } = arrange(content({ 0: '' }), frame(9))
    expect(cells.map((cell) => cell.step)).toEqual([START, EMPTY, END])
    expect(gaps).toEqual([
      { flow: '0', after: START, x: MARGIN + 1.5 * W, y: cells[0]!.y, hole: EMPTY, isSecond: false },
    ])
  })

  test('opens for what is carried: the neighbours part', () => {
    // R-D03
    const { cells } = arrange(content({ 0: '..' }), frame(9), { flow: '0', after: 1 })
    expect(cells.map((cell) => cell.step)).toEqual([START, 1, GHOST, 2, END])
  })
})

describe('gaps', () => {
  test('stand behind each step; a hole is that of its left neighbour', () => {
    // R-D19
    const { gaps } = arrange(content({ 0: '.o.' }), frame(9))
    expect(gaps.map((gap) => [gap.after, gap.hole])).toEqual([
      [0, 0],
      [1, 2],
      [3, 0],
    ])
  })

  test('at the end of a row and at the beginning of the next mean the same', () => {
    const { gaps } = arrange(content({ 0: '...' }), frame(3))
    expect(gaps.map((gap) => [gap.after, gap.isSecond])).toEqual([
      [0, false],
      [1, false],
      [2, false],
      [2, true],
      [3, false],
    ])
  })

  test('are found by a pointer in their row only', () => {
    const { gaps, heads } = arrange(content({ 0: '...' }), frame(9))
    const { y } = heads[0]!
    expect(gapAt(gaps, MARGIN + 2 * W + 20, y + 30, 64)?.after).toBe(1)
    expect(gapAt(gaps, MARGIN + 2 * W + 60, y + 30, 64)?.after).toBe(2)
    expect(gapAt(gaps, MARGIN + 2 * W, y + 200, 64)).toBeUndefined()
  })

  test('are walked by keys through all flows and rows', () => {
    // R-X11
    const { gaps } = arrange(content({ 0: '...', 1: '.' }), frame(3))
    let place = { flow: '0', after: 0 }
    const seen: string[] = []
    for (;;) {
      seen.push(`${place.flow}:${place.after}`)
      const next = walked(gaps, place, 'right')
      if (!next) break
      place = next
    }
    expect(seen).toEqual(['0:0', '0:1', '0:2', '0:3', '1:0', '1:4'])
    expect(walked(gaps, { flow: '0', after: 0 }, 'down')?.after).toBe(3)
    expect(walked(gaps, { flow: '0', after: 3 }, 'up')?.after).toBe(0)
    expect(walked(gaps, { flow: '0', after: 1 }, 'last')?.after).toBe(3)
    expect(walked(gaps, { flow: '0', after: 1 }, 'end')?.flow).toBe('1')
  })
})

describe('the condition of a branch', () => {
  const LABEL = 30 // from the middle row of a condition's letters, which stand 21 above their lane, to its upper end
  const TIME = 16 // what stands beneath an icon while it runs

  test('stands beneath the times of the row above', () => {
    // R-D13
    const { cells, blocks } = arrange(content({ 0: '......B', '0/7/0': '.', '0/7/1': '.' }), frame(5))
    const [block] = blocks
    const above = cells.filter(({ flow, y }) => flow === '0' && y < block!.y).map(({ y }) => y + 64)
    expect(above.length).toBeGreaterThan(0)
    expect(block!.lanes[0]!.y - LABEL).toBeGreaterThan(Math.max(...above) + TIME)
  })

  test('stands above that of a branch with which its lane begins', () => {
    // R-D13
    const { blocks } = arrange(content({ 0: 'B', '0/1/0': 'B', '0/1/1': '.', '0/1/0/2/0': '.' }), frame(12))
    const [inner, outer] = [...blocks].sort((a, b) => b.x - a.x)
    expect(inner!.y).toBe(outer!.y)
    expect(outer!.lanes[0]!.above).toBe(inner!.above)
    expect(outer!.above).toBe(2 * inner!.above)
  })

  test('leaves the line between two rows free', () => {
    // R-D13
    const { wraps, blocks } = arrange(content({ 0: '.........B', '0/10/0': '.' }), frame(5))
    expect(wraps.map(({ above }) => above)).toEqual([0, blocks[0]!.above])
  })
})

describe('a branch', () => {
  const app = { 0: '.B.', '0/2/0': '..', '0/2/1': '' }

  test('stands in line: its flows are lanes below each other, and what follows stands behind the longest', () => {
    // R-D13
    const { cells, blocks } = arrange(content(app), frame(12))
    const [block] = blocks
    expect(block!.lanes.map((lane) => lane.path)).toEqual(['0/2/0', '0/2/1'])
    const at = (step: number, flow: string) => cells.find((cell) => cell.step === step && cell.flow === flow)!
    expect(block!.x).toBe(at(1, '0').x + W)
    expect(at(3, '0').x).toBe(block!.x + block!.w)
    expect(at(3, '0').y).toBe(at(4, '0/2/0').y)
    expect(at(EMPTY, '0/2/1').y).toBeGreaterThan(at(4, '0/2/0').y + 64)
    expect(block!.lanes[0]!.x).toBe(block!.x + FORK)
  })

  test('has gaps of its own, between those of the flow around it', () => {
    const { gaps } = arrange(content(app), frame(12))
    expect(gaps.map((gap) => `${gap.flow}:${gap.after}`).sort()).toEqual([
      '0/2/0:0',
      '0/2/0:4',
      '0/2/0:5',
      '0/2/1:0',
      '0:0',
      '0:1',
      '0:2',
      '0:3',
    ])
  })

  test('moves to the next row where it does not fit, and wraps inside where it is longer than a row', () => {
    const { blocks, cells } = arrange(content({ 0: '.B.', '0/2/0': '......', '0/2/1': '.' }), frame(5))
    expect(blocks[0]!.x).toBe(MARGIN)
    expect(blocks[0]!.w).toBeLessThanOrEqual(5 * W)
    expect(new Set(cells.filter((cell) => cell.flow === '0/2/0').map((cell) => cell.y)).size).toBe(2)
  })
})
