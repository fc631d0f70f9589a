// The value of a state variable in one line.

const MOST = 12

/** A number in about five signs, always as wide: `1.571`, `−0.020`, `1.2e−7`. */
export function number(value: number): string {
  if (Number.isInteger(value) && Math.abs(value) < 1e6) return minus(String(value))
  const size = Math.abs(value)
  if (!Number.isFinite(value)) return minus(String(value))
  return minus(size >= 1e6 || size < 5e-4 ? value.toExponential(1) : value.toFixed(size >= 1000 ? 1 : 3))
}

/** A value: arrays in brackets, rows in rows; what is long ends in the count of what is left out. */
export function compact(value: unknown, most = MOST): string {
  if (value === undefined || value === null) return '–'
  if (typeof value === 'number') return number(value)
  if (typeof value === 'string') return value ? JSON.stringify(value) : '""'
  if (!Array.isArray(value)) return typeof value === 'boolean' ? String(value) : JSON.stringify(value)
  const left = value.length - most
  const parts = value.slice(0, most).map(element(value, most))
  return `[${parts.join(' ')}${left > 0 ? ` … +${left}` : ''}]`
}

/** Measured numbers read best where all have a point, and dust beside large ones is nothing. */
function element(all: readonly unknown[], most: number): (value: unknown) => string {
  const sizes = all.map((value) => (typeof value === 'number' ? Math.abs(value) : NaN))
  const isReal = sizes.some((size) => !Number.isInteger(size) && !Number.isNaN(size))
  const isLarge = Math.max(...sizes) >= 0.01
  return (value) =>
    isReal && typeof value === 'number' && (value === 0 || (isLarge && Math.abs(value) < 5e-4))
      ? '0.000'
      : compact(value, most)
}

function minus(text: string): string {
  return text.replaceAll('-', '−')
}
