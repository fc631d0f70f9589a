// Law 18: what is not at its place is told of the workcells that an application drives.
import { describe, expect, it } from 'vitest'
import type { ApplicationView, RuntimeView } from '../../src/api.gen'
import { canBePutBack, displaced, moved } from '../../src/progress/displaced'

const held = { key: 'workcell.hand_holds', text: 'the hand holds the box' }
const app = { worlds: { flow0: ['cell'], flow1: ['cell', 'real'] } } as unknown as ApplicationView
const runtime = (away: RuntimeView['displaced']): RuntimeView => ({
  displaced: away,
  world_kinds: { cell: 'simulated', shed: 'simulated', real: 'real' },
})

describe('what is not at its place', () => {
  it('is told of each workcell that the application drives, and of no other', () => {
    expect(displaced(runtime({ cell: [held], shed: [held] }), app)).toEqual([held])
    expect(displaced(runtime({ shed: [held] }), app)).toEqual([])
    expect(displaced({}, undefined)).toEqual([])
  })

  it('is no arm that a run left elsewhere: only a forecast is told of that', () => {
    const elsewhere: RuntimeView = { ...runtime({}), moved: { cell: [held], shed: [held] } }
    expect(moved(elsewhere, app)).toEqual([held])
    expect(displaced(elsewhere, app)).toEqual([])
    expect(canBePutBack(elsewhere, app)).toBe(false)
  })

  it('can be put back where no real workcell is among them', () => {
    expect(canBePutBack(runtime({ cell: [held] }), app)).toBe(true)
    expect(canBePutBack(runtime({ cell: [held], real: [held] }), app)).toBe(false)
    expect(canBePutBack(runtime({ shed: [held] }), app)).toBe(false)
    expect(canBePutBack({}, app)).toBe(false)
  })
})
