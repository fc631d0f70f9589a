// R-G05: a configuration in small.
import { expect, test } from 'vitest'
import { small } from '../../src/files/thumbnail'

const seen = {
  tasks: { a: [0, 0, 136, 100], b: [400, 200, 136, 100] } as Record<string, [number, number, number, number]>,
  wires: [
    ['a', 'b'],
    ['b', 'a'],
    ['a', 'gone'],
  ] as [string, string][],
}

test('all boxes are within the field, in their order, at one scale', () => {
  const { boxes } = small(seen, 212, 108)
  for (const { x, y, w, h } of boxes) {
    expect(x).toBeGreaterThanOrEqual(0)
    expect(y).toBeGreaterThanOrEqual(0)
    expect(x + w).toBeLessThanOrEqual(212)
    expect(y + h).toBeLessThanOrEqual(108)
  }
  const [a, b] = boxes as [(typeof boxes)[number], (typeof boxes)[number]]
  expect(b.x).toBeGreaterThan(a.x + a.w)
  expect(a.w / a.h).toBeCloseTo(1.36)
})

test('each wire between boxes that are there is a line, forwards and back', () => {
  const { lines } = small(seen, 212, 108)
  expect(lines).toHaveLength(2)
  for (const line of lines) expect(line).toMatch(/^M[\d.]+ [\d.]+([HV][\d.]+)+$/)
})

test('nothing is drawn of nothing, and one box is not blown up', () => {
  expect(small({}, 212, 108)).toEqual({ boxes: [], lines: [] })
  expect(small({ tasks: { a: [0, 0, 136, 100] } }, 212, 108).boxes[0]!.w).toBeLessThan(50)
})
