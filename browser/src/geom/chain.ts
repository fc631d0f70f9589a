// Where the bodies of an arm are for given angles of its joints: numbers only.

/** x y z and w x y z. */
export type Pose = readonly [number, number, number, number, number, number, number]
type Vector = readonly [number, number, number]
type Turn = readonly [number, number, number, number]

/** A body against the one that carries it, as `workcell.scene.Hinge3d`. */
export interface Hinge {
  carrier: number
  position: Vector
  quaternion: Turn
  /** Empty: it has none. */
  joint: string
  slides: boolean
  axis: Vector
  anchor: Vector
}

const product = ([a, b, c, d]: Turn, [e, f, g, h]: Turn): Turn => [
  a * e - b * f - c * g - d * h,
  a * f + b * e + c * h - d * g,
  a * g - b * h + c * e + d * f,
  a * h + b * g - c * f + d * e,
]

function turned([w, x, y, z]: Turn, [a, b, c]: Vector): Vector {
  const [, i, j, k] = product(product([w, x, y, z], [0, a, b, c]), [w, -x, -y, -z])
  return [i, j, k]
}

const sum = ([a, b, c]: Vector, [d, e, f]: Vector, by = 1): Vector => [a + by * d, b + by * e, c + by * f]
const placeOf = (pose: Pose): Vector => [pose[0], pose[1], pose[2]]
const turnOf = (pose: Pose): Turn => [pose[3], pose[4], pose[5], pose[6]]
const posed = ([x, y, z]: Vector, [w, i, j, k]: Turn): Pose => [x, y, z, w, i, j, k]

/** A pose that is given in another one's frame, in the world. */
export const within = (outer: Pose, inner: Pose): Pose =>
  posed(sum(placeOf(outer), turned(turnOf(outer), placeOf(inner))), product(turnOf(outer), turnOf(inner)))

/** The pose of a body where its joint stands at `value`, its carrier's being given. */
export function hung(carrier: Pose, hinge: Hinge, value: number): Pose {
  const rest = within(carrier, posed(hinge.position, hinge.quaternion))
  if (!hinge.joint) return rest
  if (hinge.slides) return posed(sum(placeOf(rest), turned(turnOf(rest), hinge.axis), value), turnOf(rest))
  const [sine, cosine] = [Math.sin(value / 2), Math.cos(value / 2)]
  const [x, y, z] = hinge.axis
  const turn = product(turnOf(rest), [cosine, sine * x, sine * y, sine * z])
  const pivot = sum(placeOf(rest), turned(turnOf(rest), hinge.anchor))
  return posed(sum(pivot, turned(turn, hinge.anchor), -1), turn)
}

/** The joints of an arm in their order, by the bodies that they move. */
export function jointsOf(hinges: ReadonlyMap<number, Hinge>, arm: string): number[] {
  const number = (body: number): number => Number(hinges.get(body)?.joint.slice(`${arm}.joint`.length))
  const own = [...hinges].filter(([, { joint }]) => joint.startsWith(`${arm}.joint`)).map(([body]) => body)
  return own.sort((a, b) => number(a) - number(b))
}

/** The bodies that joints move, and those that stand on such. */
export function movedBodies(hinges: ReadonlyMap<number, Hinge>): Set<number> {
  const moved = new Set<number>()
  for (const [body, { joint, carrier }] of [...hinges].sort(([a], [b]) => a - b))
    if (joint || moved.has(carrier)) moved.add(body)
  return moved
}

/**
 * The poses of all that an arm moves, by body; none where it has not so many joints. What is not of its joints, as the
 * fingers, stands against its carrier as it does now. `now` gives the present pose of a body.
 */
export function posture(
  hinges: ReadonlyMap<number, Hinge>,
  arm: string,
  joints: readonly number[],
  now: (body: number) => Pose,
): Map<number, Pose> {
  const own = jointsOf(hinges, arm)
  const poses = new Map<number, Pose>()
  if (!own.length || own.length !== joints.length) return poses
  for (const body of [...hinges.keys()].sort((a, b) => a - b)) {
    const hinge = hinges.get(body)!
    const at = own.indexOf(body)
    const carrier = poses.get(hinge.carrier)
    if (at >= 0) poses.set(body, hung(carrier ?? now(hinge.carrier), hinge, joints[at]!))
    else if (carrier) poses.set(body, within(carrier, against(now(hinge.carrier), now(body))))
  }
  return poses
}

/** A pose in the frame of another one. */
function against(outer: Pose, inner: Pose): Pose {
  const [w, x, y, z] = turnOf(outer)
  const back: Turn = [w, -x, -y, -z]
  return posed(turned(back, sum(placeOf(inner), placeOf(outer), -1)), product(back, turnOf(inner)))
}
