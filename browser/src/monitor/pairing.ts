// Which of the lines of a scope are reference and measurement, and where a trigger lies, before anybody has chosen.
import type { Course } from './response'

interface Labelled {
  label: string
}

/** The lines that are chosen by their labels; else a reference and its measurement by their names, else the first two. */
export function paired<Line extends Labelled>(
  lines: readonly Line[],
  reference: string,
  measured: string,
): [Line | undefined, Line | undefined] {
  const [wanted, present] = byName(lines) ?? [lines[0], lines[1]]
  const chosen = (label: string): Line | undefined => lines.find((line) => line.label === label)
  return [chosen(reference) ?? wanted, chosen(measured) ?? present]
}

/** The first `…_REF…` beside which `…_MEZ…` is shown. */
function byName<Line extends Labelled>(lines: readonly Line[]): [Line, Line] | undefined {
  for (const wanted of lines) {
    const name = wanted.label.replace('_REF', '_MEZ')
    const present = name === wanted.label ? undefined : lines.find(({ label }) => label === name)
    if (present) return [wanted, present]
  }
  return undefined
}

/** Half way between the lowest and the highest value, to a hundredth of their distance; 0 where there is none. */
export function middle({ y }: Course): number {
  let low = Infinity
  let high = -Infinity
  for (let k = 0; k < y.length; k += 1) {
    low = Math.min(low, y[k]!)
    high = Math.max(high, y[k]!)
  }
  const half = (low + high) / 2
  if (!Number.isFinite(half)) return 0
  if (low === high) return half
  const grain = 10 ** Math.floor(Math.log10((high - low) / 100))
  return Number((Math.round(half / grain) * grain).toPrecision(12))
}
