import { expect, test } from 'vitest'
import type { AnyMessage, RunView } from '../../src/api.gen'
import { carrierOf } from '../../src/player/carrier'
import { Film, type Head } from '../../src/player/film'
import { unpack } from '../../src/player/unpack'

const run = (more: Partial<RunView>): RunView => ({ doc: 'a1', name: 'lift', number: 0, ...more })

/** A document of a run of four instants, a second apart; each block is one row. */
function film(): Film {
  const rows = [
    ['f8', [0, 1, 2, 3]], // instants
    ['f8', [5, 6, 7]], // of X, from the second one on
    ['f4', [0, 0, 0]],
    ['f4', [0, 0, 0]],
    ['f4', [1, 2, 3, 4]], // where a body is
  ] as const
  let at = 0
  const content: number[] = []
  const places = rows.map(([type, numbers]) => {
    const size = type === 'f8' ? 8 : 4
    const bytes = new Uint8Array((type === 'f8' ? new Float64Array(numbers) : new Float32Array(numbers)).buffer)
    const place = { at, type, rows: 1, columns: numbers.length }
    const value = (k: number): bigint =>
      [...bytes.slice(k * size, (k + 1) * size)].reduceRight((sum, byte) => sum * 256n + BigInt(byte), 0n)
    const steps = numbers.map((_, k) => BigInt.asUintN(8 * size, value(k) - (k ? value(k - 1) : 0n)))
    for (let byte = 0; byte < size; byte += 1)
      content.push(...steps.map((step) => Number((step >> BigInt(8 * byte)) & 255n)))
    at = content.length
    return place
  })
  const head: Head = {
    format: 1,
    version: '0',
    period_s: 1,
    tree: {
      review: {
        recording: { path: 'lift.mcap', name: 'lift', variables: { 'flow0/X': { unit: 'm', labels: ['X'] } } },
      },
    },
    instants: 0,
    run: {
      first: run({}),
      changes: [
        [1, [[['flows', 'flow0'], { order: 0, step: 4 }]]],
        [
          3,
          [
            [['state'], 'over'],
            [['flows', 'flow0', 'step'], null],
          ],
        ],
      ],
    },
    states: [[2, { 'flow0/pd': 'ON' }]],
    variables: {
      'flow0/X': { first: 1, dims: [], values: 1, least: 2, most: 3 },
      'flow0/W': { changes: [[2, 'on']] },
      'flow0/NEVER': { first: 4 },
    },
    worlds: {
      yard: {
        shapes: [{ name: 'lamp' }],
        stretches: [{ first: 0, poses: 4 }],
        lit: [
          [0, []],
          [2, ['lamp']],
        ],
      },
    },
    meshes: {},
    blocks: places.map((place) => ({ ...place })),
  }
  const text = new TextEncoder().encode(JSON.stringify(head))
  const whole = new Uint8Array(8 + text.length + content.length)
  new DataView(whole.buffer).setBigUint64(0, BigInt(text.length), true)
  whole.set(text, 8)
  whole.set(content, 8 + text.length)
  return new Film(whole)
}

test('an instant is what was recorded last before it', () => {
  const shown = film()
  expect(shown.instant(-5)).toMatchObject({ at_s: 0, tasks: {}, values: {} })
  expect(shown.instant(1.7)).toMatchObject({
    at_s: 1,
    values: { 'flow0/X': 5 },
    run: { flows: { flow0: { step: 4 } } },
    poses: { yard: { rows: [2], lit: [] } },
  })
  expect(shown.instant(99)).toMatchObject({
    at_s: 3,
    run: { state: 'over', flows: { flow0: { order: 0 } } },
    tasks: { 'flow0/pd': 'ON' },
    values: { 'flow0/X': 7, 'flow0/W': 'on' },
    poses: { yard: { lit: ['lamp'] } },
  })
})

test('time runs backwards as well', () => {
  const shown = film()
  expect([3, 0, 1, 3].map((at_s) => shown.instant(at_s).run.flows?.['flow0']?.step)).toEqual([
    undefined,
    undefined,
    4,
    undefined,
  ])
})

test('a plot touches the least and the greatest value of each part', () => {
  expect(film().course('flow0/X', 0, 3, 1)).toEqual([
    { label: 'X', unit: 'm', at_s: [0, 3], least: [5, 7], most: [7, 7] },
  ])
  expect(film().course('flow0/W', 0, 3)).toEqual([])
  expect(film().course('flow0/NEVER', 0, 3)).toEqual([])
  expect(film().course('flow0/NONE', 0, 3)).toBeUndefined()
})

test('who asks for anything but to look is refused', async () => {
  const heard: AnyMessage[] = []
  const carrier = carrierOf(film())
  carrier.onmessage = ({ data }) => heard.push(JSON.parse(data) as AnyMessage)
  await new Promise((done) => setTimeout(done))
  for (const act of [
    { t: 'Glance', at_s: 1 },
    { t: 'RecordedScene', world: 'yard' },
    { t: 'Stop' },
    { t: 'RecordedScene', world: 'moon' },
  ])
    carrier.send(JSON.stringify({ cid: heard.length, act }))
  await new Promise((done) => setTimeout(done))
  expect(heard.map((message) => message.t)).toEqual(['Snapshot', 'Ok', 'Ok', 'Refused', 'Refused'])
})

test('what is packed comes out of the page', async () => {
  const packed = new Blob([new TextEncoder().encode('run')]).stream().pipeThrough(new CompressionStream('gzip'))
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer())
  const text = btoa(String.fromCharCode(...bytes))
  expect(new TextDecoder().decode(await unpack(`\n${text}\n`))).toBe('run')
  await expect(unpack('AAAA')).rejects.toThrow()
})
