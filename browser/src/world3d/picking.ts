// Which place of a drawn world lies under the pointer.
import { Mesh, Raycaster, Vector2, Vector3, type Camera, type Object3D } from 'three'

type Vector = [number, number, number]

/** On the nearest surface of these parts, at shares of the picture (-1 to 1, y upwards); the normal looks at the camera. */
export function placeUnder(
  x: number,
  y: number,
  camera: Camera,
  parts: readonly Object3D[],
): { position: Vector; normal: Vector } | undefined {
  const ray = new Raycaster()
  for (const part of parts) part.updateWorldMatrix(true, true)
  camera.updateMatrixWorld()
  ray.setFromCamera(new Vector2(x, y), camera)
  const hit = ray
    .intersectObjects([...parts], true)
    .find(({ object, face }) => object instanceof Mesh && object.visible && face)
  if (!hit?.face) return undefined
  const normal = hit.face.normal.clone().transformDirection(hit.object.matrixWorld)
  if (normal.dot(ray.ray.direction) > 0) normal.negate() // of a sheet that is seen from behind
  return { position: rounded(hit.point, 4), normal: rounded(normal, 6) }
}

/** Tenths of a millimetre are as much as anybody points at; the dust of the matrices goes. */
function rounded({ x, y, z }: Vector3, places: number): Vector {
  const round = (value: number): number => Number(value.toFixed(places)) + 0
  return [round(x), round(y), round(z)]
}
