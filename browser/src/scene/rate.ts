// A task's rate as it stands on its icon: a frequency, or a period where the user prefers that (§A.5).

export function rateText(hz: number | null | undefined, showsPeriod = false): string {
  if (!hz) return ''
  if (!showsPeriod) return `${figure(hz)} Hz`
  const ms = 1000 / hz
  return ms >= 1 ? `${figure(ms)} ms` : `${figure(ms * 1000)} µs`
}

/** At most four places that count, and none that say nothing. */
const figure = (value: number): string => String(Number(value.toPrecision(4)))
