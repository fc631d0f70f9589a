// R-X24: where what follows from a fault stands in its picture.
import { expect, test } from 'vitest'
import { byState, instantsOf, spread } from '../../src/geom/foresightLine'

const PRESSED = [
  { within_ms: 10, kind: 'drive', subject: 'boxes:arm_left', after: 'PRESSED', is_told: true },
  { within_ms: 12, kind: 'task', subject: 'main/puma', after: 'ERROR', is_told: true },
]

test('the line goes from the fault by what is noticed and the drive to what is told', () => {
  expect(instantsOf(PRESSED, 400, 80).map(({ ms, kinds }) => [ms, ...kinds])).toEqual([
    [0, 'fault'],
    [10, 'noticed', 'drive'],
    [12, 'told'],
  ])
})

test('what nobody is told of has no such instant, and where nothing changes there is the fault alone', () => {
  const silent = PRESSED.map((effect) => ({ ...effect, is_told: false }))
  expect(instantsOf(silent, 400, 80).flatMap(({ kinds }) => kinds)).not.toContain('told')
  expect(instantsOf([], 400, 80)).toEqual([{ ms: 0, x: 0, kinds: ['fault'] }])
})

test('what comes at once stands at the fault itself', () => {
  const atOnce = [{ within_ms: 0, kind: 'drive', after: 'TRIPPED', is_told: true }]
  expect(instantsOf(atOnce, 400, 80)).toEqual([{ ms: 0, x: 0, kinds: ['fault', 'noticed', 'drive', 'told'] }])
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
