// The meshes of a world, fetched by the name of their content; a browser keeps them for ever. Until they are there, and
// where there are none, boxes stand for them.
import { BufferAttribute, BufferGeometry } from 'three'
import { surfaceOf } from '../geom/mesh'
import { send } from '../link/link'
import { meshBytes } from '../values/meshBytes'
import type { Shape, World } from '../values/world'

type Put = (mesh: string, geometry: BufferGeometry) => void

/** Hand over each mesh of a world as soon as it is there; what has never been drawn is made first. */
export async function dress(world: World, name: string, put: Put): Promise<void> {
  const shapes = new Map(world.shapes.flatMap((shape) => (shape.mesh ? [[shape.mesh, shape] as const] : [])))
  if (!shapes.size) return
  const made = (await send({ t: 'Meshes', world: name, meshes: [...shapes.keys()] }).catch(() => [])) as string[]
  await Promise.all(made.map((mesh) => fetched(mesh, shapes.get(mesh), put)))
}

async function fetched(mesh: string, shape: Shape | undefined, put: Put): Promise<void> {
  const bytes = await meshBytes.of(mesh)
  const geometry = bytes && shape && geometryOf(bytes, shape.size)
  if (geometry) put(mesh, geometry)
}

function geometryOf(bytes: ArrayBuffer, size: readonly number[]): BufferGeometry | undefined {
  const surface = surfaceOf(bytes, size)
  if (!surface) return undefined
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(surface.corners, 3))
  geometry.setAttribute('normal', new BufferAttribute(surface.normals, 3))
  return geometry
}
