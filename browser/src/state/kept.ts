// Small things that this browser keeps from one visit to the next.

const PREFIX = 'onika.'

/** What was kept under a name, where it is of the same kind as the default; else the default. */
export function kept<T>(name: string, otherwise: T): T {
  try {
    const text = localStorage.getItem(PREFIX + name)
    if (text === null) return otherwise
    const value: unknown = JSON.parse(text)
    if (typeof value !== typeof otherwise || Array.isArray(value) !== Array.isArray(otherwise)) return otherwise
    const isMap = typeof otherwise === 'object' && otherwise !== null && !Array.isArray(otherwise)
    return (isMap ? { ...otherwise, ...(value as object) } : value) as T
  } catch {
    return otherwise // a browser may forbid it, and somebody may have written nonsense
  }
}

export function keep(name: string, value: unknown): void {
  try {
    localStorage.setItem(PREFIX + name, JSON.stringify(value))
  } catch {
    // kept for this visit only
  }
}
