import { expect, it } from 'vitest'
import { areOf, bodiesOf, isLit, rowsOf, worldOf, type Shape } from '../../src/values/world'

const ROWS = [1, 2, 3, 1, 0, 0, 0, 4, 5, 6, 0, 1, 0, 0]

it('places of bodies are read however they travel', () => {
  const bytes = btoa(String.fromCharCode(...new Uint8Array(Float32Array.from(ROWS).buffer)))
  for (const given of [ROWS, [ROWS.slice(0, 7), ROWS.slice(7)], bytes, { rows: ROWS }, { rows: bytes }])
    expect([...rowsOf(given)!]).toEqual(ROWS)
  expect(rowsOf(undefined)).toBeUndefined()
  expect(rowsOf('AAA=')).toBeUndefined()
})

it('a lamp is lit only where it is said', () => {
  expect(isLit({ rows: [], lit: true })).toBe(true)
  expect(isLit({ rows: [], lit: ['lamp'] })).toBe(true)
  expect(isLit({ rows: [], lit: [] })).toBe(false)
  expect(isLit([])).toBeUndefined()
})

it('an answer without shapes is no world', () => {
  const shape = { body: 3 } as Shape
  expect(worldOf({ shapes: [shape] })?.shapes).toHaveLength(1)
  expect(bodiesOf(worldOf({ scene: { shapes: [shape] } })!)).toBe(4)
  const buttons = { start: [0, 0, 0] as [number, number, number] }
  expect(worldOf({ shapes: [shape], buttons, switches: ['start'] })).toMatchObject({ buttons, switches: ['start'] })
  expect(worldOf(undefined)).toBeUndefined()
  expect(worldOf({})).toBeUndefined()
})

// R-X19: a URDF often ends with a link that is only a point.
it('places are those of a world whose last bodies have no shape, until one comes or goes', () => {
  const rows = Float32Array.from(ROWS)
  expect([1, 2, 3].map((bodies) => areOf(rows, bodies))).toEqual([true, true, false])
  expect(areOf(rows, 1, ROWS.length)).toBe(true)
  expect(areOf(rows, 1, ROWS.length + 7)).toBe(false)
})
