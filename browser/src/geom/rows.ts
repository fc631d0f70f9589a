// Rows of cells, one below the other: which of them a window sees, and how the arrow keys walk them.

export interface Span {
  readonly top: number
  readonly height: number
}

const PAGE = 6 // rows

/** The rows that a window from `top` to `bottom` sees, found by halving. */
export function seen<R extends Span>(rows: readonly R[], top: number, bottom: number): R[] {
  let [low, high] = [0, rows.length]
  while (low < high) {
    const middle = (low + high) >> 1
    const row = rows[middle]!
    if (row.top + row.height < top) low = middle + 1
    else high = middle
  }
  let end = low
  while (end < rows.length && rows[end]!.top <= bottom) end++
  return rows.slice(low, end)
}

/** The cell that a key leads to from one, in lines of cells by their names; undefined where the key leads nowhere. */
export function walked(lines: readonly (readonly string[])[], name: string, key: string): string | undefined {
  const all = lines.flat()
  const line = lines.findIndex((names) => names.includes(name))
  if (line < 0) return all[0]
  const column = lines[line]!.indexOf(name)
  const at = all.indexOf(name)
  if (key === 'ArrowRight') return all[at + 1] ?? name
  if (key === 'ArrowLeft') return all[at - 1] ?? name
  if (key === 'Home') return all[0]
  if (key === 'End') return all.at(-1)
  const step = { ArrowDown: 1, ArrowUp: -1, PageDown: PAGE, PageUp: -PAGE }[key]
  if (!step) return undefined
  const next = lines[Math.max(0, Math.min(lines.length - 1, line + step))]
  return next?.[Math.min(column, next.length - 1)] ?? name
}
