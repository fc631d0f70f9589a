// A place of the workcell that is pointed at: who wants one says so, and the view of the workcell takes the click (D25).

type Vector = readonly [number, number, number]

/** A place on the surface of something, in m, and where that surface looks. */
export interface PointedPlace {
  world: string
  position: Vector
  normal: Vector
}

interface Pointing {
  /** What is done with a place that is clicked; undefined: a click means nothing. */
  take: ((place: PointedPlace) => void) | undefined
  /** The place that counts, for the view to mark it. */
  mark: PointedPlace | undefined
  /** Where in the window the workcell is clicked: what asks for a place leaves it free. */
  room: DOMRect | undefined
}

export const pointing: Pointing = $state({ take: undefined, mark: undefined, room: undefined })

/** So far in front of a place, in m; negative: behind its surface. */
export function before({ position: [x, y, z], normal: [a, b, c] }: PointedPlace, away: number): Vector {
  return [x + away * a, y + away * b, z + away * c]
}

/** Into the surface. */
export const into = ({ normal: [a, b, c] }: PointedPlace): Vector => [0 - a, 0 - b, 0 - c]
