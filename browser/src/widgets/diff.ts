// Two texts side by side, line by line: what both have, what only the first has, what only the second.

export interface Line {
  kind: 'both' | 'first' | 'second'
  text: string
}

/** By the longest common subsequence of what is left when equal beginnings and ends are taken away. */
export function differences(first: string, second: string): Line[] {
  const [a, b] = [first.split('\n'), second.split('\n')]
  let head = 0
  while (head < Math.min(a.length, b.length) && a[head] === b[head]) head++
  let tail = 0
  while (tail < Math.min(a.length, b.length) - head && a.at(-1 - tail) === b.at(-1 - tail)) tail++
  const both = (lines: string[]): Line[] => lines.map((text) => ({ kind: 'both', text }))
  const middle = between(a.slice(head, a.length - tail), b.slice(head, b.length - tail))
  return [...both(a.slice(0, head)), ...middle, ...both(a.slice(a.length - tail))]
}

function between(a: readonly string[], b: readonly string[]): Line[] {
  const table = lengths(a, b)
  const lines: Line[] = []
  let [i, j] = [0, 0]
  while (i < a.length || j < b.length) {
    if (i < a.length && j < b.length && a[i] === b[j]) {
      lines.push({ kind: 'both', text: a[i]! })
      i++
      j++
    } else if (j >= b.length || (i < a.length && table[i + 1]![j]! >= table[i]![j + 1]!))
      lines.push({ kind: 'first', text: a[i++]! })
    else lines.push({ kind: 'second', text: b[j++]! })
  }
  return lines
}

/** Of every pair of remainders, how many lines they have in common at most. */
function lengths(a: readonly string[], b: readonly string[]): Uint32Array[] {
  const table = Array.from({ length: a.length + 1 }, () => new Uint32Array(b.length + 1))
  for (let i = a.length - 1; i >= 0; i--)
    for (let j = b.length - 1; j >= 0; j--)
      table[i]![j] = a[i] === b[j] ? table[i + 1]![j + 1]! + 1 : Math.max(table[i + 1]![j]!, table[i]![j + 1]!)
  return table
}

/** Only what differs, with a few lines around it; `null` where lines are left out. */
export function around(lines: readonly Line[], context = 3): (Line | null)[] {
  const near = lines.map((_, k) =>
    lines.slice(Math.max(0, k - context), k + context + 1).some((line) => line.kind !== 'both'),
  )
  return lines.flatMap((line, k) => (near[k] ? [line] : near[k - 1] || k === 0 ? [null] : []))
}
