// R-X05: runs that are recorded, and the simulator in which one is gone on from.
import { describe, expect, it } from 'vitest'
import { anewWords, fileOf, isSimulator } from '../../src/progress/recording'

describe('a recording', () => {
  it('is called by its file', () => {
    expect(fileOf('/state/recordings/assemble-20261121-231500.mcap')).toBe('assemble-20261121-231500.mcap')
    expect(fileOf('')).toBe('')
  })
})

describe('the simulator', () => {
  it('is a runtime of our own in virtual time', () => {
    expect(isSimulator({ is_virtual: true })).toBe(true)
    expect(isSimulator({ is_virtual: true, address: 'ws://there' })).toBe(false)
    expect(isSimulator({})).toBe(false)
  })

  it('is left where any other runtime is started anew', () => {
    expect(anewWords({ is_virtual: true }).name).toBe('Leave the simulator')
    expect(anewWords({}).name).toBe('Put the workcell back')
  })
})
