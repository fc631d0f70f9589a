// A plot's numbers as a table for other programs.
import type { Stretch } from '../values/series'

/** Lines of `t` and one column for each name, parted by commas, as every spreadsheet reads them. */
export function csv(stretch: Stretch, names: readonly string[], elements: readonly number[]): string {
  const head = ['t_s', ...names].map(quoted).join(',')
  const rows = Array.from(stretch.t, (t, k) => [round(t), ...elements.map((e) => String(stretch.y[e][k]))].join(','))
  return [head, ...rows, ''].join('\r\n')
}

function quoted(word: string): string {
  return /[",\r\n]/.test(word) ? `"${word.replaceAll('"', '""')}"` : word
}

/** Microseconds are enough; binary dust behind them is not shown. */
function round(t: number): string {
  return String(Math.round(t * 1e6) / 1e6)
}
