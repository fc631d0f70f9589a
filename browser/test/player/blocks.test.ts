import { expect, test } from 'vitest'
import { Blocks, unpacked } from '../../src/player/blocks'

/** As the environment packs: differences of neighbours in a row, byte plane by byte plane. */
function packed(rows: readonly Float64Array[]): Uint8Array<ArrayBuffer> {
  const steps = rows.flatMap((row) => {
    const bits = new BigUint64Array(row.buffer)
    return [...bits].map((bit, k) => BigInt.asUintN(64, bit - (k ? bits[k - 1]! : 0n)))
  })
  return Uint8Array.from(
    Array.from({ length: 8 }, (_, byte) => steps.map((step) => Number((step >> BigInt(8 * byte)) & 255n))).flat(),
  )
}

test('numbers come back bit by bit, those that are none with them', () => {
  const rows = [new Float64Array([0.1, -0, 1e300, NaN]), new Float64Array([-1.5, Infinity, 2, 2])]
  const blocks = new Blocks([{ at: 0, type: 'f8', rows: 2, columns: 4 }], packed(rows))
  expect(blocks.doubles(0)).toEqual(rows)
  expect(blocks.doubles(0)).toBe(blocks.doubles(0)) // unpacked once
})

test('a block of another kind is no numbers', () => {
  const blocks = new Blocks([{ at: 1, type: 'bytes', rows: 1, columns: 2 }], new Uint8Array([9, 7, 8, 9]))
  expect(new Uint8Array(blocks.bytes(0))).toEqual(new Uint8Array([7, 8]))
  expect(() => blocks.doubles(0)).toThrow('expected a block of f8, found bytes')
  expect(() => blocks.floats(4)).toThrow('found none')
})

test('a sum that goes beyond a byte goes on in the next one', () => {
  expect([...unpacked(new Uint8Array([255, 1, 0, 0]), 2, 2)]).toEqual([255, 0, 0, 1])
})
