import { describe, expect, it } from 'vitest'
import { evenSamples } from '../../src/monitor/evenSamples'
import { decibels, frequencyResponse, phases, type FrequencyResponse } from '../../src/monitor/frequencyResponse'
import { readings } from '../../src/monitor/responseReadings'

const STEP_S = 0.002

const swept = (count: number, first = 0.5, last = 20): number[] =>
  Array.from({ length: count }, (_, k) => {
    const at_s = k * STEP_S
    return Math.sin(2 * Math.PI * (first * at_s + ((last - first) / (2 * count * STEP_S)) * at_s ** 2))
  })

/** What a mass on a spring makes of a held signal, exactly from sample to sample. */
function second(signal: readonly number[], hertz: number, damping: number): number[] {
  const omega = 2 * Math.PI * hertz
  const root = omega * Math.sqrt(1 - damping ** 2)
  const decay = Math.exp(-damping * omega * STEP_S)
  const [cos, sin] = [Math.cos(root * STEP_S), Math.sin(root * STEP_S)]
  const share = (damping * omega) / root
  const now = 1 - decay * (cos + share * sin)
  const former = decay ** 2 + decay * (share * sin - cos)
  const answer = [0, now * signal[0]!]
  for (let k = 2; k < signal.length; k += 1)
    answer.push(
      2 * decay * cos * answer[k - 1]! - decay ** 2 * answer[k - 2]! + now * signal[k - 1]! + former * signal[k - 2]!,
    )
  return answer
}

/** Of the same mass, in continuous time with half a step of delay. */
function truth(hertz: number, own: number, damping: number): { gain: number; phase: number } {
  const ratio = hertz / own
  return {
    gain: -10 * Math.log10((1 - ratio ** 2) ** 2 + (2 * damping * ratio) ** 2),
    phase: (-Math.atan2(2 * damping * ratio, 1 - ratio ** 2) * 180) / Math.PI - 180 * hertz * STEP_S,
  }
}

function estimated(reference: number[], measured: number[]): FrequencyResponse {
  const response = frequencyResponse({ step_s: STEP_S, reference, measured })
  if (typeof response === 'string') throw new Error(response)
  return response
}

describe('a frequency response', () => {
  // R-C14: `test_the_page_finds_the_same_numbers` has the same
  it('has the numbers of the command', () => {
    const reference = swept(4000, 0.5, 10)
    const response = estimated(reference, second(reference, 4, 0.7))
    expect([response.hertz.length, response.segments]).toEqual([11, 34])
    const rows = [0, 5, 10].map((k) => [
      response.hertz[k],
      decibels(response.re[k]!, response.im[k]!),
      phases(response)[k],
      response.coherence[k],
    ])
    const wanted = [
      [1.953125, -0.5355024867809243, -42.7487618545275, 0.9475701355846824],
      [6.8359375, -9.674791608000168, -130.1218519320554, 0.9677713344583154],
      [11.71875, -15.637452000892909, -142.12413528109764, 0.9950498233619314],
    ]
    rows.flat().forEach((value, k) => expect(value).toBeCloseTo(wanted.flat()[k]!, 8))
    expect(readings(response, false).bandwidth_Hz).toBeCloseTo(4.162396232956278, 8)
    expect(readings(response, false).phaseMargin).toBeCloseTo(67.6638204300379, 6)
    expect(readings(response, false).gainMargin_dB).toBeNaN()
  })

  // R-C14
  it.each([
    [4, 0.7],
    [5, 0.3],
  ])('of a sweep is that of a system that is known: %d Hz, damping %d', (hertz, damping) => {
    const rest = Array.from({ length: 500 }, () => 0) // a second before and after
    const reference = [...rest, ...swept(15_000), ...rest]
    const response = estimated(reference, second(reference, hertz, damping))
    const angles = phases(response)
    const sure = response.hertz.flatMap((at, k) => (response.coherence[k]! > 0.99 && at < 19 ? [k] : []))
    expect(sure.length).toBeGreaterThan(65)
    for (const k of sure) {
      const { gain, phase } = truth(response.hertz[k]!, hertz, damping)
      expect(Math.abs(decibels(response.re[k]!, response.im[k]!) - gain)).toBeLessThan(0.15)
      expect(Math.abs(angles[k]! - phase)).toBeLessThan(1)
    }
  })

  // R-C14
  it('of a step is the same, and has its peak and its margins', () => {
    const reference = Array.from({ length: 5000 }, (_, k) => (k < 700 ? 0 : -0.5))
    const response = estimated(
      reference,
      second(reference, 4, 0.3).map((value) => value + 7),
    )
    expect(response.segments).toBe(0)
    expect(response.coherence.every(Number.isNaN)).toBe(true)
    response.hertz.forEach((at, k) => {
      const { gain } = truth(at, 4, 0.3)
      if (at < 20) expect(Math.abs(decibels(response.re[k]!, response.im[k]!) - gain)).toBeLessThan(0.05)
    })
    const { peak_dB, peak_Hz, bandwidth_Hz } = readings(response, true)
    expect(peak_dB).toBeCloseTo(-20 * Math.log10(0.6 * Math.sqrt(0.91)), 1)
    expect(peak_Hz).toBeCloseTo(4 * Math.sqrt(0.82), 0)
    expect(bandwidth_Hz).toBeGreaterThan(5)
  })

  it('is not made up where nothing can be estimated', () => {
    const lack = (reference: number[], measured: number[]): unknown =>
      frequencyResponse({ step_s: STEP_S, reference, measured })
    const wave = swept(1000)
    const still = wave.map(() => 3)
    const step = wave.map((_, k) => (k < 100 ? 0 : 1))
    expect(lack([], [])).toBe('short')
    expect(lack(wave.slice(0, 50), wave.slice(0, 50))).toBe('short')
    expect(lack(still, wave)).toBe('still')
    expect(lack(wave, still)).toBe('constant')
    expect(lack(wave, [NaN, ...wave.slice(1)])).toBe('strange')
    expect(
      lack(
        step,
        wave.map((_, k) => k),
      ),
    ).toBe('moves')
  })
})

