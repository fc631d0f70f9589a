// Names beside the ends of lines, moved apart so that none covers another.

/** Places near the wished ones, at least `gap` apart and, as far as there is room, between `top` and `bottom`. */
export function spread(wished: readonly number[], gap: number, top: number, bottom: number): number[] {
  const order = wished.map((_, k) => k).sort((a, b) => wished[a] - wished[b])
  const places = [...wished]
  let free = top
  for (const k of order) {
    places[k] = Math.max(wished[k], free)
    free = places[k] + gap
  }
  let below = bottom
  for (const k of order.reverse()) {
    places[k] = Math.min(places[k], below)
    below = places[k] - gap
  }
  return places
}
