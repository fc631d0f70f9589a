// R-E11: the time of a run goes on in the browser between two messages.
import { describe, expect, it } from 'vitest'
import type { RunView } from '../../src/api.gen'
import { latest, RunClock } from '../../src/progress/clock'
import { plain } from '../../src/texts/say'

const run = (more: Partial<RunView> = {}): RunView => ({ doc: 'a1', name: 'r', number: 1, state: 'running', ...more })

describe('the clock of a run', () => {
  it('begins with the run, and goes on by itself', () => {
    const clock = new RunClock()
    clock.take(run({ state: 'beginning', began_at_s: 1000 }), 47, 997)
    expect(clock.at(49)).toBe(0)
    clock.take(run({ began_at_s: 1000 }), 50, 1000)
    expect(clock.at(52.5)).toBeCloseTo(2.5)
  })

  it('is none of the run as long as that begins, which is not said, as it is so at first', () => {
    const clock = new RunClock()
    clock.take(run({ state: undefined }), 40, 0)
    expect(clock.at(48)).toBe(0)
    clock.take(run({ flows: { flow0: { order: 0, began_s: 1 } } }), 50, 0)
    expect(clock.at(50)).toBeCloseTo(1)
  })

  it('a message that tells of a later moment puts it right; one that came late does not put it back', () => {
    const clock = new RunClock()
    clock.take(run({ state: 'beginning' }), 50, 0)
    clock.take(run({ flows: { flow0: { order: 0, began_s: 4 } } }), 53, 0)
    expect(clock.at(53)).toBeCloseTo(4)
    clock.take(run({ flows: { flow0: { order: 0, began_s: 4.1 } } }), 55, 0)
    expect(clock.at(55)).toBeCloseTo(6)
  })

  it('a page that joins later goes by the time of day', () => {
    const clock = new RunClock()
    clock.take(run({ began_at_s: 1000, steps: { 1: { began_s: 3 } } }), 50, 1010)
    expect(clock.at(51)).toBeCloseTo(11)
  })

  it('a time of day that cannot be is not believed', () => {
    for (const wall_s of [900, 900_000]) {
      const clock = new RunClock()
      clock.take(run({ began_at_s: 1000, steps: { 1: { began_s: 3 } } }), 50, wall_s)
      expect(clock.at(51)).toBeCloseTo(4)
    }
  })

  it('stands still at the end, and where the time of the run is not ours', () => {
    const clock = new RunClock()
    clock.take(run({ steps: { 1: { began_s: 3 } } }), 50, 0)
    expect(clock.at(60, true)).toBe(3)
    clock.take(run({ state: 'over', took_s: 7.5 }), 61, 0)
    expect(clock.at(99)).toBe(7.5)
  })

  it('begins anew with another run', () => {
    const clock = new RunClock()
    clock.take(run({ state: 'over', took_s: 7.5 }), 50, 0)
    clock.take(run({ number: 2, state: 'beginning' }), 100, 0)
    expect(clock.at(101)).toBe(0)
    clock.take(run({ number: 2 }), 103, 0) // its runtime was started first
    expect(clock.at(104)).toBeCloseTo(1)
  })
})

describe('the latest moment', () => {
  it('is that of any flow, step, meeting or stop', () => {
    expect(latest(run())).toBe(0)
    expect(latest(run({ steps: { 1: { state: 'done', began_s: 2, took_s: 3 }, 2: { began_s: 4, took_s: 9 } } }))).toBe(
      5,
    )
    expect(
      latest(
        run({
          meets: [{ tag: 'a', flows: [], skew_us: 0, at_s: 6 }],
          stops: { flow0: { text: plain(''), kind: 'error', at_s: 8 } },
        }),
      ),
    ).toBe(8)
    expect(latest(run({ flows: { flow0: { order: 0, waits_since_s: 9 } } }))).toBe(9)
  })
})
