// R-E11, R-X03: what has happened in a run, as blocks of time.
import { describe, expect, it } from 'vitest'
import type { ApplicationView, FlowRunView, RunView, StepRunView } from '../../src/api.gen'
import { flowsOfSteps, Past, type Block } from '../../src/progress/past'
import { bars, scale, ticks, windowOf } from '../../src/progress/timeline'
import { plain } from '../../src/texts/say'

const APP: ApplicationView = {
  name: 'one',
  order: 1,
  is_parallel: true,
  flows: { 0: { steps: [1, 2, 17] }, '0/17/0': { steps: [3] }, 1: { steps: [4] } },
}
const run = (
  steps: Record<string, StepRunView>,
  flows: Record<string, FlowRunView> = {},
  more: Partial<RunView> = {},
): RunView => ({ doc: 'a1', name: 'r', number: 1, state: 'running', steps, flows, ...more })
const told = (past: Past): unknown[] =>
  past.blocks.map(({ kind, flow, step, from_s, to_s }) => [kind, flow, step, from_s, to_s])

describe('the past of a run', () => {
  it('steps of branches belong to the flow around them', () => {
    expect(flowsOfSteps(APP)).toEqual(
      new Map([
        [1, 0],
        [2, 0],
        [17, 0],
        [3, 0],
        [4, 1],
      ]),
    )
  })

  it('is open while an action goes on, and shut when it is done', () => {
    let past = new Past().with(run({ 1: { began_s: 0.5 } }), APP)
    expect(told(past)).toEqual([['action', 0, 1, 0.5, NaN]])
    past = past.with(run({ 1: { state: 'done', began_s: 0.5, took_s: 2 }, 4: { began_s: 1 } }), APP)
    expect(told(past)).toEqual([
      ['action', 0, 1, 0.5, 2.5],
      ['action', 1, 4, 1, NaN],
    ])
  })

  it('keeps every round of a loop, also where no message told of its end', () => {
    let past = new Past().with(run({ 1: { began_s: 0 } }), APP)
    past = past.with(run({ 1: { began_s: 3, took_s: 2, times: 1 } }), APP)
    past = past.with(run({ 1: { state: 'done', began_s: 3, took_s: 2.5, times: 2 } }), APP)
    expect(told(past)).toEqual([
      ['action', 0, 1, 0, 2],
      ['action', 0, 1, 3, 5.5],
    ])
  })

  it('knows waits, until the flow goes on', () => {
    let past = new Past().with(
      run({}, { flow0: { order: 0, state: 'waiting', waits_since_s: 2 }, flow1: { order: 1, state: 'running' } }),
      APP,
    )
    expect(told(past)).toEqual([['wait', 0, 0, 2, NaN]])
    past = past.with(run({ 1: { began_s: 4.5 } }, { flow0: { order: 0, state: 'running', began_s: 4.5 } }), APP)
    expect(told(past)).toEqual([
      ['wait', 0, 0, 2, 4.5],
      ['action', 0, 1, 4.5, NaN],
    ])
  })

  it('an action ends where its flow came to stand still, and goes on anew when it is repeated', () => {
    const stop = { text: plain(''), kind: 'error', at_s: 3, subsystem: 'flow0', step: 1 }
    let past = new Past().with(
      run({ 1: { began_s: 1 } }, { flow0: { order: 0, state: 'stopped' } }, { stops: { flow0: stop } }),
      APP,
    )
    expect(past.blocks.map(({ to_s, isFault }) => [to_s, isFault])).toEqual([[3, true]])
    past = past.with(run({ 1: { began_s: 9 } }, { flow0: { order: 0, state: 'running' } }), APP)
    expect(past.blocks.map(({ from_s, to_s, isFault }) => [from_s, to_s, isFault])).toEqual([
      [1, 3, true],
      [9, NaN, false],
    ])
  })

  it('nothing is open once the run is over', () => {
    let past = new Past().with(
      run({ 1: { began_s: 1 } }, { flow1: { order: 1, state: 'waiting', waits_since_s: 2 } }),
      APP,
    )
    past = past.with(
      run(
        { 1: { began_s: 1 } },
        { flow1: { order: 1, state: 'waiting', waits_since_s: 2 } },
        { state: 'over', took_s: 6 },
      ),
      APP,
    )
    expect(told(past)).toEqual([
      ['action', 0, 1, 1, 6],
      ['wait', 1, 0, 2, 6],
    ])
  })

  it('begins anew with another run, and outlives the closing of its application', () => {
    const past = new Past().with(run({ 4: { began_s: 1 } }), APP)
    expect(told(past.with(run({ 4: { state: 'done', began_s: 1, took_s: 1 } }), undefined))).toEqual([
      ['action', 1, 4, 1, 2],
    ])
    expect(past.with(run({}, {}, { number: 2 }), APP).blocks).toEqual([])
  })
})

describe('the time line', () => {
  const block = (from_s: number, to_s: number, more: Partial<Block> = {}): Block => ({
    key: `${from_s}`,
    kind: 'action',
    flow: 0,
    step: 1,
    from_s,
    to_s,
    isFault: false,
    ...more,
  })

  it('shows the last seconds of a run that goes on, and all of one that is over', () => {
    expect(windowOf(1, false)).toEqual([0, 4])
    expect(windowOf(40, false)).toEqual([26, 40])
    expect(windowOf(40, true)).toEqual([0, 40])
  })

  it('lays blocks along it, cut at its ends', () => {
    const found = bars([block(0, 5), block(8, 12), block(15, NaN), block(16, 17, { flow: 1 })], 0, [10, 20], 100, 18)
    expect(found.map(({ x, width, isNow }) => [x, width, isNow])).toEqual([
      [0, 18, false],
      [50, 28, true],
    ])
  })

  it('a moment is still to be seen, but has no room for a picture', () => {
    const [bar] = bars([block(10, 10.01)], 0, [0, 20], 100, 20)
    expect([bar!.width, bar!.hasRoom]).toEqual([3, false])
  })

  it('moments stand where they belong', () => expect(scale([10, 20], 200)(15)).toBe(100))

  it('ticks are round, and few', () => {
    expect(ticks([0, 4])).toEqual([0, 1, 2, 3, 4])
    expect(ticks([26, 40])).toEqual([30, 35, 40])
    for (const to_s of [0.1, 7, 33, 500, 90_000]) expect(ticks([0, to_s]).length).toBeLessThanOrEqual(26)
  })
})
