// Lines of one variable share a trunk. Drawn once each, two dashed lines on one another would look like a solid one;
// so a line ends where it has come onto what is drawn already.
import type { Pt } from '../geom/rect'

/** How far a line goes on along the trunk, so that its last corner is as round as the others. */
const JOINT_PX = 6

interface Stretch {
  /** Along y rather than x. */
  isUpright: boolean
  /** The coordinate that both ends have in common, and those in which they differ. */
  at: number
  from: number
  to: number
}

/** Routes from pins to one locus; of each the part that no earlier one covers. */
export function trunk(routes: Iterable<readonly Pt[]>): Pt[][] {
  const drawn: Stretch[] = []
  return [...routes].map((route) => {
    const own = trimmed(route, drawn)
    for (let k = 0; k + 1 < route.length; k += 1) drawn.push(stretch(route[k]!, route[k + 1]!))
    return own
  })
}

function trimmed(route: readonly Pt[], drawn: readonly Stretch[]): Pt[] {
  let first = route.length - 1
  while (first > 0 && isCovered(stretch(route[first - 1]!, route[first]!), drawn)) first -= 1
  // From `first` on all is covered; of the stretch before it, the part that leads there may be as well.
  const [a, b] = [route[first - 1], route[first]!]
  const meets = a && meeting(a, b, drawn)
  if (meets) return [...route.slice(0, first), meets]
  if (first === route.length - 1) return [...route]
  return [...route.slice(0, first + 1), toward(b, route[first + 1]!)]
}

/** The first point of a stretch, seen from its beginning, from which on it is covered to its end. */
function meeting(a: Pt, b: Pt, drawn: readonly Stretch[]): Pt | undefined {
  const own = stretch(a, b)
  const axis = own.isUpright ? 1 : 0
  const [start, end] = [a[axis], b[axis]]
  let reach = end
  for (const path of drawn)
    if (path.isUpright === own.isUpright && path.at === own.at && path.from <= end && end <= path.to) {
      const far = start < end ? Math.max(start, path.from) : Math.min(start, path.to)
      if (Math.abs(far - end) > Math.abs(reach - end)) reach = far
    }
  if (reach === end) return undefined
  const joint =
    Math.abs(reach - start) < 1 ? reach + Math.sign(end - start) * Math.min(JOINT_PX, Math.abs(end - start)) : reach
  return own.isUpright ? [own.at, joint] : [joint, own.at]
}

function isCovered(own: Stretch, drawn: readonly Stretch[]): boolean {
  return drawn.some(
    (segment) =>
      segment.isUpright === own.isUpright && segment.at === own.at && segment.from <= own.from && own.to <= segment.to,
  )
}

function stretch([ax, ay]: Pt, [bx, by]: Pt): Stretch {
  return ax === bx
    ? { isUpright: true, at: ax, from: Math.min(ay, by), to: Math.max(ay, by) }
    : { isUpright: false, at: ay, from: Math.min(ax, bx), to: Math.max(ax, bx) }
}

function toward([ax, ay]: Pt, [bx, by]: Pt): Pt {
  const length = Math.hypot(bx - ax, by - ay) || 1
  const part = Math.min(1, JOINT_PX / length)
  return [ax + (bx - ax) * part, ay + (by - ay) * part]
}