describe('margins', () => {
  it('of a closed loop are those of the open one that makes it', () => {
    const hertz = Array.from({ length: 2000 }, (_, k) => 0.1 + k * 0.02)
    // 40 / (s (1 + s / 20) (1 + s / 60)): its phase is -180 degrees at sqrt(1200) rad/s, where its gain is a half
    const loop = hertz.map((at) => {
      const omega = 2 * Math.PI * at
      const [re, im] = [-(omega ** 2) * (1 / 20 + 1 / 60), omega * (1 - omega ** 2 / 1200)]
      const size = re ** 2 + im ** 2
      return { re: (40 * re) / size, im: (-40 * im) / size }
    })
    const closed = loop.map(({ re, im }) => {
      const size = (1 + re) ** 2 + im ** 2
      return { re: (re * (1 + re) + im * im) / size, im: im / size }
    })
    const of = (parts: { re: number; im: number }[]): FrequencyResponse => ({
      hertz,
      re: parts.map(({ re }) => re),
      im: parts.map(({ im }) => im),
      coherence: hertz.map(() => 1),
      segments: 9,
    })
    const open = readings(of(loop), true)
    expect(open.gainMargin_dB).toBeCloseTo(20 * Math.log10(2), 2)
    expect(open.gainMargin_Hz).toBeCloseTo(Math.sqrt(1200) / (2 * Math.PI), 2)
    expect(readings(of(closed), false).phaseMargin).toBeCloseTo(open.phaseMargin, 6)
    expect(readings(of(closed), false).gainMargin_dB).toBeCloseTo(open.gainMargin_dB, 6)
  })
})

describe('values at even instants', () => {
  it('are those in force, also where some were lost', () => {
    const t = [0, 2, 4, 8, 10, 12, 14, 16]
    const even = evenSamples({ t: [0, 5], y: [1, 2] }, { t, y: t })
    expect(even).toEqual({
      step_s: 2,
      reference: [1, 1, 1, 2, 2, 2, 2, 2, 2],
      measured: [0, 2, 4, 4, 8, 10, 12, 14, 16],
    })
  })

  it('are none where times have no rate, or nothing came', () => {
    expect(evenSamples({ t: [0], y: [1] }, { t: [0, 1, 2.4, 3, 5.5, 6.1], y: [0, 0, 0, 0, 0, 0] })).toBeNull()
    expect(evenSamples({ t: [], y: [] }, { t: [0, 1, 2], y: [0, 0, 0] })?.measured).toEqual([])
  })
})
