// Which place of a drawn world lies under the pointer.
import { Mesh, Raycaster, Vector2, Vector3, type Camera, type Intersection, type Object3D } from 'three'

type Vector = [number, number, number]

/** The nearest of these parts that is drawn, at shares of the picture (-1 to 1, y upwards). */
export function hitUnder(x: number, y: number, camera: Camera, parts: readonly Object3D[]): Intersection | undefined {
  const ray = new Raycaster()
  for (const part of parts) part.updateWorldMatrix(true, true)
  camera.updateMatrixWorld()
  ray.setFromCamera(new Vector2(x, y), camera)
  return ray
    .intersectObjects([...parts], true)
    .find(({ object, face }) => object instanceof Mesh && object.visible && face)
}

/** On the nearest surface of these parts, at shares of the picture (-1 to 1, y upwards); the normal looks at the camera. */
export function placeUnder(
  x: number,
  y: number,
  camera: Camera,
  parts: readonly Object3D[],
): { position: Vector; normal: Vector } | undefined {
  const hit = hitUnder(x, y, camera, parts)
  if (!hit?.face) return undefined
  const normal = hit.face.normal.clone().transformDirection(hit.object.matrixWorld)
  const way = new Vector3().subVectors(hit.point, camera.getWorldPosition(new Vector3()))
  if (normal.dot(way) > 0) normal.negate() // of a sheet that is seen from behind
  return { position: rounded(hit.point, 4), normal: rounded(normal, 6) }
}

/** Tenths of a millimetre are as much as anybody points at; the dust of the matrices goes. */
function rounded({ x, y, z }: Vector3, places: number): Vector {
  const round = (value: number): number => Number(value.toFixed(places)) + 0
  return [round(x), round(y), round(z)]
}
