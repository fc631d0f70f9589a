// What is read off a frequency response, as `onika recording response` reads it: bandwidth, peak, margins.
import { decibels, isReliable, type FrequencyResponse } from './frequencyResponse'

/** Frequencies in Hz, gains in dB, angles in degrees; NaN where there is none. */
export interface Readings {
  low_dB: number
  bandwidth_Hz: number
  /** By how much the greatest gain is above that of the lowest frequency. */
  peak_dB: number
  peak_Hz: number
  phaseMargin: number
  phaseMargin_Hz: number
  gainMargin_dB: number
  gainMargin_Hz: number
}

const FALLEN_DB = 10 * Math.log10(2)

interface Point {
  hertz: number
  re: number
  im: number
}

/** Margins are those of the open loop: the response itself, or H / (1 - H) where its loop was closed by 1. */
export function readings(response: FrequencyResponse, isOpen: boolean): Readings {
  const points = response.hertz
    .map((hertz, k) => ({ hertz, re: response.re[k]!, im: response.im[k]! }))
    .filter((_, k) => isReliable(response.coherence[k]!))
  const gains = points.map(({ re, im }) => decibels(re, im))
  const low_dB = gains[0] ?? NaN
  const most = gains.reduce((most, gain) => Math.max(most, gain), -Infinity)
  const loop = isOpen ? points : points.map(opened)
  const [phaseMargin, phaseMargin_Hz] = phaseMarginOf(loop)
  const [gainMargin_dB, gainMargin_Hz] = gainMarginOf(loop)
  return {
    low_dB,
    bandwidth_Hz: between(points, ...fall(gains, low_dB - FALLEN_DB)),
    peak_dB: most - low_dB,
    peak_Hz: points[gains.indexOf(most)]?.hertz ?? NaN,
    phaseMargin,
    phaseMargin_Hz,
    gainMargin_dB,
    gainMargin_Hz,
  }
}

/** H / (1 - H). */
function opened({ hertz, re, im }: Point): Point {
  const size = (1 - re) ** 2 + im ** 2
  return { hertz, re: (re * (1 - re) - im * im) / size, im: im / size }
}

/** Behind which place values first fall through a level, and at which part of the way; -1: nowhere. */
function fall(values: readonly number[], level: number): [number, number] {
  const place = values.findIndex((value, k) => value >= level && k + 1 < values.length && values[k + 1]! < level)
  return [place, (values[place]! - level) / (values[place]! - values[place + 1]!)]
}

/** The frequency there, as a logarithmic axis parts them. */
function between(points: readonly Point[], place: number, part: number): number {
  const [point, next] = [points[place], points[place + 1]]
  return point && next ? point.hertz * (next.hertz / point.hertz) ** part : NaN
}

function phaseMarginOf(loop: readonly Point[]): [number, number] {
  const [place, part] = fall(
    loop.map(({ re, im }) => decibels(re, im)),
    0,
  )
  const [a, b] = [loop[place], loop[place + 1]]
  if (!a || !b) return [NaN, NaN]
  const turn = Math.atan2(b.im * a.re - b.re * a.im, b.re * a.re + b.im * a.im)
  const angle = ((Math.atan2(-a.im, -a.re) + part * turn) * 180) / Math.PI
  return [angle - 360 * Math.round(angle / 360), between(loop, place, part)]
}

/** The phase goes through -180 degrees where the loop crosses the negative real axis from below. */
function gainMarginOf(loop: readonly Point[]): [number, number] {
  const place = loop.findIndex((a, k) => {
    const b = loop[k + 1]
    return b && a.im < 0 && b.im >= 0 && a.re < 0 && b.re < 0
  })
  const [a, b] = [loop[place], loop[place + 1]]
  if (!a || !b) return [NaN, NaN]
  const part = a.im / (a.im - b.im)
  const [before, after] = [decibels(a.re, a.im), decibels(b.re, b.im)]
  return [-(before + part * (after - before)), between(loop, place, part)]
}
