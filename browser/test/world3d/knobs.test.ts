// R-K06: a panic button in the picture, and what a click on it finds.
import { BoxGeometry, Mesh, MeshBasicMaterial, PerspectiveCamera, type MeshLambertMaterial } from 'three'
import { beforeEach, expect, test } from 'vitest'
import { Knobs } from '../../src/world3d/knobs'
import { hitUnder } from '../../src/world3d/picking'

let knobs: Knobs
let camera: PerspectiveCamera

beforeEach(() => {
  knobs = new Knobs({ panic: [0, 0, 0.5], bell: [1, 0, 0.5] })
  camera = new PerspectiveCamera(30, 1, 0.02, 60)
  camera.position.set(0, 0, 5)
  camera.lookAt(0, 0, 0)
})

const under = (...before: Mesh[]): string | undefined =>
  knobs.of(hitUnder(0, 0, camera, [knobs.group, ...before])?.object)
const heights = (): number[] =>
  knobs.group.children.filter(({ userData }) => 'free' in userData).map(({ position }) => position.z)

test('the button under the pointer is found by name, and nothing where none is', () => {
  expect(under()).toBe('panic')
  camera.position.set(0.5, 0, 5)
  camera.lookAt(0.5, 0, 0)
  expect(under()).toBeUndefined()
})

test('a button behind something is not pressed', () => {
  const wall = new Mesh(new BoxGeometry(1, 1, 0.1), new MeshBasicMaterial())
  wall.position.set(0, 0, 2)
  expect(under(wall)).toBeUndefined()
})

test('what is pressed is down, and comes up again', () => {
  const [panic, bell] = heights()
  knobs.press(['panic'])
  expect(heights()[0]).toBeLessThan(panic! - 0.01)
  expect(heights()[1]).toBe(bell)
  knobs.press([])
  expect(heights()).toEqual([panic, bell])
})

// R-X19: what only is touched looks like no panic button.
test('a switch is a box of another colour, which changes while it is touched', () => {
  const mixed = new Knobs({ panic: [0, 0, 0], start: [1, 0, 0] }, ['start'])
  const [panic, start] = mixed.group.children.filter(({ userData }) => 'free' in userData) as Mesh[]
  const color = (mesh: Mesh): string => (mesh.material as MeshLambertMaterial).color.getHexString()
  expect([start!.geometry.type, panic!.geometry.type]).toEqual(['BoxGeometry', 'CylinderGeometry'])
  const [red, blue] = [color(panic!), color(start!)]
  expect(red).not.toBe(blue)
  mixed.press(['start'])
  expect([color(panic!), color(start!) === blue]).toEqual([red, false])
  mixed.press([])
  expect(color(start!)).toBe(blue)
})
