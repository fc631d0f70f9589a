import { describe, expect, it } from 'vitest'
import type { ApplicationView, FaultView } from '../../src/api.gen'
import { faultsAt, faultsByStep, faultsOf } from '../../src/application/faults'
import { plain } from '../../src/texts/say'

const app = (faults: FaultView[]): ApplicationView => ({
  name: 'play',
  order: 1,
  faults: Object.fromEntries(faults.map((one, k) => [String(k), one])),
})

describe('what is wrong with a step', () => {
  const play = app([
    { text: plain('odd'), level: 'warning', step: 2 },
    { text: plain('far'), step: 2 },
    { text: plain('nowhere') },
    { text: plain('gone'), step: 3 },
  ])

  it('is told with what forbids a run first', () => {
    expect(faultsAt(play, 2).map((one) => one.text.text)).toEqual(['far', 'odd'])
    expect(faultsAt(play, 9)).toEqual([])
    expect(faultsAt(undefined, 2)).toEqual([])
  })

  it('stands at its step, and what stands nowhere at none', () => {
    expect([...faultsByStep(play)].map(([step, all]) => [step, all.map((one) => one.text.text)])).toEqual([
      [2, ['far', 'odd']],
      [3, ['gone']],
    ])
  })

  it('is listed as the steps are read, whatever came first; holes come before all', () => {
    const told = [
      { text: plain('later'), step: 3 },
      { text: plain('first'), step: 7 },
      { text: plain('missing'), step: 4 },
      { text: plain('nowhere') },
    ]
    const read: ApplicationView = { ...app(told), flows: { 0: { steps: [7, 4, 3] } }, steps: { 4: { kind: 'hole' } } }
    expect(faultsOf(read).map((one) => one.text.text)).toEqual(['missing', 'nowhere', 'first', 'later'])
  })
})
