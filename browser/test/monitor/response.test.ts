import { describe, expect, it } from 'vitest'
import { held, response, type Course } from '../../src/monitor/response'

/** The answer of a second-order system to a step of `size` at `at_s`, sampled 1000 times a second. */
function second(damping: number, omega: number, size: number, at_s = 0.1, end_s = 8): [Course, Course] {
  const t = Array.from({ length: Math.round(end_s * 1000) }, (_, k) => k / 1000)
  const damped = omega * Math.sqrt(1 - damping * damping)
  const phase = Math.acos(damping)
  const answer = (s: number): number =>
    s <= 0 ? 0 : 1 - (Math.exp(-damping * omega * s) / Math.sqrt(1 - damping * damping)) * Math.sin(damped * s + phase)
  const reference = { t, y: t.map((at) => (at >= at_s ? size : 0)) }
  return [reference, { t, y: t.map((at) => size * answer(at - at_s)) }]
}

describe('how a measurement follows its reference', () => {
  // R-C14
  it.each([
    [0.2, 5, 1],
    [0.3, 12, -0.4],
    [0.5, 8, 30],
    [0.7, 20, 0.001],
  ])('has the overshoot of a second-order answer: damping %d, omega %d, step %d', (damping, omega, size) => {
    const measures = response(...second(damping, omega, size))
    const overshoot = Math.exp((-Math.PI * damping) / Math.sqrt(1 - damping * damping))
    expect(measures.overshoot).toBeCloseTo(overshoot, 3)
    expect(measures.steadyError / size).toBeCloseTo(0, 2)
  })

  it.each([0.3, 0.5, 0.7])('rises as the books say and settles within its envelope: damping %d', (damping) => {
    const omega = 10
    const { rise_s, settling_s } = response(...second(damping, omega, 1))
    // From 10 to 90 %: the polynomial that control books fit to the answer.
    const fit = (1 + 1.039 * damping - 0.417 * damping ** 2 + 1.76 * damping ** 3) / omega
    expect(Math.abs(rise_s / fit - 1)).toBeLessThan(0.02)
    const envelope = -Math.log(0.02 * Math.sqrt(1 - damping * damping)) / (damping * omega)
    expect(settling_s).toBeLessThanOrEqual(envelope + 0.001)
    expect(settling_s).toBeGreaterThan(envelope * 0.5)
  })

  it('does not settle where it ends outside of the band, and says what error remains', () => {
    const t = Array.from({ length: 100 }, (_, k) => k / 100)
    const measures = response(
      { t, y: t.map((at) => (at > 0.1 ? 1 : 0)) },
      { t, y: t.map((at) => (at > 0.1 ? 0.9 : 0)) },
    )
    expect(measures.settling_s).toBeNaN()
    expect(measures.steadyError).toBeCloseTo(0.1)
    expect(measures.overshoot).toBe(0)
  })

  it('has the root of the mean square of the difference', () => {
    const t = [0, 1, 2, 3]
    expect(response({ t, y: [1, 1, 1, 1] }, { t, y: [1, 3, 1, -1] }).rms).toBeCloseTo(Math.sqrt(2))
  })

  it('is nothing where no reference was written before', () => {
    expect(response({ t: [9], y: [1] }, { t: [1, 2], y: [0, 0] }).rms).toBeNaN()
  })

  it('measures the first step alone of a reference that jumps to and fro', () => {
    const t = Array.from({ length: 400 }, (_, k) => k / 100)
    const reference = { t, y: t.map((at) => (at >= 0.5 && at < 2 ? 1 : at >= 3 ? 1 : 0)) }
    const follows = t.map((at) => (at < 0.5 ? 0 : at < 2 ? 1 - Math.exp(-(at - 0.5) / 0.1) : Math.exp(-(at - 2) / 0.1)))
    const measures = response(reference, { t, y: follows })
    expect(measures.rise_s).toBeCloseTo(0.22, 1)
    expect(measures.settling_s).toBeCloseTo(0.39, 1)
    expect(measures.overshoot).toBe(0)
    expect(measures.steadyError).toBeCloseTo(0, 5) // and not of the step after it
  })

  it('knows no rise, overshoot or settling of a reference that is no step', () => {
    const t = Array.from({ length: 400 }, (_, k) => k / 100)
    const sine = { t, y: t.map((at) => Math.sin(at)) }
    const measures = response(sine, { t, y: t.map((at) => 0.9 * Math.sin(at - 0.05)) })
    expect([measures.rise_s, measures.overshoot, measures.settling_s]).toEqual([NaN, NaN, NaN])
    expect(measures.rms).toBeGreaterThan(0)
  })

  it('takes a reference of another rate as the value in force', () => {
    expect([...held({ t: [1, 3], y: [10, 30] }, [0, 1, 2, 3, 4])]).toEqual([NaN, 10, 10, 30, 30])
  })
})
