// The link: every act is answered once, whatever becomes of the connection.
import { beforeEach, describe, expect, test, vi } from 'vitest'
import type { AnyMessage } from '../../src/api.gen'
import { desk } from '../../src/link/desk.svelte'
import { Link, type Carrier } from '../../src/link/link'
import { Refusal } from '../../src/link/refusal'
import { plain } from '../../src/texts/say'

class Wire implements Carrier {
  onopen = null
  onclose: ((event: never) => unknown) | null = null
  onmessage: ((event: { data: string }) => unknown) | null = null
  sent: { cid: number; act: { t: string } }[] = []
  send(text: string): void {
    this.sent.push(JSON.parse(text))
  }
  close(): void {
    this.onclose?.(undefined as never)
  }
  say(message: AnyMessage): void {
    this.onmessage?.({ data: JSON.stringify(message) })
  }
}

const snapshot = (rev = 7): AnyMessage => ({ t: 'Snapshot', rev, tree: {}, version: '1', you: 'ada' })
let wires: Wire[]
let link: Link

beforeEach(async () => {
  vi.useFakeTimers()
  wires = []
  link = new Link(() => {
    const wire = new Wire()
    wires.push(wire)
    return wire
  })
  desk.isLinked = false
  await link.start()
})

const first = (): Wire => wires[0]!

describe('the link', () => {
  test('sends nothing before the first snapshot, and says why', async () => {
    await expect(link.send({ t: 'New' })).rejects.toBeInstanceOf(Refusal)
    expect(first().sent).toEqual([])
  })

  test('resolves an act with the value of its own answer', async () => {
    first().say(snapshot())
    const [a, b] = [link.send({ t: 'New' }), link.send({ t: 'Stop' })]
    const [one, two] = first().sent
    first().say({ t: 'Ok', cid: two!.cid, rev: 7 })
    first().say({ t: 'Ok', cid: one!.cid, rev: 7, value: 'd1' })
    await expect(a).resolves.toBe('d1')
    await expect(b).resolves.toBeUndefined()
  })

  test('rejects a refused act with reason, remedies and fields', async () => {
    first().say(snapshot())
    const answer = link.send({ t: 'New' })
    first().say({
      t: 'Refused',
      cid: first().sent[0]!.cid,
      reason: plain('no'),
      remedies: [{ label: plain('Show'), show: { t: 'ShowConnect' } }],
      fields: { name: plain('empty') },
    })
    const why = await answer.catch((refusal: unknown) => refusal)
    expect(why).toMatchObject({ reason: 'no', remedies: [{ label: plain('Show') }], fields: { name: 'empty' } })
  })

  test('refuses what was under way when the connection broke, and connects again by itself', async () => {
    first().say(snapshot())
    const answer = link.send({ t: 'New' })
    first().close()
    await expect(answer).rejects.toBeInstanceOf(Refusal)
    expect(desk.isLinked).toBe(false)
    await vi.advanceTimersByTimeAsync(1000)
    expect(wires).toHaveLength(2)
    wires[1]!.say(snapshot(9))
    expect([desk.isLinked, desk.rev]).toEqual([true, 9])
  })

  test('waits longer from try to try, up to ten seconds', async () => {
    for (let tries = 0; tries < 14; tries++) {
      wires.at(-1)!.close()
      await vi.advanceTimersByTimeAsync(10_000)
    }
    expect(wires).toHaveLength(15)
    wires.at(-1)!.close()
    await vi.advanceTimersByTimeAsync(9_000)
    expect(wires).toHaveLength(15)
  })

  test('R-F01: says so where the environment does not let this browser in', async () => {
    let isLocked = true
    link = new Link(
      () => wires[wires.push(new Wire()) - 1]!,
      () => Promise.resolve(isLocked),
    )
    await link.start()
    wires.at(-1)!.close()
    await vi.advanceTimersByTimeAsync(1000)
    expect(desk.isLocked).toBe(true)
    isLocked = false
    wires.at(-1)!.say(snapshot())
    expect([desk.isLocked, desk.isLinked]).toEqual([false, true])
  })

  test('a gap in the revisions ends in a new snapshot', async () => {
    first().say(snapshot(3))
    first().say({ t: 'Patch', rev: 4, changes: [[['clipboard'], 'pd']] })
    expect(desk.tree.clipboard).toBe('pd')
    first().say({ t: 'Patch', rev: 6, changes: [[['clipboard'], 'diff']] })
    expect(desk.tree.clipboard).toBe('pd')
    await vi.advanceTimersByTimeAsync(1000)
    expect(wires).toHaveLength(2)
  })

  test('tells everybody who listens, until they stop', () => {
    const sentences: string[] = []
    const end = link.hear('Say', (say) => sentences.push(say.text.text))
    first().say({ t: 'Say', level: 'info', text: plain('one') })
    end()
    first().say({ t: 'Say', level: 'info', text: plain('two') })
    expect(sentences).toEqual(['one'])
  })
})
