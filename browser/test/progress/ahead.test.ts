// R-E07: what is still to come: breakpoints, and the flows that can be paused.
import { describe, expect, it } from 'vitest'
import type { ApplicationView, FlowRunView, RunView, StepView } from '../../src/api.gen'
import { isAction, nextBreakpoint, placeOf, stepsOfAction } from '../../src/progress/ahead'
import { canPause, flowsOf, stateOf } from '../../src/run/orders'
import { newFlowStates } from '../../src/progress/newFlowStates'
import { clockText } from '../../src/sentences/words'

const STEPS: Record<string, StepView> = {
  1: { role: 'job' },
  2: { role: 'target', is_joined: true },
  3: { role: 'nop' },
  4: { kind: 'branch' },
  5: { role: 'job', breaks: true, break_if: 'LAMP == 1' },
  6: { role: 'target', is_joined: true },
  7: { kind: 'hole', is_joined: true },
}
const FLOW = { steps: [1, 2, 3, 4, 5, 6, 7] }

describe('the next breakpoint', () => {
  it('is counted in actions from the one that is carried out', () => {
    expect(nextBreakpoint(FLOW, STEPS, 1)).toEqual({ step: 5, actions: 2, condition: 'LAMP == 1' })
    expect(nextBreakpoint(FLOW, STEPS, 5)).toEqual({ step: 5, actions: 0, condition: 'LAMP == 1' })
    expect(nextBreakpoint(FLOW, STEPS, 0)?.actions).toBe(3)
    expect(nextBreakpoint(FLOW, STEPS, 5, true)).toBeUndefined()
    expect(nextBreakpoint(FLOW, STEPS, 3, true)?.actions).toBe(1)
  })

  it('is none where none follows', () => {
    expect(nextBreakpoint(FLOW, { ...STEPS, 5: { role: 'job' } }, 1)).toBeUndefined()
    expect(nextBreakpoint(undefined, {}, 1)).toBeUndefined()
  })
})

describe('an action', () => {
  it('is an icon that is no target', () =>
    expect(Object.keys(STEPS).filter((step) => isAction(STEPS[step]!))).toEqual(['1', '3', '5']))

  it('has the steps that belong to it', () => {
    expect(stepsOfAction(FLOW, STEPS, 5)).toEqual([5, 6, 7])
    expect(stepsOfAction(FLOW, STEPS, 3)).toEqual([3])
    expect(stepsOfAction(FLOW, STEPS, 9)).toEqual([])
  })
})

describe('flows of a run', () => {
  const run = (flows: Record<string, Partial<FlowRunView>>): RunView => ({
    doc: 'a1',
    name: 'r',
    number: 1,
    flows: Object.fromEntries(Object.entries(flows).map(([name, flow], order) => [name, { order, ...flow }])),
  })

  it('stand in their order, nested ones left out', () => {
    expect(flowsOf(run({ b: { order: 1 }, a: { order: 0 }, c: { order: 2, is_nested: true } }))).toEqual(['a', 'b'])
    expect(flowsOf(null)).toEqual([])
  })

  it('can be paused while one of them goes on', () => {
    expect(canPause(run({ a: { state: 'running' }, b: { state: 'paused' } }))).toBe(true)
    expect(canPause(run({ a: { state: 'paused' }, b: { state: 'ended' } }))).toBe(false)
    expect(canPause(run({ a: { state: 'running', is_pausing: true }, b: { state: 'stopped' } }))).toBe(false)
  })
})

describe('the clock', () => {
  it('is written with tenths, and with hours where there are some', () => {
    expect([0, 8.84, 61, 3723.45].map(clockText)).toEqual(['00:00.0', '00:08.8', '01:01.0', '1:02:03.4'])
    expect(clockText(-1)).toBe('00:00.0')
  })
})

describe('where a flow is', () => {
  it('is what it says itself, and ready as long as it says nothing', () => {
    expect([stateOf({ order: 0, state: 'paused' }), stateOf({ order: 0 }), stateOf(undefined)]).toEqual([
      'paused',
      'ready',
      'ready',
    ])
  })
})

describe('where a waiting flow is', () => {
  const app: ApplicationView = {
    name: 'one',
    order: 1,
    flows: { 0: { steps: [1, 2, 3] } },
    steps: { 1: { synch_tag: 'a' }, 2: {}, 3: { synch_tag: 'a' } },
  }
  const at = (step: number, tag: string, state = 'waiting'): number => placeOf(app, { order: 0, step, tag }, state)

  it('is before the next action of its tag, also where that is the first of all', () => {
    expect([at(1, 'a'), at(0, 'a'), at(3, 'a')]).toEqual([3, 1, 1])
  })

  it('is where it was, where nothing has that tag or it does not wait', () => {
    expect([at(2, 'b'), at(2, 'a', 'running'), placeOf(undefined, { order: 0, step: 5, tag: 'a' }, 'waiting')]).toEqual(
      [2, 2, 5],
    )
  })
})

describe('what is said aloud', () => {
  const at = (state: string, more: Partial<RunView> = {}): RunView => ({
    doc: 'a1',
    name: 'r',
    number: 1,
    flows: { flow0: { order: 0, state } },
    ...more,
  })

  it('is that a flow has come to rest, once', () => {
    expect(newFlowStates(at('running'), at('paused')).map((flow) => flow.order)).toEqual([0])
    expect(newFlowStates(at('paused'), at('paused'))).toEqual([])
    expect(newFlowStates(at('paused'), at('running'))).toEqual([])
    expect(newFlowStates(at('paused'), at('paused', { number: 2 }))).toHaveLength(1)
    expect(newFlowStates(undefined, at('waiting'))).toHaveLength(1)
  })
})
