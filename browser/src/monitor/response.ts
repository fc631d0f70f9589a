// How a measurement follows its reference: numbers only, of samples in the order of their times.

/** A course in time: at each time its value. */
export interface Course {
  t: ArrayLike<number>
  y: ArrayLike<number>
}

/** Measures of the first step of a reference that jumps: times in s, parts of the step; NaN of any other reference. */
export interface Response {
  /** From 10 % to 90 % of the way. */
  rise_s: number
  /** How far it goes beyond the target, as a part of the step. */
  overshoot: number
  /** From the step until it stays within 2 % of the step about the target. */
  settling_s: number
  /** Reference less measurement, over the last tenth of the time, of a reference that jumps of its first step. */
  steadyError: number
  /** Root of the mean square of reference less measurement. */
  rms: number
}

const FROM = 0.1
const TO = 0.9
const BAND = 0.02
const REST = 0.1

/** The value in force at each of the times: a state variable holds its last one. NaN before the first. */
export function held(course: Course, times: ArrayLike<number>): Float64Array {
  const values = new Float64Array(times.length)
  let k = -1
  for (let n = 0; n < times.length; n += 1) {
    while (k + 1 < course.t.length && course.t[k + 1]! <= times[n]! + 1e-9) k += 1
    values[n] = k < 0 ? NaN : course.y[k]!
  }
  return values
}

/** How `measured` follows `reference`, whose first step counts; times are those of the measurement. */
export function response(reference: Course, measured: Course): Response {
  const { t, y } = measured
  const wanted = held(reference, t)
  const begin = wanted.findIndex((value) => !Number.isNaN(value))
  const none = { rise_s: NaN, overshoot: NaN, settling_s: NaN, steadyError: NaN, rms: NaN }
  if (begin < 0) return none
  const errors = Array.from({ length: t.length - begin }, (_, k) => wanted[begin + k]! - y[begin + k]!)
  const rms = Math.sqrt(mean(errors.map((error) => error * error)))
  const at = wanted.findIndex((value, k) => k > begin && value !== wanted[begin])
  if (at < 0 || !isStepping(wanted, begin, at)) return { ...none, steadyError: mean(lastOf(errors)), rms }
  const until = end(wanted, at)
  const steadyError = mean(lastOf(errors.slice(at - begin, until - begin)))
  return { ...step(t, y, at, until, wanted[at]!), steadyError, rms }
}

const lastOf = (errors: readonly number[]): number[] => errors.slice(Math.floor(errors.length * (1 - REST)))

/** Whether a reference only jumps to and fro between two values, the first of them being left at `at`. */
function isStepping(wanted: Float64Array, begin: number, at: number): boolean {
  return wanted.every((value, k) => k < begin || value === wanted[begin] || value === wanted[at])
}

/** Where the value ends that a reference takes at `at`. */
function end(wanted: Float64Array, at: number): number {
  const next = wanted.findIndex((value, k) => k > at && value !== wanted[at])
  return next < 0 ? wanted.length : next
}

/** Of the step that is wanted from the sample `at` on, up to `until`. */
function step(
  t: ArrayLike<number>,
  y: ArrayLike<number>,
  at: number,
  until: number,
  target: number,
): Pick<Response, 'rise_s' | 'overshoot' | 'settling_s'> {
  const from = y[at]!
  const size = target - from
  if (size === 0) return { rise_s: NaN, overshoot: NaN, settling_s: NaN }
  const way = (k: number): number => (y[k]! - from) / size
  const from_s = reached(t, way, at, until, FROM)
  const to_s = reached(t, way, at, until, TO)
  let most = 0
  let last = at - 1
  for (let k = at; k < until; k += 1) {
    most = Math.max(most, way(k) - 1)
    if (Math.abs(way(k) - 1) > BAND) last = k
  }
  const settling_s = last + 1 < until ? t[last + 1]! - t[at]! : NaN
  return { rise_s: to_s - from_s, overshoot: most, settling_s }
}

/** When a part of the way was reached first, between two samples where it lies between them. */
function reached(t: ArrayLike<number>, way: (k: number) => number, at: number, until: number, part: number): number {
  for (let k = at + 1; k < until; k += 1) {
    if (way(k) < part) continue
    const before = way(k - 1)
    return before >= part ? t[k - 1]! : t[k - 1]! + ((part - before) / (way(k) - before)) * (t[k]! - t[k - 1]!)
  }
  return NaN
}

const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length
