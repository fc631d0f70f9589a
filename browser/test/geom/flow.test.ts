import { describe, expect, test } from 'vitest'
import { FRAME, layOut, slotAt, slots, type Step } from '../../src/geom/flow'
import { onikonWidth } from '../../src/geom/jigsaw'
import { chance } from './scenes'

const size = 32
/** A frame with room for so many onikons in a row. */
const frame = (perRow: number) => ({ ...FRAME, size, width: 2 * FRAME.left + perRow * onikonWidth(size) + 5 })
/** `.` stands alone, `+` belongs to the one before it. */
const steps = (text: string): Step[] => [...text].map((one) => ({ joined: one === '+' }))
const rows = (text: string, perRow: number) =>
  layOut([steps(text)], frame(perRow)).flows[0].places.map((place) => place.row).join('')

describe('the rows of a flow', () => {
  test('wrap around at the width', () => { // R-D04
    expect(rows('.....', 3)).toBe('00011')
    expect(rows('...', 3)).toBe('000')
  })

  test('never split a job from its target', () => { // R-D20
    expect(rows('...+.', 3)).toBe('00111')
    expect(rows('..' + '.++' + '.', 4)).toBe('001111')
  })

  test('split an action only where it is longer than a row', () => {
    expect(rows('..+++', 3)).toBe('01112')
    expect(rows('.+', 1)).toBe('01')
  })

  test('keep every action of random flows together', () => {
    const next = chance(5)
    for (let round = 0; round < 200; round++) {
      const flow = Array.from({ length: 30 }, (_, k) => ({ joined: k > 0 && next() < 0.35 }))
      const { places } = layOut([flow], frame(8)).flows[0]
      let length = 1
      for (let k = 1; k < flow.length; k++) {
        length = flow[k].joined ? length + 1 : 1
        if (flow[k].joined && length <= 8) expect(places[k].row).toBe(places[k - 1].row)
        expect(places[k].row - places[k - 1].row).toBeLessThanOrEqual(1)
        expect(places[k].x + onikonWidth(size)).toBeLessThanOrEqual(frame(8).width - FRAME.left)
      }
    }
  })
})

describe('flows', () => {
  test('interlock: each onikon begins where the one before it ends', () => {
    const { places } = layOut([steps('...')], frame(3)).flows[0]
    expect(places.map((place) => place.x)).toEqual([20, 20 + onikonWidth(size), 20 + 2 * onikonWidth(size)])
  })

  test('stand one below the other without touching', () => { // R-D04
    const { flows, height } = layOut([steps('.....'), steps('..')], frame(3))
    expect(flows[1].y).toBeGreaterThan(flows[0].y + flows[0].height)
    expect(flows[0].height).toBe(2 * size + FRAME.rowGap)
    expect(height).toBeGreaterThanOrEqual(flows[1].y + flows[1].height)
  })

  test('have an arrow from the end of each row to the beginning of the next', () => { // R-D20
    const { places, wraps } = layOut([steps('.....')], frame(2)).flows[0]
    expect(wraps.length).toBe(2)
    expect(wraps[0][0]).toEqual([places[1].x + onikonWidth(size), places[1].y + size / 2])
    expect(wraps[0][wraps[0].length - 1]).toEqual([places[2].x, places[2].y + size / 2])
  })
})

describe('slots', () => {
  test('stand between all onikons, twice where a row wraps, and at the end', () => {
    const all = slots(layOut([steps('...')], frame(2)).flows, size)
    expect(all.map((slot) => slot.index)).toEqual([0, 1, 2, 2, 3])
  })

  test('are found by the pointer in their own row', () => {
    const { flows } = layOut([steps('....')], frame(2))
    const all = slots(flows, size)
    const { x, y } = flows[0].places[3]
    expect(slotAt(all, [x + 5, y + 10], size)).toMatchObject({ flow: 0, index: 3 })
    expect(slotAt(all, [x + onikonWidth(size) - 5, y + 10], size)).toMatchObject({ index: 4 })
    expect(slotAt(all, [x, y + 500], size)).toBeNull()
  })
})
