// R-X24: where what follows from a fault stands in its picture.
import { expect, test } from 'vitest'
import { byState, instantsOf, spread, type Happening } from '../../src/geom/foresightLine'

const PRESSED = [
  { within_ms: 10, kind: 'drive', subject: 'boxes:arm_left', after: 'PRESSED', is_told: true },
  { within_ms: 12, kind: 'task', subject: 'main/puma', after: 'ERROR', is_told: true },
]

const words = (effects: readonly Happening[], width: number): unknown[] =>
  instantsOf(effects, width, 80).instants.map(({ ms, kinds }) => [ms, ...kinds])

test('the line goes from the fault by the first change and the last drive to what is told', () => {
  expect(words(PRESSED, 400)).toEqual([
    [0, 'fault'],
    [10, 'drive'],
    [12, 'told'],
  ])
  const later = [{ within_ms: 5, kind: 'task', after: 'ERROR', is_told: false }, ...PRESSED]
  expect(words(later, 400)[1]).toEqual([5, 'first'])
})

test('it is to scale where its words have room', () => {
  expect(instantsOf(PRESSED, 400, 80).isToScale).toBe(false)
  const wide = instantsOf(PRESSED, 600, 80)
  expect(wide.isToScale).toBe(true)
  expect(wide.instants.map(({ x }) => x)).toEqual([0, 500, 600])
})

test('what nobody is told of has no such instant, and where nothing changes there is the fault alone', () => {
  const silent = PRESSED.map((effect) => ({ ...effect, is_told: false }))
  expect(words(silent, 400).flat()).not.toContain('told')
  expect(words([], 400)).toEqual([[0, 'fault']])
})

test('what comes at once stands at the fault itself', () => {
  const atOnce = [{ within_ms: 0, kind: 'drive', after: 'TRIPPED', is_told: true }]
  expect(words(atOnce, 400)).toEqual([[0, 'fault', 'drive', 'told']])
})

test('places are in the order of time, never too near, and end at the end', () => {
  for (const times of [
    [0, 10, 12],
    [0, 1, 2, 60_000],
    [0, 250],
  ]) {
    const places = spread(times, 400, 80)
    expect(places[0]).toBe(0)
    expect(places.at(-1)).toBeCloseTo(400)
    places.slice(1).forEach((place, k) => expect(place - places[k]!).toBeGreaterThanOrEqual(80))
  }
})

test('each task is listed once, under the state in which it ends', () => {
  const off = [...PRESSED, { within_ms: 60, kind: 'task', subject: 'main/puma', after: 'OFF' }]
  off.push({ within_ms: 60, kind: 'task', subject: 'main/pd', after: 'OFF' })
  expect(byState(off)).toEqual([['OFF', ['main/puma', 'main/pd']]])
})
