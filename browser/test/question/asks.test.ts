import { beforeEach, describe, expect, it } from 'vitest'
import type { AskView, DocumentView } from '../../src/api.gen'
import { asking, Asks, isOfRun } from '../../src/question/asks.svelte'

const ask = (): AskView => ({ items: [] })
const view = (asking: Record<string, AskView | undefined>): DocumentView => ({
  name: 'd',
  order: 1,
  tasks: Object.fromEntries(Object.entries(asking).map(([name, one]) => [name, { x: 0, y: 0, ask: one }])),
})

const doc = (all: Record<string, AskView | undefined>): Record<string, AskView> => asking(view(all))

describe('who asks', () => {
  it('are tasks of the document and of the run, which are told apart', () => {
    const [one, other] = [ask(), ask()]
    const all = asking(view({ jtraj: one, pd: undefined }), [
      { doc: 'a1', name: 'r', number: 1, asks: { 'flow0/jtraj': other } },
    ])
    expect(all).toEqual({ jtraj: one, 'flow0/jtraj': other })
    expect(Object.keys(all).map(isOfRun)).toEqual([false, true])
    expect(asking(undefined, [])).toEqual({})
  })
})

describe('questions of tasks (C13)', () => {
  let asks: Asks
  const [one, other] = [ask(), ask()]
  beforeEach(() => {
    asks = new Asks()
    asks.take(doc({ jtraj: one, gripper: other }))
  })

  it('come one after the other, in the order they were asked', () => {
    expect([asks.shown, asks.waiting]).toEqual(['jtraj', 1])
    asks.take(doc({ gripper: other }))
    expect([asks.shown, asks.waiting]).toEqual(['gripper', 0])
    asks.take(doc({}))
    expect(asks.shown).toBe('')
  })

  it('stay in view while others begin to ask', () => {
    asks.take(doc({ aaa: ask(), jtraj: one, gripper: other }))
    expect([asks.shown, asks.waiting]).toEqual(['jtraj', 2])
  })

  it('are put aside until somebody wants to answer, or the task asks anew', () => {
    asks.putAside(one)
    asks.putAside(other)
    asks.take(doc({ jtraj: one, gripper: other }))
    expect(asks.shown).toBe('')
    asks.open('gripper')
    expect([asks.shown, asks.wanted]).toEqual(['gripper', 'gripper'])
    asks.putAside(other)
    asks.take(doc({ jtraj: ask(), gripper: other }))
    expect([asks.shown, asks.waiting]).toEqual(['jtraj', 0])
  })

  it('cannot be opened where nobody asks', () => {
    asks.open('pd')
    expect([asks.shown, asks.wanted]).toEqual(['jtraj', ''])
  })

  it('keep what was typed while they are put aside, and nothing of another question', () => {
    asks.keep(one, ['0.5', '1'])
    asks.putAside(one)
    asks.open('jtraj')
    expect(asks.draft(one)).toEqual(['0.5', '1'])
    expect(asks.draft(ask())).toBeUndefined()
  })
})
