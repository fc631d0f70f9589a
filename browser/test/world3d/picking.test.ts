// R-D25: the place under the pointer, on what stands there.
import { BoxGeometry, Group, Mesh, MeshBasicMaterial, PerspectiveCamera, PlaneGeometry } from 'three'
import { expect, test } from 'vitest'
import { placeUnder } from '../../src/world3d/picking'

/** From above, looking at the middle of a floor. */
function above(): PerspectiveCamera {
  const camera = new PerspectiveCamera(30, 1, 0.02, 60)
  camera.position.set(0, 0, 5)
  camera.lookAt(0, 0, 0)
  return camera
}

/** A cube of 0.2 m as a body at a place. */
function cube(x: number, y: number, z: number): Group {
  const group = new Group()
  group.position.set(x, y, z)
  group.add(new Mesh(new BoxGeometry(0.2, 0.2, 0.2), new MeshBasicMaterial()))
  return group
}

const floor = (): Group => new Group().add(new Mesh(new PlaneGeometry(4, 4), new MeshBasicMaterial()))

test('the nearest surface counts, with where it looks', () => {
  expect(placeUnder(0, 0, above(), [floor(), cube(0, 0, 0.3)])).toEqual({ position: [0, 0, 0.4], normal: [0, 0, 1] })
  expect(placeUnder(0, 0, above(), [floor()])).toEqual({ position: [0, 0, 0], normal: [0, 0, 1] })
})

test('a body that lies askew has a surface that looks askew', () => {
  const tilted = cube(0, 0, 0.3)
  tilted.rotation.x = Math.PI / 6
  const place = placeUnder(0, 0, above(), [tilted])
  expect(place?.normal).toEqual([0, -0.5, 0.866025])
})

test('what is not drawn is no place, and where nothing stands there is none', () => {
  const hidden = cube(0, 0, 0.3)
  hidden.children[0]!.visible = false
  expect(placeUnder(0, 0, above(), [hidden])).toBeUndefined()
  expect(placeUnder(0.9, 0.9, above(), [cube(0, 0, 0)])).toBeUndefined()
})
