// The frequency response of a measurement to its reference, estimated as `onika recording response` does it: of a signal
// that goes on the mean of windowed stretches that overlap, H = Sxy / Sxx; of one step the spectrum of the differences.
import type { Even } from './evenSamples'

export interface FrequencyResponse {
  /** In Hz, rising, without 0. */
  hertz: number[]
  re: number[]
  im: number[]
  /** Which part of the measurement follows the reference, 0 to 1; NaN of a step, which comes once. */
  coherence: number[]
  /** How many stretches it is the mean of; 0: it is that of a step. */
  segments: number
}

/** Why nothing can be estimated. */
export type Lack = 'short' | 'strange' | 'uneven' | 'still' | 'constant' | 'moves'

const LEAST_SAMPLES = 64
const UNMOVED = 1e-9
const EXCITED = 1e-2
const OVERLAPPING = 4
const AT_REST = 0.02
/** From this coherence on a frequency counts for readings. */
export const RELIABLE = 0.8
/** Of a step so many frequencies are computed in a decade. */
const PER_DECADE = 60

export const isReliable = (coherence: number): boolean => Number.isNaN(coherence) || coherence >= RELIABLE
export const decibels = (re: number, im: number): number => 20 * Math.log10(Math.hypot(re, im))

export function frequencyResponse({ step_s, reference, measured }: Even): FrequencyResponse | Lack {
  const count = reference.length
  if (count < LEAST_SAMPLES) return 'short'
  if (!reference.every(Number.isFinite) || !measured.every(Number.isFinite)) return 'strange'
  if (isConstant(reference)) return 'still'
  if (isConstant(measured)) return 'constant'
  const least = UNMOVED * span(reference)
  const changes = reference.flatMap((value, k) => (k && Math.abs(value - reference[k - 1]!) > least ? [k - 1] : []))
  if (changes.length === 1) return ofStep(reference.slice(changes[0]), measured.slice(changes[0]), step_s)
  const segment = 2 ** Math.floor(Math.log2(Math.floor(count / 4)))
  return ofCourse(reference, measured, step_s, segment)
}

/** Phases in degrees, without jumps: each is within half a turn of the last reliable one before it. */
export function phases({ re, im, coherence }: FrequencyResponse): number[] {
  let former = 0
  return re.map((part, k) => {
    const plain = (Math.atan2(im[k]!, part) * 180) / Math.PI
    const phase = plain - 360 * Math.round((plain - former) / 360)
    if (isReliable(coherence[k]!)) former = phase
    return phase
  })
}

function isConstant(signal: readonly number[]): boolean {
  return span(signal) <= UNMOVED * signal.reduce((most, value) => Math.max(most, Math.abs(value)), 0)
}

function span(signal: readonly number[]): number {
  let low = Infinity
  let high = -Infinity
  for (const value of signal) {
    low = Math.min(low, value)
    high = Math.max(high, value)
  }
  return high - low
}

/** Of the step that lies between the first two samples. */
function ofStep(reference: readonly number[], measured: readonly number[], step_s: number): FrequencyResponse | Lack {
  const count = measured.length
  if (count < LEAST_SAMPLES) return 'short'
  const twentieth = Math.floor(count / 20)
  const last = mean(measured.slice(-twentieth))
  const former = mean(measured.slice(-2 * twentieth, -twentieth))
  if (Math.abs(last - former) > AT_REST * span(measured)) return 'moves'
  const size = reference[1]! - reference[0]!
  const differences = measured.slice(1).map((value, k) => (value - measured[k]!) / size)
  const response: FrequencyResponse = { hertz: [], re: [], im: [], coherence: [], segments: 0 }
  for (const place of spreadPlaces(Math.floor(differences.length / 2))) {
    const [re, im] = line(differences, place)
    if (re !== 0 || im !== 0) append(response, place / (differences.length * step_s), re, im, NaN)
  }
  return response
}

/** Whole numbers from 1 on, all at first, then evenly on a logarithmic axis. */
function spreadPlaces(last: number): number[] {
  const places: number[] = []
  for (let place = 1; place <= last; place = Math.max(place + 1, Math.round(place * 10 ** (1 / PER_DECADE)))) {
    places.push(place)
  }
  return places
}

/** One line of the spectrum. */
function line(signal: readonly number[], place: number): [number, number] {
  let re = 0
  let im = 0
  signal.forEach((value, k) => {
    const angle = (-2 * Math.PI * ((place * k) % signal.length)) / signal.length
    re += value * Math.cos(angle)
    im += value * Math.sin(angle)
  })
  return [re, im]
}

