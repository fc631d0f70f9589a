// Which stretch of time a plot shows: the newest seconds, or a range that was picked by hand.

export interface Span {
  /** How much of the newest is shown. */
  window_s: number
  /** A range picked by hand; null: the newest. */
  range: readonly [number, number] | null
}

export const LIVE: Span = { window_s: 8, range: null }

const LEAST_S = 0.02
const MOST_S = 60
const NOTCH = 1.25

/** From when to when, where the newest sample is of `newest_s`. */
export function shown(span: Span, newest_s: number): [number, number] {
  return span.range ? [span.range[0], span.range[1]] : [newest_s - span.window_s, newest_s]
}

/** After a turn of the wheel over the time `at_s`: live, the newest end stays; else what lies under the pointer does. */
export function wheeled(span: Span, at_s: number, notches: number, most_s = MOST_S): Span {
  const factor = NOTCH ** notches
  if (!span.range) return { window_s: clamp(span.window_s * factor, 1, MOST_S), range: null }
  const [from, to] = span.range
  const length = clamp((to - from) * factor, LEAST_S, Math.max(most_s, LEAST_S))
  const start = at_s - ((at_s - from) / (to - from)) * length
  return { ...span, range: [start, start + length] }
}

/** After a drag from one time to another, in either direction. */
export function picked(span: Span, one_s: number, other_s: number): Span {
  const from = Math.min(one_s, other_s)
  return { ...span, range: [from, Math.max(one_s, other_s, from + LEAST_S)] }
}

/** Moved by a share of what is shown, to look around in what has been. */
export function moved(span: Span, newest_s: number, share: number): Span {
  const [from, to] = shown(span, newest_s)
  const by = (to - from) * share
  return { ...span, range: [from + by, to + by] }
}

function clamp(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value))
}
