// Where a card stands that lies over the workspace: as near as it can to what it tells of, but on nothing that is needed.

export interface Span {
  top: number
  bottom: number
}

const GAP = 8

/** The upper side of a card: as near to `wanted` as free room within the window allows; where none is large enough, there. */
export function besideRows(wanted: number, height: number, kept: readonly Span[], window: Span): number {
  const least = window.top + GAP
  const most = Math.max(least, window.bottom - GAP - height)
  const limited = (y: number): number => Math.max(least, Math.min(most, y))
  const isFree = (y: number): boolean => kept.every(({ top, bottom }) => y + height + GAP <= top || y >= bottom + GAP)
  const places = [wanted, ...kept.flatMap(({ top, bottom }) => [top - GAP - height, bottom + GAP])]
  const free = places
    .filter((y) => y === limited(y) || y === wanted)
    .map(limited)
    .filter(isFree)
  return free.sort((a, b) => Math.abs(a - wanted) - Math.abs(b - wanted))[0] ?? limited(wanted)
}