/** Of signals that go on: the mean over stretches, each less its own mean and under a Hann window. */
function ofCourse(
  reference: readonly number[],
  measured: readonly number[],
  step_s: number,
  segment: number,
): FrequencyResponse | Lack {
  const hop = segment / OVERLAPPING
  const [x, y] = padded([reference, measured], segment - hop)
  const [power, answer, crossRe, crossIm] = Array.from({ length: 4 }, () => new Float64Array(segment / 2 + 1))
  let segments = 0
  for (let begin = 0; begin + segment <= x.length; begin += hop) {
    const a = spectrum(x.subarray(begin, begin + segment))
    const b = spectrum(y.subarray(begin, begin + segment))
    for (let k = 0; k <= segment / 2; k += 1) {
      power![k]! += a.re[k]! ** 2 + a.im[k]! ** 2
      answer![k]! += b.re[k]! ** 2 + b.im[k]! ** 2
      crossRe![k]! += a.re[k]! * b.re[k]! + a.im[k]! * b.im[k]!
      crossIm![k]! += a.re[k]! * b.im[k]! - a.im[k]! * b.re[k]!
    }
    segments += 1
  }
  const least = EXCITED * power!.reduce((most, value) => Math.max(most, value), 0)
  const response: FrequencyResponse = { hertz: [], re: [], im: [], coherence: [], segments }
  for (let k = 2; k <= segment / 2; k += 1) {
    const size = crossRe![k]! ** 2 + crossIm![k]! ** 2
    if (power![k]! <= least || size === 0) continue
    const coherence = Math.min(1, size / (power![k]! * answer![k]!))
    append(response, k / (segment * step_s), crossRe![k]! / power![k]!, crossIm![k]! / power![k]!, coherence)
  }
  return response.hertz.length ? response : 'still'
}

function append(response: FrequencyResponse, hertz: number, re: number, im: number, coherence: number): void {
  response.hertz.push(hertz)
  response.re.push(re)
  response.im.push(im)
  response.coherence.push(coherence)
}

/**
 * Signals with so many samples before and after, so that the ends of a sweep weigh as much as its middle. Where both are
 * at rest they keep their values; else they are given their means, which excite nothing by themselves.
 */
function padded(signals: readonly [readonly number[], readonly number[]], width: number): [Float64Array, Float64Array] {
  const few = Math.max(Math.floor(signals[0].length / 100), 4)
  const beginsAtRest = signals.every((signal) => span(signal.slice(0, few)) <= AT_REST * span(signal))
  const endsAtRest = signals.every((signal) => span(signal.slice(-few)) <= AT_REST * span(signal))
  const wider = (signal: readonly number[]): Float64Array => {
    const whole = new Float64Array(signal.length + 2 * width)
    whole.fill(beginsAtRest ? signal[0]! : mean(signal), 0, width)
    whole.set(signal, width)
    whole.fill(endsAtRest ? signal[signal.length - 1]! : mean(signal), width + signal.length)
    return whole
  }
  return [wider(signals[0]), wider(signals[1])]
}

function spectrum(stretch: Float64Array): { re: Float64Array; im: Float64Array } {
  const middle = stretch.reduce((sum, value) => sum + value, 0) / stretch.length
  const re = stretch.map((value, k) => (value - middle) * (0.5 - 0.5 * Math.cos((2 * Math.PI * k) / stretch.length)))
  const im = new Float64Array(stretch.length)
  transform(re, im)
  return { re, im }
}

/** The discrete Fourier transform in place, of a power of two of samples (Cooley and Tukey 1965). */
function transform(re: Float64Array, im: Float64Array): void {
  const count = re.length
  reorder(re, im)
  for (let size = 2; size <= count; size *= 2) {
    const half = size / 2
    for (let k = 0; k < half; k += 1) {
      const cos = Math.cos((-2 * Math.PI * k) / size)
      const sin = Math.sin((-2 * Math.PI * k) / size)
      for (let a = k; a < count; a += size) {
        const b = a + half
        const turnedRe = re[b]! * cos - im[b]! * sin
        const turnedIm = re[b]! * sin + im[b]! * cos
        re[b] = re[a]! - turnedRe
        im[b] = im[a]! - turnedIm
        re[a]! += turnedRe
        im[a]! += turnedIm
      }
    }
  }
}

/** Each sample goes to the place whose bits are its own from behind. */
function reorder(re: Float64Array, im: Float64Array): void {
  for (let k = 0, mirrored = 0; k < re.length; k += 1) {
    if (k < mirrored) {
      ;[re[k], re[mirrored]] = [re[mirrored]!, re[k]!]
      ;[im[k], im[mirrored]] = [im[mirrored]!, im[k]!]
    }
    let bit = re.length >> 1
    while (bit && mirrored & bit) {
      mirrored ^= bit
      bit >>= 1
    }
    mirrored |= bit
  }
}

const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length
