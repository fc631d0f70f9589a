// The limits of a vertical axis: round numbers about all values, which do not jump with each sample.

/** Round limits about `low` and `high`. The former ones stay while they hold everything and are not much too wide. */
export function limits(low: number, high: number, former?: readonly [number, number]): [number, number] {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return former ? [former[0], former[1]] : [-1, 1]
  const least = Math.max(Math.abs(low), Math.abs(high)) * 1e-6 || 1
  const size = Math.max(high - low, least)
  if (former && former[0] <= low && high <= former[1] && former[1] - former[0] <= 3 * size)
    return [former[0], former[1]]
  const step = stepFor(size)
  return [Math.floor((low - 0.04 * size) / step) * step, Math.ceil((high + 0.04 * size) / step) * step]
}

/** 1, 2 or 5 times a power of ten: about six steps in a stretch. */
function stepFor(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size / 6))
  const rest = size / 6 / power
  return power * (rest > 5 ? 10 : rest > 2 ? 5 : rest > 1 ? 2 : 1)
}
