import { describe, expect, it } from 'vitest'
import type { ApplicationView, FaultView } from '../../src/api.gen'
import { faultsAt, faultsByStep, faultsOf } from '../../src/application/faults'

const app = (faults: FaultView[]): ApplicationView => ({
  name: 'play',
  order: 1,
  faults: Object.fromEntries(faults.map((one, k) => [String(k), one])),
})

describe('what is wrong with a step', () => {
  const play = app([
    { text: 'odd', level: 'warning', step: 2 },
    { text: 'far', step: 2 },
    { text: 'nowhere' },
    { text: 'gone', step: 3 },
  ])

  it('is told with what forbids a run first', () => {
    expect(faultsAt(play, 2).map((one) => one.text)).toEqual(['far', 'odd'])
    expect(faultsAt(play, 9)).toEqual([])
    expect(faultsAt(undefined, 2)).toEqual([])
  })

  it('stands at its step, and what stands nowhere at none', () => {
    expect([...faultsByStep(play)].map(([step, all]) => [step, all.map((one) => one.text)])).toEqual([
      [2, ['far', 'odd']],
      [3, ['gone']],
    ])
  })

  it('is listed as the steps are read, whatever came first; holes come before all', () => {
    const told = [
      { text: 'later', step: 3 },
      { text: 'first', step: 7 },
      { text: 'missing', step: 4 },
      { text: 'nowhere' },
    ]
    const read: ApplicationView = { ...app(told), flows: { 0: { steps: [7, 4, 3] } }, steps: { 4: { kind: 'hole' } } }
    expect(faultsOf(read).map((one) => one.text)).toEqual(['missing', 'nowhere', 'first', 'later'])
  })
})
