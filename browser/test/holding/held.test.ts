// Who holds what, as the panel lists it.
import { describe, expect, it } from 'vitest'
import type { DocumentView, RuntimeView } from '../../src/api.gen'
import { cannotTake, heldBy, heldIn, left, silence, takenAsks } from '../../src/holding/held'
import type { Reason } from '../../src/texts/say'

const sessions: RuntimeView['sessions'] = { 'ann#1': { role: 'owner', is_you: true }, 'bob#2': { role: 'viewer' } }
const doc = (more: Partial<DocumentView>): DocumentView => ({ name: 'x', order: 0, connection: 'live', ...more })

describe('who holds what', () => {
  it('lists an application once, with all its flows and the states that they are in', () => {
    const holds = {
      flow0: { application: 'play', holder: 'bob#2', state: 'paused' },
      main: { holder: 'ann#1' },
      flow1: { application: 'play', holder: 'bob#2', state: 'done' },
    }
    const all = heldIn({ sessions, holds }, {}, [])
    expect(all.map((one) => [one.name, one.subsystems, one.isMine])).toEqual([
      ['play', ['flow0', 'flow1'], false],
      ['main', ['main'], true],
    ])
    expect(all[0]?.states).toEqual(['paused', 'done'])
    expect(heldBy(all, 'bob#2')).toEqual(['play'])
  })
  it('keeps the own run apart from one of the same name', () => {
    const holds = { flow0: { application: 'play' }, other: { application: 'play' } }
    expect(heldIn({ sessions, holds }, {}, ['flow0']).map((one) => one.isOwnRun)).toEqual([true, false])
  })
  it('knows the configuration that is connected with a subsystem', () => {
    const documents = {
      c1: doc({ subsystem: 'main', connection: 'lost' }),
      c2: doc({ subsystem: 'main', is_held_here: true }),
    }
    expect(heldIn({ holds: { main: { holder: 'x#1' } } }, documents, [])[0]).toMatchObject({ doc: 'c2', isMine: true })
  })
  it('holds nothing to be mine before it is told who I am', () => {
    const [one] = heldIn({ holds: { main: {} } }, {}, [])
    expect(one).toMatchObject({ isMine: false, isOfferedHere: false, holder: '' })
  })
})

it('nothing is handed over to who is away, has promised to watch, or may only look', () => {
  expect(
    [
      { role: 'owner', is_here: false },
      { role: 'owner', only_watches: true },
      { role: 'viewer' },
      { role: 'operator' },
    ].map(cannotTake),
  ).toEqual(['away', 'watches', 'viewer', ''])
})

it('the time that is left is told in minutes and seconds, and never below nothing', () => {
  expect([left(100, 40), left(100, 99.2), left(100, 130)]).toEqual(['1:00', '0:01', '0:00'])
})

it('a loss says for how long nothing was heard, if that was the reason', () => {
  const cause = (key: string, args = {}): Reason => ({ key, text: 'it is lost', args: { session: 'ann#1', ...args } })
  expect([silence(cause('host.holder_silent', { seconds: 1.2 })), silence(cause('host.holder_gone'))]).toEqual([
    '1.20',
    '',
  ])
})

it('what a run asks is for here only if it is held here and was begun elsewhere', () => {
  const ask = { items: [] }
  const run = { application: 'play', holder: 'ann#1', asks: { servo: ask } }
  const holds = {
    flow0: run,
    flow1: { ...run, asks: {} },
    own: { ...run, application: 'mine' },
    far: { ...run, holder: 'bob#2' },
  }
  const all = heldIn({ sessions, holds }, {}, ['own'])
  expect(all.map((one) => Object.keys(one.asks))).toEqual([['flow0/servo'], ['own/servo'], ['far/servo']])
  expect(takenAsks(all)).toEqual({ 'flow0/servo': ask })
})
