// Two courses at the same instants, evenly in time: a state variable keeps its value until the next one.
import { held, type Course } from './response'

export interface Even {
  step_s: number
  reference: number[]
  measured: number[]
}

const STRAY = 0.25
const MOST_STRAYS = 0.1

/** Both at the instants at which the measurement comes; null: it does not come evenly. */
export function evenSamples(reference: Course, measured: Course): Even | null {
  const begin_s = Math.max(reference.t[0] ?? NaN, measured.t[0] ?? NaN)
  const times = Array.from(measured.t).filter((at_s) => at_s >= begin_s - 1e-9)
  if (times.length < 2) return { step_s: NaN, reference: [], measured: [] }
  const step_s = stepOf(times)
  if (Number.isNaN(step_s)) return null
  const count = Math.floor((times[times.length - 1]! - times[0]!) / step_s + 0.5) + 1
  const instants = new Float64Array(count)
  let next = 0
  for (let k = 0; k < count; k += 1) {
    const wished = times[0]! + k * step_s
    while (next + 1 < times.length && Math.abs(times[next + 1]! - wished) < Math.abs(times[next]! - wished)) next += 1
    instants[k] = Math.abs(times[next]! - wished) <= step_s / 2 ? times[next]! : wished
  }
  return { step_s, reference: [...held(reference, instants)], measured: [...held(measured, instants)] }
}

/** The time from one to the next, where some may be missing; NaN: they do not come evenly. */
function stepOf(times: readonly number[]): number {
  const steps = times.slice(1).map((at_s, k) => at_s - times[k]!)
  const usual = [...steps].sort((a, b) => a - b)[Math.floor(steps.length / 2)]!
  const even = steps.filter((step) => {
    const parts = step / usual
    return Math.round(parts) > 0 && Math.abs(parts - Math.round(parts)) <= STRAY
  })
  if (steps.length - even.length > MOST_STRAYS * steps.length) return NaN
  const whole = even.reduce((sum, step) => sum + Math.round(step / usual), 0)
  return even.reduce((sum, step) => sum + step, 0) / whole
}
