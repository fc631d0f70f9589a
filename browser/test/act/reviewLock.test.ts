import { beforeEach, describe, expect, it } from 'vitest'
import { desk, fullTree } from '../../src/link/desk.svelte'
import { reviewLock } from '../../src/act/reviewLock'

const documents = { c1: { name: 'lives', order: 0, connection: 'live' as const }, c2: { name: 'lies still', order: 1 } }
const review = { recording: { path: '/r.mcap', name: 'assemble' } }

describe('While a recording is looked at', () => {
  beforeEach(() => {
    desk.tree = fullTree({ documents, review })
  })

  it('nothing sets the robot in motion, and the way out is offered', () => {
    const why = reviewLock({ t: 'Toggle', doc: 'c1', task: 'pd' })
    expect(why?.remedies.map((one) => one.act)).toEqual([{ t: 'CloseRecording' }])
    expect(reviewLock({ t: 'Run', doc: 'a1' })).toBeDefined()
  })

  it('what lives is not changed; what only lies in a file may be', () => {
    expect(reviewLock({ t: 'Remove', doc: 'c1', tasks: ['pd'] })).toBeDefined()
    expect(reviewLock({ t: 'Remove', doc: 'c2', tasks: ['pd'] })).toBeUndefined()
  })

  it('Stop works, and so does all that has to do with the recording', () => {
    for (const act of [
      { t: 'Stop' },
      { t: 'Glance', at_s: 1 },
      { t: 'CloseRecording' },
      { t: 'Continue', at_s: 1 },
    ] as const)
      expect(reviewLock(act)).toBeUndefined()
  })

  it('without one nothing is in the way', () => {
    desk.tree = fullTree({ documents })
    expect(reviewLock({ t: 'Toggle', doc: 'c1', task: 'pd' })).toBeUndefined()
  })
})
