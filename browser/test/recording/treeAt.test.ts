import { describe, expect, it } from 'vitest'
import type { InstantView } from '../../src/api.gen'
import { fullTree } from '../../src/link/desk.svelte'
import { treeAt, type Then } from '../../src/recording/treeAt'
import { plain } from '../../src/texts/say'

const run = { doc: 'a1', name: 'assemble', number: 3 }
const live = fullTree({
  run: { doc: 'a9', name: 'what runs now', number: 8, state: 'running' },
  runtime: { state: 'linked', worlds: { now: true } },
  documents: {
    c1: {
      name: 'jmove',
      order: 0,
      connection: 'live',
      subsystem: 'now',
      tasks: {
        pd: { x: 1, y: 2, state: 'ERROR', error: { text: plain('too hot') } as never, note: plain('late') },
        grav: { x: 5, y: 6, state: 'ON' },
      },
      loci: {
        Q: { x: 0, y: 0, line: 'stale', writers: ['pd'] } as never,
        T: { x: 0, y: 0, line: 'live', writers: ['grav'] } as never,
      },
    },
    c2: { name: 'other', order: 1, connection: 'live', tasks: { pd: { x: 0, y: 0, state: 'ON' } } },
  },
})
const instant = (tasks: Record<string, string>): InstantView => ({ at_s: 1, run, tasks, homes: { c1: 'flow0' } })

describe('The tree at an instant', () => {
  it('there is what was at the instant, and nothing of what is so now', () => {
    const seen = treeAt(() => ({ instant: instant({ 'flow0/pd': 'ON', 'flow0/grav': 'OFF' }), worlds: ['cell'] }))(live)
    expect(seen.run).toBe(run)
    const { pd, grav } = seen.documents['c1']!.tasks!
    expect([pd!.state, pd!.error, pd!.note, grav!.state]).toEqual(['ON', undefined, undefined, 'OFF'])
    expect(Object.values(seen.documents['c1']!.loci!).map((locus) => locus.line)).toEqual(['live', 'idle'])
    expect(Object.keys(seen.runtime.worlds ?? {})).toEqual(['cell'])
    expect(pd!.x).toBe(1)
  })

  it('a configuration that had no part in the run is as if it were not connected', () => {
    const seen = treeAt(() => ({ instant: instant({ 'flow0/pd': 'ON' }), worlds: [] }))(live)
    expect([seen.documents['c2']!.connection, seen.documents['c2']!.tasks!['pd']!.state]).toEqual(['none', ''])
  })

  it('a task that does not live any more, or not yet, has no state', () => {
    const seen = treeAt(() => ({ instant: instant({ 'flow0/pd': 'KILLED' }), worlds: [] }))(live)
    expect(seen.documents['c1']!.tasks!['pd']!.state).toBe('')
  })

  it('what lived in the subsystems of the run is shown in the states of the instant', () => {
    const inside = {
      flow0: { application: 'assemble', tasks: { pd: { state: '' as const }, grav: { state: '' as const } } },
    }
    const seen = treeAt(() => ({ instant: instant({ 'flow0/pd': 'ON' }), worlds: [], inside }))(live)
    const { pd, grav } = seen.runtime.inside!['flow0']!.tasks!
    expect([pd!.state, grav!.state, Object.keys(seen.runtime.inside!)]).toEqual(['ON', '', ['flow0']])
  })

  it('before the first answer nothing is so', () => {
    const seen = treeAt(() => ({ instant: undefined, worlds: [] }))(live)
    expect(seen.run).toBeNull()
    expect(seen.documents['c1']!.tasks!['pd']!.state).toBe('')
  })

  it('an application is redirected as it was in that run, and bears no marks of what was found since', () => {
    const app = {
      name: 'assemble',
      order: 0,
      redirects: [{ old: 'puma', new: 'now' }],
      steps: { 2: { note: plain('found since'), name: 'there' } },
    }
    const tree = fullTree({ applications: { a1: app, a2: app } })
    const seen = treeAt(() => ({
      instant: undefined,
      worlds: [],
      doc: 'a1',
      redirects: [{ old: 'puma', new: 'scara' }],
    }))({ ...tree, applications: { a1: app, a2: { ...app } } })
    expect(seen.applications['a1']!.redirects).toEqual([{ old: 'puma', new: 'scara' }])
    expect([seen.applications['a1']!.steps!['2']!.note, seen.applications['a1']!.steps!['2']!.name]).toEqual([
      undefined,
      'there',
    ])
    expect(seen.applications['a2']!.redirects).toEqual([{ old: 'puma', new: 'now' }])
  })

  it('the runtime itself stays what it is, so that Stop works on the live robot', () => {
    expect(treeAt(() => ({ instant: undefined, worlds: [] }))(live).runtime.state).toBe('linked')
  })

  it('things stay the same things from one instant to the next: only what has changed is drawn anew', () => {
    let then: Then = { instant: instant({ 'flow0/pd': 'ON' }), worlds: [] }
    const look = treeAt(() => then)
    const [document, placed] = [look(live).documents['c1'], look(live).documents['c1']!.tasks!['pd']!]
    then = { instant: instant({ 'flow0/pd': 'WAITING' }), worlds: [] }
    expect(look(live).documents['c1']).toBe(document)
    expect(look(live).documents['c1']!.tasks!['pd']).toBe(placed)
    expect(placed.state).toBe('WAITING')
  })
})
