import { beforeEach, describe, expect, it } from 'vitest'
import { desk, fullTree } from '../../src/link/desk.svelte'
import { hindrance } from '../../src/act/hindering'

const documents = { c1: { name: 'lives', order: 0, connection: 'live' as const }, c2: { name: 'lies still', order: 1 } }
const review = { recording: { path: '/r.mcap', name: 'assemble' } }

describe('While a recording is looked at', () => {
  beforeEach(() => {
    desk.tree = fullTree({ documents, review })
  })

  it('nothing sets the robot in motion, and the way out is offered', () => {
    const why = hindrance({ t: 'Toggle', doc: 'c1', task: 'pd' })
    expect(why?.remedies.map((one) => one.act)).toEqual([{ t: 'CloseRecording' }])
    expect(hindrance({ t: 'Run', doc: 'a1' })).toBeDefined()
  })

  it('what lives is not changed; what only lies in a file may be', () => {
    expect(hindrance({ t: 'Remove', doc: 'c1', tasks: ['pd'] })).toBeDefined()
    expect(hindrance({ t: 'Remove', doc: 'c2', tasks: ['pd'] })).toBeUndefined()
  })

  it('Stop works, and so does all that has to do with the recording', () => {
    for (const act of [{ t: 'Stop' }, { t: 'Glance', at_s: 1 }, { t: 'CloseRecording' }, { t: 'Continue', at_s: 1 }] as const) expect(hindrance(act)).toBeUndefined()
  })

  it('without one nothing is in the way', () => {
    desk.tree = fullTree({ documents })
    expect(hindrance({ t: 'Toggle', doc: 'c1', task: 'pd' })).toBeUndefined()
  })
})
