// From where a world is looked at first, so that all of it is seen.
import { Box3, Vector3 } from 'three'

/** The direction in which the eye stands. */
export const FROM = new Vector3(-1.15, -1.55, 0.75).normalize()

/** From how far a box is seen whole about its middle, where `slope` is how much a view of 1 m in depth shows each way. */
export function distanceTo(box: Box3, middle: Vector3, slope: number): number {
  const { min, max } = box
  let far = 0
  for (const x of [min.x, max.x])
    for (const y of [min.y, max.y])
      for (const z of [min.z, max.z]) {
        const corner = new Vector3(x, y, z).sub(middle)
        const depth = corner.dot(FROM)
        const aside = Math.sqrt(Math.max(0, corner.lengthSq() - depth * depth))
        far = Math.max(far, depth + aside / slope)
      }
  return far
}
