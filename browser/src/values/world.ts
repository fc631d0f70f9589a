// A simulated world as it travels: its shapes once, then the places of its bodies.
import type { Hinge } from '../geom/chain'

/** As `workcell.scene.Shape3d`: lengths in metres, sizes are half sizes, quaternions w x y z. */
export interface Shape {
  name: string
  body: number
  kind: string
  size: number[]
  position: [number, number, number]
  quaternion: [number, number, number, number]
  rgba: [number, number, number, number]
  paint: string
  /** Names the mesh within the box that size and place say; empty where it is none. */
  mesh?: string
  hinge?: Hinge | null
}

export interface World {
  shapes: Shape[]
  /** Panic buttons and switches that a hand touches, which have no shape. */
  buttons?: Buttons
  /** Which of them are switches. */
  switches?: readonly string[]
}

/** Where buttons are, x y z, and how high what their posts stand on, in m, by name. */
export type Buttons = Record<string, [number, number, number, number?]>

/** The parts that a hand may touch, in the answer to `Scene`. */
export function partsOf(answer: unknown): string[] {
  const parts = (answer as { parts?: unknown } | null | undefined)?.parts
  return parts && typeof parts === 'object' ? Object.keys(parts).sort() : []
}

/** x y z and w x y z. */
export const ROW = 7

interface Answer {
  shapes?: unknown
  buttons?: Buttons
  switches?: readonly string[]
}

/** The shapes in an answer to `Scene`; undefined where there are none. */
export function worldOf(answer: unknown): World | undefined {
  const given = answer as (Answer & { scene?: Answer }) | null | undefined
  const shapes = given?.shapes ?? given?.scene?.shapes
  if (!Array.isArray(shapes)) return undefined
  return { shapes: shapes as Shape[], buttons: given?.buttons, switches: given?.switches }
}

/** A row for each body: given as rows, as one list of numbers, or as the bytes of float32 numbers in base64. */
export function rowsOf(given: unknown): Float32Array | undefined {
  if (typeof given === 'string') return fromBase64(given)
  if (Array.isArray(given)) return Float32Array.from(given.flat() as number[])
  if (given && typeof given === 'object' && 'rows' in given) return rowsOf(given.rows)
  return undefined
}

/** Whether lamps are lit; undefined where it is not said. */
export function isLit(given: unknown): boolean | undefined {
  if (!given || typeof given !== 'object' || !('lit' in given)) return undefined
  return Array.isArray(given.lit) ? given.lit.length > 0 : Boolean(given.lit)
}

/** Paint of the air about a lamp, which shines with it. */
export const GLOW = 'glow'

export const hasLamp = (world: World | undefined): boolean =>
  world?.shapes.some((shape) => shape.paint === GLOW) === true

/** How many bodies there are at least: the last ones may have no shape, such as the point of a tool. */
export const bodiesOf = (world: World): number =>
  world.shapes.reduce((most, shape) => Math.max(most, shape.body), 0) + 1

/** Whether places are those of a world with so many bodies that have shapes, and none has come or gone since `before`. */
export const areOf = (rows: Float32Array, bodies: number, before = rows.length): boolean =>
  rows.length >= bodies * ROW && rows.length === before

function fromBase64(text: string): Float32Array | undefined {
  const bytes = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0))
  return bytes.length % 4 ? undefined : new Float32Array(bytes.buffer)
}
